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

// Poses that a person tells, and the segment that they are on.

#include <cmath>
#include <vector>

#include "stetro_localizer/building_estimator.hpp"
#include "stetro_site/free_space.hpp"
#include "stetro_site/standing_place.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kHeight = 0.1;  // a pose in map is on a floor within this of its elevation [m]

bool is_over(const stetro_site::Flight & flight, const stetro_site::Pose & in_map)
{
  const stetro_site::Pose pose = flight.T_map_flight().to_frame(in_map);
  return pose.x_m >= 0.0 && pose.x_m <= flight.total_run_m() &&
         !stetro_site::misplaced(pose, flight);
}

}  // namespace

bool BuildingEstimator::stands_on(
  const stetro_site::Floor & floor, const stetro_site::Pose & in_map) const
{
  const stetro_site::Pose pose = stetro_site::FrameTransform(floor.pose_in_map).to_frame(in_map);
  const auto free_space = stetro_site::free_space_of(floor.drawing);
  return free_space && std::abs(pose.z_m) <= kHeight && free_space->is_free({pose.x_m, pose.y_m});
}

std::string BuildingEstimator::accepted_frames() const
{
  std::string frames = "map";
  if (!drawn_) {
    return frames + ", " + flight().id();
  }
  for (const stetro_site::Flight & flight : site_.flights()) {
    frames += ", " + flight.id();
  }
  for (const stetro_site::Floor & floor : site_.floors()) {
    frames += drawn_floor(floor.id) >= 0 ? ", " + floor.id : "";
  }
  return frames;
}

// By its height first; what a floor's drawing has behind the first riser is the flight's.
std::optional<RefusedPose> BuildingEstimator::find_segment(
  const stetro_site::Pose & in_map, std::string & id) const
{
  if (!std::isfinite(in_map.x_m + in_map.y_m + in_map.z_m + in_map.yaw_rad)) {
    return RefusedPose{"implausible", "a number of the pose is not finite"};
  }
  std::vector<std::string> found;
  for (const stetro_site::Flight & flight : site_.flights()) {
    if (is_over(flight, in_map)) {
      found.push_back(flight.id());
    }
  }
  for (const stetro_site::Floor & floor : site_.floors()) {
    if (found.empty() && stands_on(floor, in_map)) {
      found.push_back(floor.id);
    }
  }
  for (const stetro_site::Floor & floor : site_.floors()) {
    const bool another = found.size() == 1 && floor.id != found.front();
    if (another && floor_named(found.front()) >= 0 && stands_on(floor, in_map)) {
      found.push_back(floor.id);
    }
  }
  if (found.size() == 1) {
    id = found.front();
    return std::nullopt;
  }
  if (found.empty()) {
    return RefusedPose{"implausible", "no floor and no flight has the place at that height"};
  }
  return RefusedPose{
    "ambiguous", "in " + found[0] + " and in " + found[1] + ": name one of them as the frame"};
}

std::optional<std::string> BuildingEstimator::tell_pose(
  const stetro_site::Pose & pose, const stetro_site::Covariance & covariance)
{
  return present_->tell_pose(pose, covariance);
}

std::optional<RefusedPose> BuildingEstimator::tell_pose(
  const std::string & frame_id, const stetro_site::Pose & pose,
  const stetro_site::Covariance & covariance)
{
  std::string id = frame_id;
  if (frame_id == "map") {
    id = flight().id();
    if (drawn_) {
      if (auto refused = find_segment(pose, id)) {
        return refused;
      }
    }
  }
  const int flight = flight_named(id);
  const int floor = drawn_floor(id);
  if (drawn_ ? flight < 0 && floor < 0 : id != this->flight().id()) {
    return RefusedPose{"frame", "'" + frame_id + "', accepted: " + accepted_frames()};
  }
  SegmentEstimator & named = flight >= 0 ? *flights_[static_cast<std::size_t>(flight)]
                                         : static_cast<SegmentEstimator &>(floors_);
  const Segment to = flight >= 0 ? segment_of(site_.flights()[static_cast<std::size_t>(flight)])
                                 : segment_of(site_.floors()[static_cast<std::size_t>(floor)]);
  const bool in_map = frame_id == "map";
  const stetro_site::Pose told = in_map ? to.T_map_segment.to_frame(pose) : pose;
  const stetro_site::Covariance doubt = in_map ? to.T_map_segment.to_frame(covariance) : covariance;
  const auto why = flight >= 0 ? implausible(
                                   told, site_.flights()[static_cast<std::size_t>(flight)],
                                   params_.heading.max_incidence_rad)
                               : implausible_on_floor(told);
  if (why) {
    return RefusedPose{"implausible", *why};
  }
  if (&named != present_ || to.id != segment().id) {
    const Legacy legacy = present_->legacy();
    flight >= 0 ? be_on_flight(flight) : be_on_floor(floor);
    present_->enter(legacy);
    ++crossings_;
  }
  floors_.choose(floor);
  if (const auto refused = present_->tell_pose(told, doubt)) {
    return RefusedPose{"implausible", *refused};
  }
  foot_doubted_ = false;
  return std::nullopt;
}

}  // namespace stetro_localizer
