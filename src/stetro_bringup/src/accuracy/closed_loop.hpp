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

#ifndef ACCURACY__CLOSED_LOOP_HPP_
#define ACCURACY__CLOSED_LOOP_HPP_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/robot_setup.hpp"
#include "accuracy/truth_ring.hpp"
#include "stetro_driver/command_gate.hpp"
#include "stetro_driver/sim_robot.hpp"
#include "stetro_localizer/segment_estimator.hpp"
#include "stetro_supervisor/mission.hpp"

namespace stetro_bringup
{

/// How a climb ended.
enum class ClimbEnd {
  kRunning,   ///< it has not
  kFinished,  ///< the supervisor swept the last tread
  kFault,     ///< the supervisor stopped for good
  kHeld,      ///< it stood and waited for too long: for the pose, or for a person
  kTooLong,   ///< it went on beyond all patience
  kRefused,   ///< no climb was ever accepted
  kFallen,    ///< the robot fell off its stairs
};

/// A word for a report, such as "finished".
[[nodiscard]] const char * to_string(ClimbEnd end);

/// Simulated robot, estimators and supervisor, wired core to core: one climb, no middleware.
/**
 * One tick does what the three nodes of one process do between two clock messages, in their order:
 * the command in force moves the robot, its sensors reach the estimators (odometry, gyro, contacts,
 * blocks, ranges), these their timer at 10 Hz, then the supervisor at 20 Hz, whose command passes
 * the driver's gate and acts from the next tick on. Rates and stamps are the driver's: odometry and
 * gyro at 100 Hz, contacts when they change and at 10 Hz, blocks and ranges at 30 Hz.
 *
 * The first estimator drives, the others listen. None is told anything of the truth. There is no
 * clock and no randomness but the seed's: the same setup gives the same climb, bit by bit.
 */
class ClosedLoop
{
public:
  /// \param setup outlives the loop
  /// \param estimators at least one; the first drives
  /// \throws std::invalid_argument for an estimator that does not exist
  ClosedLoop(
    const RobotSetup & setup, const stetro_driver::SimOptions & sim,
    const std::vector<std::string> & estimators);

  /// One tick of simulated time, 10 ms. Only while end() is kRunning.
  void tick();

  [[nodiscard]] ClimbEnd end() const { return end_; }
  /// Why the robot stands, in words; empty when it finished.
  [[nodiscard]] std::string detail() const;

  [[nodiscard]] stetro_driver::Time time() const { return robot_.time(); }
  [[nodiscard]] double elapsed_s() const;  ///< simulated, since the start
  [[nodiscard]] stetro_driver::GroundTruth truth() const { return robot_.truth(); }
  [[nodiscard]] const TruthRing & truths() const { return truths_; }
  [[nodiscard]] const stetro_supervisor::Climb & climb() const { return climb_; }
  [[nodiscard]] bool accepted() const { return accepted_; }  ///< the climb is under way

  [[nodiscard]] std::size_t estimators() const { return listeners_.size(); }
  [[nodiscard]] const stetro_localizer::Estimator & estimator(std::size_t i) const
  {
    return *listeners_[i].estimator;
  }
  /// Whether the last tick gave this estimator a new estimate.
  [[nodiscard]] bool refreshed(std::size_t i) const { return listeners_[i].refreshed; }

private:
  struct Listener
  {
    std::unique_ptr<stetro_localizer::Estimator> estimator;
    bool refreshed = false;
  };

  void move();
  void sense(Listener & listener);
  void observe();
  void command();
  void ask();
  void judge_end();
  [[nodiscard]] bool contacts_due();
  [[nodiscard]] bool every(std::uint64_t ticks) const { return ticks_ % ticks == 0; }
  [[nodiscard]] stetro_driver::GateSituation situation() const;

  const RobotSetup & setup_;
  stetro_driver::SimRobot robot_;
  stetro_driver::CommandGate gate_;
  std::vector<Listener> listeners_;
  stetro_supervisor::Climb climb_;
  stetro_supervisor::Mission mission_;
  stetro_supervisor::Observation seen_;
  TruthRing truths_;

  stetro_driver::SensorFrame frame_{};
  std::array<stetro_driver::ContactReading, stetro_driver::kContactPlaces> last_contacts_{};
  stetro_driver::Time contacts_sent_{0};
  bool contacts_now_ = false;  ///< this tick's frame carries contacts
  bool pose_now_ = false;      ///< the driving estimator has published in this tick
  bool accepted_ = false;
  std::string refusal_;
  std::uint64_t ticks_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint64_t requests_ = 0;
  std::optional<stetro_driver::Time> standing_since_;
  ClimbEnd end_ = ClimbEnd::kRunning;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__CLOSED_LOOP_HPP_
