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

#include "stetro_supervisor/told_pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stetro_site/standing_place.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kFloorHeight_m = 0.1;  // either way, as the localizer judges it
constexpr double kAsymmetry = 1e-6;     // of the larger of the two elements: rounding, no more

bool equal(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::string number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", value);
  return text;
}

std::string refuse_segment(const std::string & id, const stetro_site::Flight & flight)
{
  const std::string & floor = flight.spec().lower_floor;
  const bool known = id == flight.id() || (!floor.empty() && id == floor);
  const std::string foot = floor.empty() ? "" : ", or the floor at its foot, '" + floor + "'";
  return known ? "" : "segment_id '" + id + "', accepted: the flight '" + flight.id() + "'" + foot;
}

std::string refuse_numbers(const ToldPose & told, const std::string & segment_id)
{
  if (told.frame_id != "map" && told.frame_id != segment_id) {
    return "frame_id '" + told.frame_id + "', accepted: 'map' or '" + segment_id + "'";
  }
  const stetro_site::Pose & p = told.pose;
  if (!std::isfinite(p.x_m + p.y_m + p.z_m)) {
    return "pose.position (" + number(p.x_m) + ", " + number(p.y_m) + ", " + number(p.z_m) +
           "), accepted: finite numbers";
  }
  if (!std::isfinite(p.yaw_rad)) {
    return "pose.orientation leans or is no unit quaternion, accepted: a turn about z";
  }
  return "";
}

std::string refuse_covariance(const stetro_site::Covariance & covariance)
{
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      const double element = covariance(row, column);
      const double mirrored = covariance(column, row);
      const std::string name = "covariance[" + std::to_string(6 * row + column) + "] ";
      if (!std::isfinite(element)) {
        return name + number(element) + ", accepted: finite numbers";
      }
      if (row == column && element < 0.0) {
        return name + number(element) + ", accepted: a variance, 0 or more";
      }
      const double larger = std::max(std::abs(element), std::abs(mirrored));
      if (std::abs(element - mirrored) > kAsymmetry * larger) {
        return name + number(element) + " is not " + number(mirrored) + ", its mirror image, " +
               "accepted: a symmetric matrix";
      }
    }
  }
  return "";
}

/// The tread under x, as a person would name it.
std::string place_of(int step, const stetro_site::Flight & flight)
{
  if (step == 0) {
    return "lies on step 0, the floor before x 0.000 m";
  }
  const bool last = step == flight.steps();
  return "lies on step " + std::to_string(step) + ", from " + number(flight.tread_start_m(step)) +
         " m" + (last ? " on" : " to " + number(flight.tread_end_m(step)) + " m");
}

std::string refuse_step(
  const ToldPose & told, const std::string & segment_id, const stetro_site::Pose & pose,
  const stetro_site::Flight & flight)
{
  const int under = flight.step_at(pose.x_m);
  const std::string x = "x " + number(pose.x_m) + " m in the flight " + place_of(under, flight);
  if (told.step != -1 && told.step != under) {
    return "step " + std::to_string(told.step) + ", but " + x +
           ", accepted: " + std::to_string(under) + ", or -1 for unknown";
  }
  if (segment_id != flight.id() && under != 0) {
    return "segment_id '" + segment_id + "', but " + x + ", accepted: '" + flight.id() + "'";
  }
  return "";
}

}  // namespace

bool same(const ToldPose & a, const ToldPose & b)
{
  bool equals = a.frame_id == b.frame_id && a.step == b.step && equal(a.pose.x_m, b.pose.x_m) &&
                equal(a.pose.y_m, b.pose.y_m) && equal(a.pose.z_m, b.pose.z_m) &&
                equal(a.pose.yaw_rad, b.pose.yaw_rad);
  for (int i = 0; i < 36; ++i) {
    equals = equals && equal(a.covariance(i / 6, i % 6), b.covariance(i / 6, i % 6));
  }
  return equals;
}

stetro_site::Pose in_flight(const ToldPose & told, const stetro_site::Flight & flight)
{
  return told.frame_id == flight.id() ? told.pose : flight.T_map_flight().to_frame(told.pose);
}

std::string refusal_of(
  const ToldPose & told, const std::string & segment_id, const stetro_site::Flight & flight)
{
  for (const std::string & why :
       {refuse_segment(segment_id, flight), refuse_numbers(told, flight.id()),
        refuse_covariance(told.covariance)}) {
    if (!why.empty()) {
      return why;
    }
  }
  const stetro_site::Pose pose = in_flight(told, flight);
  const std::string why = refuse_step(told, segment_id, pose, flight);
  return why.empty() ? stetro_site::misplaced(pose, flight).value_or("") : why;
}

std::string refusal_on_floor(const ToldPose & told, const DrawnFloor & floor)
{
  for (const std::string & why :
       {refuse_numbers(told, floor.id()), refuse_covariance(told.covariance)}) {
    if (!why.empty()) {
      return why;
    }
  }
  if (told.step > 0) {
    return "step " + std::to_string(told.step) + " on floor '" + floor.id() +
           "', accepted: 0, or -1 for unknown";
  }
  const stetro_site::FrameTransform T_map_floor{floor.floor().pose_in_map};
  const stetro_site::Pose pose =
    told.frame_id == "map" ? T_map_floor.to_frame(told.pose) : told.pose;
  if (std::abs(pose.z_m) > kFloorHeight_m) {
    return "z " + number(pose.z_m) + " m above floor '" + floor.id() + "', accepted: -" +
           number(kFloorHeight_m) + " to " + number(kFloorHeight_m);
  }
  if (!floor.free_space().is_free({pose.x_m, pose.y_m})) {
    return "(" + number(pose.x_m) + ", " + number(pose.y_m) + ") m on floor '" + floor.id() +
           "' is in a wall or outside, accepted: where the robot can stand";
  }
  return "";
}

}  // namespace stetro_supervisor
