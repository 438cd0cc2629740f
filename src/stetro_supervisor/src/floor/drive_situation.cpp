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

#include "stetro_supervisor/floor/drive_situation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/floor/profile_witness.hpp"
#include "stetro_supervisor/robot_health.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::wrap_angle;

constexpr double kBesideBody_m = 0.04;  // the way is the body's width and this to either side
constexpr double kBeyondLeg_m = 0.08;   // what stands farther beyond its end is not in the way
constexpr double kRecentScan_s = 0.3;
constexpr double kStray_s = 0.12;  // three readings of a range sensor in a row are no stray ones
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double bearing(const Eigen::Vector2d & from, const Eigen::Vector2d & to)
{
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

bool closed(const Contact & contact)
{
  return contact.state == ContactState::kClosed && !contact.fault;
}

/// From block 1's face to what its range sensors see [m].
double ranges_free_m(const DriveSituation & s)
{
  double least = kInfinity;
  for (const stetro_site::Place place :
       {stetro_site::Place::kFrontLeft, stetro_site::Place::kFrontRight,
        stetro_site::Place::kStairFront}) {
    const auto & range = s.seen.range(place);
    if (older_than(range, s.now, s.limits.driver_silence_s)) {
      continue;
    }
    if (range->status == RangeStatus::kValid) {
      least = std::min(least, range->range_m - s.robot.contact_reading_m(place));
    } else if (range->status == RangeStatus::kTooNear) {
      least = 0.0;
    }
  }
  return least;
}

/// From the body's face to what the lidar sees in a strip as wide as the body [m].
double scan_free_m(const DriveSituation & s)
{
  const auto & scan = s.seen.scan;
  if (!scan || std::abs(seconds_between(scan->time, s.now)) > kRecentScan_s) {
    return kInfinity;
  }
  const double half_m = 0.5 * s.robot.contact_width_m + kBesideBody_m;
  const double face_m = 0.5 * s.robot.length_m();
  const auto & lidar = s.robot.lidar;
  const auto & profile = scan->profile;
  double least = kInfinity;
  for (std::size_t i = 0; i < profile.ranges_m.size(); ++i) {
    const double range = profile.ranges_m[i];
    if (!std::isfinite(range)) {
      continue;
    }
    const double yaw =
      lidar.yaw_rad + profile.fan.first_rad + static_cast<double>(i) * profile.fan.step_rad;
    const double ahead = lidar.x_m + range * std::cos(yaw) - face_m;
    if (ahead > 0.0 && std::abs(lidar.y_m + range * std::sin(yaw)) < half_m) {
      least = std::min(least, ahead);
    }
  }
  return least;
}

}  // namespace

double DriveSituation::rest_m() const
{
  if (!has_leg() || !pose.place) {
    return 0.0;
  }
  const Eigen::Vector2d end = memory.corners_m[memory.leg];
  const Eigen::Vector2d along = (end - memory.corners_m[memory.leg - 1]).normalized();
  return (end - pose.place->position_m).dot(along);
}

double DriveSituation::cross_track_m() const
{
  if (!has_leg() || !pose.place) {
    return 0.0;
  }
  const Eigen::Vector2d start = memory.corners_m[memory.leg - 1];
  const Eigen::Vector2d along = (memory.corners_m[memory.leg] - start).normalized();
  const Eigen::Vector2d off = pose.place->position_m - start;
  return along.x() * off.y() - along.y() * off.x();
}

double DriveSituation::to_leg_rad() const
{
  if (!has_leg() || !pose.place) {
    return 0.0;
  }
  const double towards = bearing(pose.place->position_m, memory.corners_m[memory.leg]);
  return wrap_angle(towards - pose.place->yaw_rad);
}

double DriveSituation::off_leg_rad() const
{
  if (!has_leg() || !pose.place) {
    return 0.0;
  }
  const double along = bearing(memory.corners_m[memory.leg - 1], memory.corners_m[memory.leg]);
  return wrap_angle(along - pose.place->yaw_rad);
}

double DriveSituation::to_goal_heading_rad() const
{
  const auto & wanted = memory.errand.yaw_rad;
  return wanted && pose.place ? wrap_angle(*wanted - pose.place->yaw_rad) : 0.0;
}

double DriveSituation::to_turn_rad() const
{
  return has_leg() ? to_leg_rad() : to_goal_heading_rad();
}

bool DriveSituation::at_goal() const { return !has_leg(); }

bool DriveSituation::is_handed_over() const
{
  const std::string & wanted = memory.errand.hand_over_to;
  return wanted.empty() || (seen.pose && seen.pose->segment_id == wanted);
}

double DriveSituation::way_free_m() const
{
  return std::min(ranges_free_m(*this), scan_free_m(*this));
}

bool DriveSituation::is_obstructed() const
{
  return memory.obstructed_since && seconds_between(*memory.obstructed_since, now) >= kStray_s;
}

bool DriveSituation::sees_obstacle() const
{
  return way_free_m() < std::min(params.stop_m, rest_m() + kBeyondLeg_m);
}

bool DriveSituation::bumps() const
{
  if (!seen.contacts) {
    return false;
  }
  const Contacts & c = *seen.contacts;
  return std::any_of(c.left.begin(), c.left.end(), closed) ||
         std::any_of(c.right.begin(), c.right.end(), closed) || closed(c.riser_left) ||
         closed(c.riser_right);
}

bool DriveSituation::steering_at(double angle_rad) const
{
  return seen.blocks && !seen.blocks->steering_moving &&
         std::abs(seen.blocks->steering_rad - angle_rad) <= limits.steering_tolerance_rad;
}

std::vector<Eigen::Vector2d> points_seen(
  const Scan & scan, const FloorPlace & place, const stetro_site::Lidar & lidar, double within_m)
{
  const ScannerPose at = scanner_at(place, lidar);
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < scan.profile.ranges_m.size(); ++i) {
    const double range = scan.profile.ranges_m[i];
    if (std::isfinite(range) && range < within_m) {
      const double yaw = at.yaw_rad + scan.profile.fan.first_rad +
                         static_cast<double>(i) * scan.profile.fan.step_rad;
      points.push_back(at.position_m + range * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)));
    }
  }
  return points;
}

}  // namespace stetro_supervisor
