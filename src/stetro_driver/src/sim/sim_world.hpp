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

#ifndef SIM__SIM_WORLD_HPP_
#define SIM__SIM_WORLD_HPP_

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/building.hpp"
#include "sim/clutter.hpp"
#include "sim/fault_injector.hpp"
#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "sim/sim_contacts.hpp"
#include "sim/sim_gyro.hpp"
#include "sim/sim_lidar.hpp"
#include "sim/sim_lifts.hpp"
#include "sim/sim_ranges.hpp"
#include "sim/sim_wheels.hpp"
#include "sim/snapshot_file.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver
{

/// Of what World::archive() lists, and in which order. To be raised with every change of either.
constexpr std::uint32_t kStateLayout = 6;

/// A number that differs when anything differs that two worlds must share to share a snapshot.
[[nodiscard]] std::uint64_t identity_of(
  const BuildingShape & building, const BodyShape & body, const SimOptions & options,
  std::uint32_t layout = kStateLayout);

/// Building, body, wheels and sensors of one simulated robot, and the tick that moves them all.
/**
 * The body lives in the frame of one flight, the present one. On a floor it is handed over to the
 * flight at whose stairs it is: one exact change of frame, which no sensor of its own can feel.
 */
struct SimRobot::World
{
  World(const BuildingShape & building, const BodyShape & body, const SimOptions & options);

  /// One tick: faults, actuators, body, sensors. Stores the snapshot last.
  void tick();
  void tick(const SimActuation & moved);

  void open_snapshot();
  void hold();

  /// The drawn floor that base_link is on; kNoFloor on a flight, and on a floor without drawing.
  [[nodiscard]] std::size_t drawn_floor() const;

  [[nodiscard]] GroundTruth truth() const;
  [[nodiscard]] std::vector<std::uint8_t> state();

  /// Lists everything that the future depends on.
  template <class Archive>
  void archive(Archive & each)
  {
    each(ticks, time, present);
    body.archive(each);
    wheels.archive(each);
    gyro.archive(each);
    contacts.archive(each);
    ranges.archive(each);
    lifts.archive(each);
    faults.archive(each);
    kidnap_random.archive(each);
    if (lidar) {
      lidar->archive(each);
    }
    each(steering.angle_rad, steering.target_rad, old_tread_rolled_m, old_tread);
  }

  const SimOptions options;
  const BodyShape shape;
  const std::uint64_t identity;  // of the world, for snapshots
  const sim::Building building;
  std::size_t present;  // index of the flight in whose frame the body is
  sim::SimLifts lifts;
  sim::SimBody body;
  sim::SimWheels wheels;
  sim::SimGyro gyro;
  sim::SimContacts contacts;
  sim::SimRanges ranges;
  sim::FaultInjector faults;
  sim::RandomStream kidnap_random;
  std::optional<sim::Clutter> clutter{};
  std::optional<sim::SimLidar> lidar{};

  bool configured = false;
  bool active = false;
  std::atomic<bool> safe{false};
  JointCommand command{};
  SteeringReading steering{};
  std::array<bool, kBlocks> lift_moved{};
  std::uint64_t ticks = 0;
  Time time;
  bool old_tread = false;  // the fault of that name is under way
  double old_tread_rolled_m = 0.0;
  SensorFrame frame{};
  std::unique_ptr<sim::SnapshotFile> snapshot{};
  ResumeOutcome resume_outcome = ResumeOutcome::kFresh;
  std::string resume_detail{};

private:
  [[nodiscard]] bool resume(const std::vector<std::uint8_t> & bytes);
  void note_driving();
  void strike_faults();
  void begin_tick();
  void end_tick(const sim::WheelSpeeds & told);
  [[nodiscard]] sim::WheelSpeeds actuate();
  [[nodiscard]] sim::WheelSpeeds actuate(const SimActuation & moved);
  void lift(int block, double up_m);
  void move(const sim::WheelSpeeds & told);
  void slip_onto_old_tread(const sim::WheelSpeeds & told);
  void measure(double yaw_rate_rad_s);
  void compose_frame();
  void put_at_start(const StairShape & stairs);
  void surround();
  void settle();
  void kidnap(double to_the_left_m);
  void kidnap_on_floor(std::size_t floor);
  [[nodiscard]] std::size_t floor_under() const;
  [[nodiscard]] stetro_site::Pose pose_in_map() const;
  void describe_treads(GroundTruth & truth) const;

  std::vector<std::uint8_t> stored_{};
};

}  // namespace stetro_driver

#endif  // SIM__SIM_WORLD_HPP_
