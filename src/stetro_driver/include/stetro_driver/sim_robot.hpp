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

#ifndef STETRO_DRIVER__SIM_ROBOT_HPP_
#define STETRO_DRIVER__SIM_ROBOT_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/building_shape.hpp"
#include "stetro_driver/hardware_interface.hpp"
#include "stetro_driver/sim_errors.hpp"
#include "stetro_driver/sim_faults.hpp"
#include "stetro_driver/simulated_world.hpp"
#include "stetro_driver/stair_shape.hpp"

namespace stetro_driver
{

/// Where base_link starts, seen from above, in the frame of the flight the robot starts at.
struct SimStart
{
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// How the simulation is set up. What the software believes (the site file) is not among it.
struct SimOptions
{
  std::uint64_t seed = 1;  ///< of the world, the sensors and the start
  bool as_built = true;    ///< the stairs differ from their shape as errors say; false: exactly it
  SimErrors errors{};
  std::vector<SimFault> faults{};
  std::optional<SimStart> start{};  ///< nothing: middle of the floor, about 0.5 m before the stairs
  bool lidar = false;               ///< somebody wants its scans
  int people = 0;                   ///< walking on each floor with walls, seen by the lidar only
  int unmapped_boxes = 0;           ///< on each floor with walls, seen by the lidar only
  bool ranges_at_once = false;      ///< measured each tick, without latency: devices have their own
  std::string snapshot_path{};      ///< empty: no snapshot
  Time origin = std::chrono::seconds{1000};  ///< simulated time starts here, well above zero
};

/// What wheels, lifts and steering did in one tick, moved by motors that are not the simulation's.
struct SimActuation
{
  double vx_m_s = 0.0;  ///< at which the wheels turned, in base_link
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;
  std::array<double, kBlocks> lifted_m{};  ///< each block against its neighbours, upwards positive
  double steering_rad = 0.0;               ///< where the wheels point
};

/// The simulated robot in its simulated world.
/**
 * Deterministic: the same options give the same bits. It has no clock: each step() is one tick of
 * simulated time. A tick moves the actuators as the last write() says, the body as its surroundings
 * allow, then reads the sensors: gyro, wheels, switches and lifts each tick, ranges at 30 Hz and
 * 20 ms late, the lidar if it is wanted. With a snapshot path the world is stored after each tick,
 * before anyone is told.
 */
class SimRobot final : public HardwareInterface, public SteppedWorld
{
public:
  /// \throws std::invalid_argument when the robot does not fit where it starts, or a shape is empty
  SimRobot(const BuildingShape & building, const BodyShape & body, const SimOptions & options);

  /// On one flight, of whose floors nothing is known.
  SimRobot(const StairShape & stairs, const BodyShape & body, const SimOptions & options);
  ~SimRobot() override;

  void configure() override;  ///< opens the snapshot and resumes it \throws HardwareError
  void activate() override;
  void deactivate() override;
  void reset_emergency_stop() override;
  Result<SensorFrame> read(Time now) override;  ///< now must be time()
  std::optional<IoFault> write(const JointCommand & command) override;
  void make_safe() noexcept override;

  void step() override;  ///< only after configure()

  /// One tick in which the body is moved by other motors than those that write() commands.
  void step(const SimActuation & moved);

  [[nodiscard]] Time time() const override;
  [[nodiscard]] GroundTruth truth() const override;

  [[nodiscard]] ResumeOutcome resume_outcome() const override;
  [[nodiscard]] const std::string & resume_detail() const override;

  /// Everything that the future depends on, as bytes: equal bytes, equal future.
  [[nodiscard]] std::vector<std::uint8_t> state() const;

private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SIM_ROBOT_HPP_
