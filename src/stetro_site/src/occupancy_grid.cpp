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

#include "stetro_site/occupancy_grid.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_site
{

namespace
{

void check(const GridFrame & frame, std::size_t cells)
{
  const auto refuse = [](const std::string & name, const std::string & value, const char * wanted) {
    throw std::invalid_argument("grid: " + name + " = " + value + ", " + wanted);
  };
  if (frame.columns < 1 || frame.rows < 1) {
    refuse(
      "columns x rows", std::to_string(frame.columns) + " x " + std::to_string(frame.rows),
      "at least 1 x 1 wanted");
  }
  if (!std::isfinite(frame.resolution_m) || frame.resolution_m <= 0.0) {
    refuse("resolution_m", std::to_string(frame.resolution_m), "a positive length wanted");
  }
  if (!frame.origin_m.allFinite() || !std::isfinite(frame.yaw_rad)) {
    refuse(
      "origin",
      "(" + std::to_string(frame.origin_m.x()) + ", " + std::to_string(frame.origin_m.y()) + ", " +
        std::to_string(frame.yaw_rad) + ")",
      "finite numbers wanted");
  }
  const std::size_t wanted =
    static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  if (cells != wanted) {
    refuse("cells", std::to_string(cells), (std::to_string(wanted) + " wanted").c_str());
  }
}

}  // namespace

OccupancyGrid::OccupancyGrid(const GridFrame & frame, std::vector<Cell> cells)
: frame_(frame), cells_(std::move(cells))
{
  check(frame_, cells_.size());
  const double c = std::cos(frame_.yaw_rad);
  const double s = std::sin(frame_.yaw_rad);
  rotation_ << c, -s, s, c;
}

Eigen::Vector2d OccupancyGrid::to_cells(const Eigen::Vector2d & point_m) const
{
  return rotation_.transpose() * (point_m - frame_.origin_m) / frame_.resolution_m;
}

Eigen::Vector2d OccupancyGrid::to_floor_m(const Eigen::Vector2d & in_cells) const
{
  return frame_.origin_m + rotation_ * (in_cells * frame_.resolution_m);
}

CellIndex OccupancyGrid::cell_at(const Eigen::Vector2d & point_m) const
{
  const Eigen::Vector2d at = to_cells(point_m);
  return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
}

Eigen::Vector2d OccupancyGrid::centre_m(CellIndex cell) const
{
  return to_floor_m({cell.column + 0.5, cell.row + 0.5});
}

}  // namespace stetro_site
