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

#ifndef STETRO_SUPERVISOR__JOURNEY_HPP_
#define STETRO_SUPERVISOR__JOURNEY_HPP_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_site/robot_geometry.hpp"
#include "stetro_site/site.hpp"
#include "stetro_supervisor/climb.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/floor_check.hpp"
#include "stetro_supervisor/floor/floor_drive.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"
#include "stetro_supervisor/floor/route.hpp"

namespace stetro_supervisor
{

/// What a journey is doing.
/**
 *   Still    --(go)--> RollOff, ToFoot or Climb, by where the robot is
 *   ToFoot   --(at the foot, and the localizer on the flight)--> Climb; Done, if that was the goal
 *   Climb    --(on the last tread, the front free)--> RollOff
 *   RollOff  --(off the stairs, and the localizer on the floor)--> ToFoot of the next flight, or
 *              Done on the floor that was the goal
 *   ToFoot, RollOff, and Climb before its first step
 *            --(waits for the pose, and the localizer has found another on a floor)--> as by go
 *   ToFoot, RollOff, and Climb before its first step
 *            --(the same, and there is no way to the goal from there)--> Aborted
 *   any      --(aborted)--> Aborted
 *
 * Still is the climb alone, as without a journey. Standing, waiting and faults are states of the
 * climb or of the drive, whichever is at the wheel.
 */
enum class Part { kStill, kToFoot, kClimb, kRollOff, kDone, kAborted };

/// The robot's way through its building: drives over floors, climbs flights, doubts the pose.
/**
 * It owns a climb for every flight of the site, of which one is present: the one that is cleaned,
 * or the one the robot is on. On a site whose floors nobody has drawn it is nothing but that climb.
 *
 * One tick, one command. Reads no clock. Not thread-safe.
 */
class Journey
{
public:
  /**
   * \param flight id of the flight that is present at first
   * \throws std::invalid_argument naming what cannot be climbed, see `check_climbable`
   */
  Journey(
    const stetro_site::Site & site, const stetro_site::RobotGeometry & robot,
    const ClimbParams & climb, const FloorParams & floor, const std::string & flight);

  /// Takes up a mission that was under way when the process ended: held until a resume request.
  /** The record must fit, see `fits`. */
  void restore(const MissionRecord & record);

  /// Why a record is not one of this site; empty if it is.
  [[nodiscard]] std::string misfit(const MissionRecord & record) const;

  /// One step: what the robot shall do until the next.
  MotionCommand tick(Time now, const Observation & seen);

  /// The flight that is present from now on. Only while nothing is under way.
  void select(const std::string & flight);

  /// The present climb has been started by itself: it is no part of a journey.
  void clean();

  /// Why there is no going to a segment from here; empty if there is.
  [[nodiscard]] std::string refuse_to_go(const std::string & goal) const;

  /// Goes there, with the next tick. It must not be refused.
  void go(const std::string & request_id, const std::string & issuer, const std::string & goal);

  /// Why the pose cannot be checked now; empty if it can.
  [[nodiscard]] std::string refuse_check() const;

  /// Checks the pose by the next scan that can be used. It must not be refused.
  void check_pose() { check_->request(); }

  /// Goes on with a drive that was held or paused.
  void resume_drive();

  [[nodiscard]] Climb & climb() { return *climbs_.at(flight_); }
  [[nodiscard]] const Climb & climb() const { return *climbs_.at(flight_); }
  [[nodiscard]] const stetro_site::Flight & flight() const { return site_.flight(flight_); }
  [[nodiscard]] FloorDrive & drive() { return drive_; }
  [[nodiscard]] const FloorDrive & drive() const { return drive_; }
  [[nodiscard]] const stetro_site::Site & site() const { return site_; }

  [[nodiscard]] Part part() const { return part_; }
  /// The drive is at the wheel, or was when the journey ended.
  [[nodiscard]] bool drives() const { return part_ != Part::kStill && part_ != Part::kClimb; }
  [[nodiscard]] bool is_free() const;  ///< nothing is under way
  /// The segment that the robot works on; a floor while the drive is at the wheel.
  [[nodiscard]] std::string segment() const;
  [[nodiscard]] const std::string & goal() const { return goal_; }
  [[nodiscard]] bool knows_floors() const { return !floors_.empty(); }

  /// What a restart must know.
  [[nodiscard]] MissionRecord record() const;

  /// A floor that the robot may be on; null if nobody has drawn it.
  [[nodiscard]] const DrawnFloor * drawn_floor(const std::string & id) const;

  /// In words what changed in the last tick; empty if nothing did.
  [[nodiscard]] const std::string & transition() const { return told_; }
  [[nodiscard]] bool has_fault() const;

  /// Why the pose may not be used on a floor, in words; empty if it may.
  [[nodiscard]] std::string pose_doubt() const;

  /// What the second opinion told in the last tick.
  [[nodiscard]] const std::optional<CheckReport> & check_report() const { return check_->report(); }

private:
  void take_pose();
  [[nodiscard]] DrivePose drive_pose() const;
  [[nodiscard]] CheckContext context() const;
  [[nodiscard]] bool has_recent_scan() const;
  [[nodiscard]] bool is_drawn_floor(const std::string & id) const { return floors_.count(id) != 0; }
  [[nodiscard]] const stetro_site::Flight * flight_to_leave(const FloorPlace & place) const;

  [[nodiscard]] bool waits_before_stairs() const;
  [[nodiscard]] bool is_elsewhere() const;
  void watch_whereabouts();
  void start(const Errand & errand);
  void set_out();
  void go_on();
  void give_up(const std::string & why);
  void drive_to_foot(const stetro_site::Flight & flight);
  void roll_off(const stetro_site::Flight & flight);
  void arrive();
  void begin_climb(int step);
  void tell(const std::string & what);
  void follow_drive();
  void follow_climb();

  stetro_site::Site site_;
  stetro_site::RobotGeometry robot_;
  ClimbParams limits_;
  FloorParams params_;
  std::map<std::string, std::unique_ptr<Climb>> climbs_;
  std::map<std::string, std::shared_ptr<const DrawnFloor>> floors_;
  std::unique_ptr<FloorCheck> check_;
  FloorDrive drive_;

  std::string flight_;  // that is present
  Part part_ = Part::kStill;
  std::string goal_;
  std::string request_id_;
  std::string issuer_;
  std::string floor_;                    // that is driven on
  bool stray_ = false;                   // held after a restart: the errand is to be found anew
  std::uint32_t errand_resets_ = 0;      // of the pose with which the errand began
  std::optional<Time> elsewhere_since_;  // it waits, and a sound pose is another one
  std::string told_;                     // what changed in the last tick

  Time now_{0};
  Observation seen_;
  std::optional<FloorPlace> place_;  // of the localizer's pose, good or not
  bool moving_ = false;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__JOURNEY_HPP_
