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

#ifndef STETRO_SUPERVISOR__FLOOR__FLOOR_PLACE_HPP_
#define STETRO_SUPERVISOR__FLOOR__FLOOR_PLACE_HPP_

#include <Eigen/Core>
#include <optional>
#include <string>

#include "stetro_site/pose.hpp"
#include "stetro_site/site.hpp"

namespace stetro_supervisor
{

struct StairPose;

/// Where base_link is on a floor.
struct FloorPlace
{
  std::string floor_id;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< in the floor's frame
  double yaw_rad = 0.0;                                  ///< in the floor's frame, CCW
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< floor's axes, (x, y, yaw)
};

/// The localizer's pose as a place on a floor, whichever frame it is told in.
/**
 * Before the first riser of a flight the robot is on its lower floor, on the last tread, which is
 * flush with it, on the upper one: the localizer changes frames there, the robot does not move.
 * \return nothing on the steps between, for a segment that the site does not have, or if the pose
 *   is not of finite numbers
 */
[[nodiscard]] std::optional<FloorPlace> place_on_floor(
  const StairPose & pose, const stetro_site::Site & site);

/// A pose on a floor in the frame of a flight that joins it.
[[nodiscard]] stetro_site::Pose in_flight(
  const FloorPlace & place, const stetro_site::Floor & floor, const stetro_site::Flight & flight);

/// A pose in the frame of a flight on a floor that it joins; without covariance.
[[nodiscard]] FloorPlace on_floor(
  const stetro_site::Pose & in_flight, const stetro_site::Floor & floor,
  const stetro_site::Flight & flight);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__FLOOR_PLACE_HPP_
