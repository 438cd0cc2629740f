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

#include "stetro_supervisor/floor/floor_place.hpp"

#include <cmath>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/observation.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Flight;
using stetro_site::Floor;
using stetro_site::FrameTransform;
using stetro_site::Pose;
using stetro_site::Site;

/// The covariance in axes that are turned by `angle_rad` against those it is given in.
Eigen::Matrix3d turned_by(const Eigen::Matrix3d & covariance, double angle_rad)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(0, 0) = turn(1, 1) = std::cos(angle_rad);
  turn(1, 0) = std::sin(angle_rad);
  turn(0, 1) = -turn(1, 0);
  return turn * covariance * turn.transpose();
}

}  // namespace

std::optional<FloorPlace> place_on_floor(const StairPose & pose, const Site & site)
{
  if (!std::isfinite(pose.x_m + pose.y_m + pose.heading_rad)) {
    return std::nullopt;
  }
  if (!pose.on_flight) {
    const bool known = site.find_floor(pose.segment_id) != nullptr;
    return known ? std::optional<FloorPlace>{FloorPlace{
                     pose.segment_id, {pose.x_m, pose.y_m}, pose.heading_rad, pose.covariance}}
                 : std::nullopt;
  }
  const Flight * flight = site.find_flight(pose.segment_id);
  if (flight == nullptr || (pose.step != 0 && pose.step != flight->steps())) {
    return std::nullopt;
  }
  const auto & spec = flight->spec();
  const Floor * floor = site.find_floor(pose.step == 0 ? spec.lower_floor : spec.upper_floor);
  if (floor == nullptr) {
    return std::nullopt;
  }
  FloorPlace place = on_floor({pose.x_m, pose.y_m, 0.0, pose.heading_rad}, *floor, *flight);
  place.covariance =
    turned_by(pose.covariance, flight->spec().pose_in_map.yaw_rad - floor->pose_in_map.yaw_rad);
  return place;
}

Pose in_flight(const FloorPlace & place, const Floor & floor, const Flight & flight)
{
  const Pose here{place.position_m.x(), place.position_m.y(), 0.0, place.yaw_rad};
  return flight.T_map_flight().to_frame(FrameTransform{floor.pose_in_map}.to_map(here));
}

FloorPlace on_floor(const Pose & in_flight, const Floor & floor, const Flight & flight)
{
  const Pose here =
    FrameTransform{floor.pose_in_map}.to_frame(flight.T_map_flight().to_map(in_flight));
  return {floor.id, {here.x_m, here.y_m}, here.yaw_rad, Eigen::Matrix3d::Zero()};
}

}  // namespace stetro_supervisor
