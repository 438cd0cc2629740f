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

#ifndef STETRO_SUPERVISOR__FLOOR__DRIVE_SITUATION_HPP_
#define STETRO_SUPERVISOR__FLOOR__DRIVE_SITUATION_HPP_

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_site/robot_geometry.hpp"
#include "stetro_supervisor/climb_params.hpp"
#include "stetro_supervisor/climb_state.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/drive_state.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"
#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/observation.hpp"
#include "stetro_supervisor/situation.hpp"

namespace stetro_supervisor
{

/// What a drive over a floor is for.
struct Errand
{
  std::shared_ptr<const DrawnFloor> floor;           ///< that it is on
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();  ///< of base_link, in the floor's frame
  std::optional<double> yaw_rad;                     ///< to face at the goal; nothing: any
  /// Straight to the goal without a look at the map, and slowly: off the stairs, where the map has
  /// a wall about them.
  bool straight = false;
  /// The segment that the localizer shall tell the pose on, at the goal; empty: any.
  std::string hand_over_to;
};

/// What the drive knows of the pose.
struct DrivePose
{
  std::optional<FloorPlace> place;  ///< on the errand's floor, if it may be used
  std::string doubt;                ///< why it may not, in words
};

/// What the drive remembers between ticks.
struct DriveMemory
{
  Errand errand;
  std::vector<Eigen::Vector2d> corners_m;    ///< of the way, the first behind the robot
  std::size_t leg = 0;                       ///< the corner that is driven to
  std::string no_way;                        ///< why there is no way, if there is none
  std::vector<Eigen::Vector2d> obstacles_m;  ///< that were seen in the way, in the floor's frame
  std::int64_t replans = 0;                  ///< around obstacles
  Asked asked = Asked::kNothing;
  Fault fault = Fault::kNone;
  std::string note;
  std::optional<Time> obstructed_since;  ///< something is seen ahead
  std::optional<Time> free_since;        ///< nothing has been in the way
  std::optional<Time> sound_since;       ///< the pose has been usable
  std::optional<Time> refused_since;
  std::optional<std::uint64_t> driver_instance;
  bool driver_changed = false;
  bool clock_went_back = false;
};

/// All that guards, commands and effects of a drive may look at. Lives for one tick.
struct DriveSituation
{
  const FloorParams & params;
  const ClimbParams & limits;  ///< silence, refusals and steering are the same as on stairs
  const stetro_site::RobotGeometry & robot;
  const Observation & seen;
  const DrivePose & pose;
  const DriveMemory & memory;
  DriveState state;
  Time now;
  Time entered;

  [[nodiscard]] double in_state_s() const { return seconds_between(entered, now); }
  [[nodiscard]] bool has_leg() const { return memory.leg < memory.corners_m.size(); }
  [[nodiscard]] bool on_last_leg() const { return memory.leg + 1 == memory.corners_m.size(); }

  /// From the robot to the end of its leg along the leg; less than 0 beyond it [m].
  [[nodiscard]] double rest_m() const;
  /// From the leg's line, to the left of it [m].
  [[nodiscard]] double cross_track_m() const;
  /// To turn until the robot faces the end of its leg, CCW positive [rad].
  [[nodiscard]] double to_leg_rad() const;
  /// To turn until it faces along the leg [rad].
  [[nodiscard]] double off_leg_rad() const;
  /// To turn until it faces as the errand asks; 0 where it asks nothing [rad].
  [[nodiscard]] double to_goal_heading_rad() const;
  /// What the next turn is for: the leg, or at the goal the errand's heading [rad].
  [[nodiscard]] double to_turn_rad() const;
  /// All legs are driven.
  [[nodiscard]] bool at_goal() const;
  /// The localizer tells the pose on the segment that the errand asks for.
  [[nodiscard]] bool is_handed_over() const;

  /// From the body's face to the nearest thing in its way, by ranges and lidar; +inf if none [m].
  [[nodiscard]] double way_free_m() const;
  /// Something is nearer than the stop distance, and on this side of the leg's end.
  [[nodiscard]] bool sees_obstacle() const;
  /// It has been seen for longer than a stray reading of a range sensor lasts.
  [[nodiscard]] bool is_obstructed() const;
  [[nodiscard]] bool bumps() const;  ///< any bumper or riser switch is closed

  [[nodiscard]] bool steering_at(double angle_rad) const;
};

/// Where the lidar sees something, in the floor's frame, nearer than `within_m`.
[[nodiscard]] std::vector<Eigen::Vector2d> points_seen(
  const Scan & scan, const FloorPlace & place, const stetro_site::Lidar & lidar, double within_m);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__DRIVE_SITUATION_HPP_
