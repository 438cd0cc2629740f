// Copyright 2026 The sTetro Authors
//
// Licensed under the Apache License, Version 2.0 (the "License");
// you may not use this file except in compliance with the License.
// You may obtain a copy of the License at
//
//     http://www.apache.org/licenses/LICENSE-2.0
//
// Unless required by applicable law or agreed to in writing, software
// distributed under the License is distributed on an "AS IS" BASIS,
// WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
// See the License for the specific language governing permissions and
// limitations under the License.

#ifndef EMULATOR__EMULATED_MECHANICS_HPP_
#define EMULATOR__EMULATED_MECHANICS_HPP_

#include <array>

#include "emulator/emulated_servo.hpp"
#include "linux/motion/chassis_config.hpp"
#include "linux/motion/twist_to_wheels.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver::emulator
{

/// What the motors of all servos are told at one time. Wheels that do not exist are told nothing.
struct ChassisDrives
{
  std::array<ServoDrive, linux_io::kWheels> wheels{};
  std::array<ServoDrive, linux_io::kPair> steering{};
  std::array<ServoDrive, linux_io::kPair> lifts{};
};

/// Where a shaft is, and how fast it turns.
struct Shaft
{
  double position_rad = 0.0;
  double speed_rad_s = 0.0;
};

/// The shafts of all servos.
struct ChassisShafts
{
  std::array<Shaft, linux_io::kWheels> wheels{};
  std::array<Shaft, linux_io::kPair> steering{};
  std::array<Shaft, linux_io::kPair> lifts{};
};

/// Wheels, steering and lifts between the servos and the body: the other end of each shaft.
/**
 * Wheels turn with the power of their servo. Lifts sit in block 2: one alone moves its outer block,
 * both together block 2. A lift that meets the ground or a lock stalls, one without torque lets its
 * block go, one that brakes keeps it. Without a clock: a tick is given its length.
 */
class EmulatedMechanics
{
public:
  explicit EmulatedMechanics(const linux_io::ChassisConfig & config);

  /// What the body is made to do in a tick.
  [[nodiscard]] SimActuation follow(
    const ChassisDrives & drives, const std::array<BlockReading, kBlocks> & blocks, double dt_s);

  /// Where the shafts are after a tick that ended with this.
  [[nodiscard]] const ChassisShafts & shafts_after(const SensorFrame & frame, double dt_s);

private:
  using Extensions = std::array<double, linux_io::kPair>;

  void steer(const ChassisDrives & drives, double dt_s);
  void roll(const ChassisDrives & drives, SimActuation & moved) const;
  [[nodiscard]] Extensions wanted_m(
    const ChassisDrives & drives, bool block2_stands, double dt_s) const;
  [[nodiscard]] double extension_m(std::size_t lift) const;

  linux_io::ChassisConfig config_;
  linux_io::TwistToWheels wheels_;
  double steering_rad_ = 0.0;
  ChassisShafts shafts_{};
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_MECHANICS_HPP_
