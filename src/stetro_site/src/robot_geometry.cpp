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

#include "stetro_site/robot_geometry.hpp"

#include <cmath>

#include "metres.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Faults;

constexpr double kRounding = 1e-9;  // [m]

std::string key_of(Place place, const char * key)
{
  return "sensors." + name_of(place) + "." + key;
}

/// The two of a pair look the same way from the same x, the left one on the left.
void check_pair(const RobotGeometry & robot, Place left, Place right, Faults & faults)
{
  const Mounting & l = robot.at(left);
  const Mounting & r = robot.at(right);
  if (l.y_m <= r.y_m) {
    faults.refuse(
      key_of(left, "y_m"), metres(l.y_m),
      "more than " + metres(r.y_m) + ", " + key_of(right, "y_m") + ": left is +y");
  }
  if (std::abs(l.x_m - r.x_m) > kRounding) {
    faults.refuse(
      key_of(left, "x_m"), metres(l.x_m), metres(r.x_m) + ", as " + key_of(right, "x_m"));
  }
}

/// The number that sets how far a sensor stands back.
std::string recess_key(Place place)
{
  switch (place) {
    case Place::kSideLeft:
    case Place::kSideRight:
      return key_of(place, "y_m");
    case Place::kBlock1Down:
    case Place::kBlock2Down:
      return key_of(place, "height_m");
    default:
      return key_of(place, "x_m");
  }
}

void check_recess(const RobotGeometry & robot, Place place, Faults & faults)
{
  const double recess_m = robot.contact_reading_m(place);
  const double least_m = robot.range_sensor.min_range_m;
  if (recess_m < least_m - kRounding) {
    faults.refuse(
      recess_key(place), "recess of " + metres(recess_m),
      "a recess of at least range_sensor.min_range_m, " + metres(least_m) +
        ", or contact cannot be read");
  }
}

}  // namespace

double RangeSensor::sigma_at_m(double range_m) const
{
  return std::hypot(sigma_m, sigma_per_m * range_m);
}

double RobotGeometry::front_baseline_m() const
{
  return at(Place::kFrontLeft).y_m - at(Place::kFrontRight).y_m;
}

double RobotGeometry::side_separation_m() const
{
  return at(Place::kSideLeft).y_m - at(Place::kSideRight).y_m;
}

double RobotGeometry::contact_reading_m(Place place) const
{
  const Mounting & mounting = at(place);
  switch (place) {
    case Place::kSideLeft:
      return 0.5 * contact_width_m - mounting.y_m;
    case Place::kSideRight:
      return 0.5 * contact_width_m + mounting.y_m;
    case Place::kBlock1Down:
    case Place::kBlock2Down:
      return mounting.height_m;
    default:
      return block_x_m(block_of(place)) + 0.5 * block_length_m - mounting.x_m;
  }
}

void check(const RobotGeometry & robot, Faults & faults)
{
  if (robot.contact_width_m < robot.body_width_m) {
    faults.refuse(
      "body.contact_width_m", metres(robot.contact_width_m),
      "at least body.width_m, " + metres(robot.body_width_m));
  }
  if (robot.front_baseline_m() > robot.body_width_m + kRounding) {
    faults.refuse(
      key_of(Place::kFrontLeft, "y_m"), "front baseline of " + metres(robot.front_baseline_m()),
      "a baseline of at most body.width_m, " + metres(robot.body_width_m));
  }
  if (robot.range_sensor.min_range_m >= robot.range_sensor.reliable_range_m) {
    faults.refuse(
      "range_sensor.min_range_m", metres(robot.range_sensor.min_range_m),
      "less than range_sensor.reliable_range_m, " + metres(robot.range_sensor.reliable_range_m));
  }
  if (robot.lidar.min_range_m >= robot.lidar.max_range_m) {
    faults.refuse(
      "lidar.min_range_m", metres(robot.lidar.min_range_m),
      "less than lidar.max_range_m, " + metres(robot.lidar.max_range_m));
  }
  if (robot.lidar.height_m <= robot.body_height_m) {
    faults.refuse(
      "lidar.height_m", metres(robot.lidar.height_m),
      "more than body.height_m, " + metres(robot.body_height_m) +
        ", or it looks at its own blocks");
  }
  check_pair(robot, Place::kFrontLeft, Place::kFrontRight, faults);
  check_pair(robot, Place::kSideLeft, Place::kSideRight, faults);
  for (const Place place : kPlaces) {
    check_recess(robot, place, faults);
  }
}

}  // namespace stetro_site
