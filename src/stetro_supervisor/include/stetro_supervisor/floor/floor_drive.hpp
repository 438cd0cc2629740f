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

#ifndef STETRO_SUPERVISOR__FLOOR__FLOOR_DRIVE_HPP_
#define STETRO_SUPERVISOR__FLOOR__FLOOR_DRIVE_HPP_

#include <optional>
#include <string>

#include "stetro_supervisor/floor/drive_table.hpp"
#include "stetro_supervisor/motion_command.hpp"

namespace stetro_supervisor
{

/// A change of state, for the log.
struct DriveTransition
{
  DriveState from;
  DriveState to;
  std::string why;
};

/// Drives errands over a floor: walks `drive_table()`, plans when it says so.
/**
 * One tick, at most one transition, one command. Reads no clock. Not thread-safe.
 */
class FloorDrive
{
public:
  FloorDrive(
    const FloorParams & params, const ClimbParams & limits,
    const stetro_site::RobotGeometry & robot);

  /// Begins with the next tick. \throws std::invalid_argument if the errand has no floor
  void start(const Errand & errand);

  /// Takes an errand up that was under way when the process ended: held until a resume request.
  void restore(const std::string & note);

  /// What an operator asks, for the next tick alone.
  void ask(Asked asked) { memory_.asked = asked; }
  [[nodiscard]] bool is_asked() const { return memory_.asked != Asked::kNothing; }

  /// One step: what the robot shall do until the next.
  MotionCommand tick(Time now, const Observation & seen, const DrivePose & pose);

  [[nodiscard]] DriveState state() const { return state_; }
  [[nodiscard]] Fault fault() const { return memory_.fault; }
  [[nodiscard]] const std::string & note() const { return memory_.note; }
  [[nodiscard]] const DriveMemory & memory() const { return memory_; }
  [[nodiscard]] double time_in_state_s() const { return seconds_between(entered_, now_); }
  [[nodiscard]] double time_limit_s() const;  ///< of the state; +inf where there is none [s]

  /// Of the last tick, if there was one.
  [[nodiscard]] const std::optional<DriveTransition> & transition() const { return transition_; }

private:
  [[nodiscard]] DriveSituation situation() const;
  void watch();
  const DriveExit * first_open(const DriveSituation & s) const;
  void enter(const DriveExit & exit, const DriveSituation & s, const std::string & why);
  [[nodiscard]] bool is_planned() const;
  void plan();

  FloorParams params_;
  ClimbParams limits_;
  stetro_site::RobotGeometry robot_;
  double clearance_m_;  // of the circle about the body, with its margin
  DriveMemory memory_;
  Observation seen_;
  DrivePose pose_;
  DriveState state_ = DriveState::kIdle;
  bool started_ = false;
  Time now_{0};
  Time entered_{0};
  std::optional<DriveTransition> transition_;
};

/// The circle about base_link that holds the body and its bumpers, however it turns [m].
[[nodiscard]] double body_radius_m(const stetro_site::RobotGeometry & robot);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__FLOOR_DRIVE_HPP_
