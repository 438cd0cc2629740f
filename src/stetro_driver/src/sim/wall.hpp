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

#ifndef SIM__WALL_HPP_
#define SIM__WALL_HPP_

#include <limits>
#include <optional>

#include "sim/stair_world.hpp"
#include "stetro_driver/body_shape.hpp"

namespace stetro_driver::sim
{

/// An upright wall without thickness, seen from both sides.
struct Wall
{
  double from_x_m = 0.0;
  double from_y_m = 0.0;
  double to_x_m = 0.0;
  double to_y_m = 0.0;
  double bottom_m = -std::numeric_limits<double>::infinity();
  double top_m = std::numeric_limits<double>::infinity();
};

/// Distance along a level ray to a wall's line between its ends; +inf when it misses.
/** \param x, y, dx, dy origin and unit direction, seen from above */
[[nodiscard]] double distance_along(const Wall & wall, double x, double y, double dx, double dy);

/// Where a ray meets a wall. \param direction of unit length
[[nodiscard]] std::optional<RayHit> cast(
  const Wall & wall, const Vector3 & origin, const Vector3 & direction);

/// A rectangle seen from above, with its sides along its own axes.
struct Rectangle
{
  double min_x_m = 0.0;
  double max_x_m = 0.0;
  double half_width_m = 0.0;
};

/// The shortest way out of a wall for a rectangle that it has gone into.
struct WayOut
{
  double depth_m = 0.0;  ///< above zero
  double x = 0.0;        ///< unit, the way to go
  double y = 0.0;
  double at_x_m = 0.0;  ///< the point of the rectangle that is pushed
  double at_y_m = 0.0;
};

/// By separating axes: the rectangle's two and the wall's normal. Nothing when they are apart.
/** \param wall in the rectangle's axes; its height is not looked at */
[[nodiscard]] std::optional<WayOut> way_out(const Rectangle & rectangle, const Wall & wall);

/// From y = 0 to the nearest part of a wall beside a stretch of the x axis; 0 or less: across it.
/**
 * +inf when no part of it is beside. \param wall in the stretch's axes \param left toward +y, else
 * toward -y
 */
[[nodiscard]] double beside_m(const Wall & wall, double min_x_m, double max_x_m, bool left);

}  // namespace stetro_driver::sim

#endif  // SIM__WALL_HPP_
