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

#ifndef SIM__FLOOR_PLAN_HPP_
#define SIM__FLOOR_PLAN_HPP_

#include <vector>

#include "sim/wall.hpp"
#include "stetro_driver/building_shape.hpp"

namespace stetro_driver::sim
{

/// The walls of one floor, as drawn, in the floor's frame.
class FloorPlan
{
public:
  explicit FloorPlan(const FloorShape & shape);

  [[nodiscard]] bool drawn() const { return drawn_; }
  [[nodiscard]] const std::vector<Wall> & walls() const { return walls_; }

  /// Inside the outline and outside all obstacles; everywhere on a floor without walls.
  [[nodiscard]] bool inside(double x_m, double y_m) const;

  /// From a point to the nearest wall; +inf without any.
  [[nodiscard]] double wall_distance_m(double x_m, double y_m) const;

  /// The corners of the smallest rectangle that holds all walls; empty (0, 0) without any.
  [[nodiscard]] double min_x_m() const { return min_x_m_; }
  [[nodiscard]] double max_x_m() const { return max_x_m_; }
  [[nodiscard]] double min_y_m() const { return min_y_m_; }
  [[nodiscard]] double max_y_m() const { return max_y_m_; }

private:
  bool drawn_;
  std::vector<stetro_site::Polygon> polygons_;
  std::vector<Wall> walls_{};
  double min_x_m_ = 0.0;
  double max_x_m_ = 0.0;
  double min_y_m_ = 0.0;
  double max_y_m_ = 0.0;
};

}  // namespace stetro_driver::sim

#endif  // SIM__FLOOR_PLAN_HPP_
