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

#ifndef STETRO_SITE__POLYGON_HPP_
#define STETRO_SITE__POLYGON_HPP_

#include <Eigen/Core>
#include <string>
#include <vector>

namespace stetro_site
{

/// A closed line of corners [m]; the last joins the first. Either way round.
using Polygon = std::vector<Eigen::Vector2d>;

/// The area, positive when the corners run counter-clockwise [m^2].
[[nodiscard]] double signed_area_m2(const Polygon & polygon);

/// Whether a point is inside. Of points on an edge some are and some are not.
[[nodiscard]] bool encloses(const Polygon & polygon, const Eigen::Vector2d & point_m);

/// What is wrong with a polygon as a wall, in words; empty if nothing.
/**
 * A wall has three corners or more, some area, and no edge that meets another except at the
 * corner they share.
 */
[[nodiscard]] std::string flaw_of(const Polygon & polygon);

}  // namespace stetro_site

#endif  // STETRO_SITE__POLYGON_HPP_
