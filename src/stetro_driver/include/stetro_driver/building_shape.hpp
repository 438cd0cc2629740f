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

#ifndef STETRO_DRIVER__BUILDING_SHAPE_HPP_
#define STETRO_DRIVER__BUILDING_SHAPE_HPP_

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "stetro_driver/stair_shape.hpp"
#include "stetro_site/polygon.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_driver
{

/// No floor is there, or none is known.
constexpr std::size_t kNoFloor = std::numeric_limits<std::size_t>::max();

/// A floor: where it is and which walls stand on it.
struct FloorShape
{
  std::string id;
  stetro_site::Pose pose_in_map{};  ///< of the floor's frame
  /// Somebody has drawn it: the robot on it is on the floor. Else on the flight it came from.
  bool drawn = false;
  /// In the floor's frame, the outline first; empty: no walls, also for a floor drawn as a grid.
  std::vector<stetro_site::Polygon> walls{};
};

/// A flight in its building.
struct PlacedStairs
{
  std::string id;
  StairShape shape{};
  stetro_site::Pose pose_in_map{};  ///< of the flight frame
  std::size_t lower = kNoFloor;     ///< index of the floor below its first riser
  std::size_t upper = kNoFloor;     ///< index of the floor that continues its last tread
};

/// What a simulation is made of: flights of stairs, and the floors between them.
struct BuildingShape
{
  std::vector<PlacedStairs> flights{};  ///< at least one
  std::vector<FloorShape> floors{};
  std::size_t start = 0;  ///< index of the flight in whose frame the robot starts
};

/// A building of one flight, with nothing known of its floors.
[[nodiscard]] BuildingShape building_of(const StairShape & stairs);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__BUILDING_SHAPE_HPP_
