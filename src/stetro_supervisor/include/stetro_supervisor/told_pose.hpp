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

#ifndef STETRO_SUPERVISOR__TOLD_POSE_HPP_
#define STETRO_SUPERVISOR__TOLD_POSE_HPP_

#include <string>

#include "stetro_site/flight.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"

namespace stetro_supervisor
{

/// Where a person says that the robot stands.
struct ToldPose
{
  std::string frame_id;      ///< `map`, or the id of the flight or floor
  stetro_site::Pose pose{};  ///< base_link in that frame; yaw NaN: the orientation is not upright
  stetro_site::Covariance covariance = stetro_site::Covariance::Zero();  ///< of the pose
  int step = -1;  ///< tread block 2 stands on, 0 the floor, -1 not told
};

/// Whether two requests tell the same; a number that is NaN in both is the same.
[[nodiscard]] bool same(const ToldPose & a, const ToldPose & b);

/// The pose in the flight frame. The frame must be one that `refusal_of` accepts.
[[nodiscard]] stetro_site::Pose in_flight(
  const ToldPose & told, const stetro_site::Flight & flight);

/// Why it cannot be so, naming field, value and what is accepted; empty if it can.
/**
 * The segment is the flight, or the floor at its foot, where x lies before the first riser. The
 * pose is on the surface under its x and between the walls; a step that is told is the one that x
 * lies on. The covariance is finite and symmetric with no negative variance; a variance of zero is
 * taken for the least that the localizer believes, 1 cm or 0.01 rad squared.
 */
[[nodiscard]] std::string refusal_of(
  const ToldPose & told, const std::string & segment_id, const stetro_site::Flight & flight);

/// The same for a place on a floor: at its height, where nothing is drawn, on no step.
[[nodiscard]] std::string refusal_on_floor(const ToldPose & told, const DrawnFloor & floor);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__TOLD_POSE_HPP_
