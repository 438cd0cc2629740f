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

#ifndef STETRO_LOCALIZER__SEGMENT_HPP_
#define STETRO_LOCALIZER__SEGMENT_HPP_

#include <string>

#include "stetro_site/flight.hpp"
#include "stetro_site/floor.hpp"
#include "stetro_site/frame_transform.hpp"

namespace stetro_localizer
{

/// What a part of the building is, as the robot moves on it.
enum class SegmentKind {
  kNowhere,  ///< nobody has said where the robot is
  kFloor,
  kFlight
};

/// The part of the building that an estimate is of, and the frame that it is given in.
struct Segment
{
  SegmentKind kind = SegmentKind::kNowhere;
  std::string id;  ///< also the name of its frame; empty: unknown, poses are in `map`
  int steps = 0;   ///< of a flight; 0 of a floor
  stetro_site::FrameTransform T_map_segment{stetro_site::Pose{}};

  /// The frame that poses are given in.
  [[nodiscard]] std::string frame_id() const { return id.empty() ? "map" : id; }
};

[[nodiscard]] inline Segment segment_of(const stetro_site::Flight & flight)
{
  return {SegmentKind::kFlight, flight.id(), flight.steps(), flight.T_map_flight()};
}

[[nodiscard]] inline Segment segment_of(const stetro_site::Floor & floor)
{
  return {SegmentKind::kFloor, floor.id, 0, stetro_site::FrameTransform(floor.pose_in_map)};
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SEGMENT_HPP_
