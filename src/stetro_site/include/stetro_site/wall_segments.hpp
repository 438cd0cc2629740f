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

#ifndef STETRO_SITE__WALL_SEGMENTS_HPP_
#define STETRO_SITE__WALL_SEGMENTS_HPP_

#include <Eigen/Core>
#include <vector>

#include "stetro_site/floor.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

/// The edges of the outline, then those of each obstacle, in the order they are drawn.
[[nodiscard]] std::vector<Segment> wall_segments(const PolygonWalls & walls);

/// From a point to the nearest point of a wall [m].
[[nodiscard]] double distance_m(const Segment & wall, const Eigen::Vector2d & point_m);

/// From a point to the nearest of some walls; +inf if there is none [m].
[[nodiscard]] double distance_m(
  const std::vector<Segment> & walls, const Eigen::Vector2d & point_m);

}  // namespace stetro_site

#endif  // STETRO_SITE__WALL_SEGMENTS_HPP_
