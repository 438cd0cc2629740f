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

#ifndef TESTS__RECORDED__BUILDING_MAP_HPP_
#define TESTS__RECORDED__BUILDING_MAP_HPP_

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stetro_site/floor_raster.hpp"
#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/polygon.hpp"
#include "stetro_site/profile_caster.hpp"

namespace recorded
{

/// A level of an Open-RMF building map, in metres, y up. Doors stand open: they are gaps.
struct BuildingLevel
{
  std::string name;
  double elevation_m = 0.0;
  double metres_a_pixel = 0.0;
  std::vector<stetro_site::Segment> walls;
  std::vector<stetro_site::Polygon> floors;  ///< what may be walked on; they may overlap
};

/// Reads the walls and floors of a `.building.yaml`: for tests and evaluations, not for robots.
/**
 * Only `coordinate_system: reference_image`: a level's vertices are pixels of its drawing, y down,
 * and its measurements, each a distance in metres between two vertices, say how long a pixel is.
 * Pixel (0, 0) becomes the origin, so y is negative. Levels are not aligned with one another.
 */
class BuildingMap
{
public:
  /// \throws YAML::Exception or std::runtime_error
  static std::vector<BuildingLevel> read(const std::string & path)
  {
    const YAML::Node building = YAML::LoadFile(path);
    if (building["coordinate_system"].as<std::string>() != "reference_image") {
      throw std::runtime_error(path + ": coordinate_system is not reference_image");
    }
    std::vector<BuildingLevel> levels;
    for (const auto & level : building["levels"]) {
      levels.push_back(BuildingMap{level.second}.read_level(level.first.as<std::string>()));
    }
    return levels;
  }

private:
  explicit BuildingMap(const YAML::Node & level) : level_(level)
  {
    for (const YAML::Node & vertex : level["vertices"]) {
      pixels_.emplace_back(vertex[0].as<double>(), -vertex[1].as<double>());
    }
  }

  [[nodiscard]] BuildingLevel read_level(const std::string & name) const
  {
    BuildingLevel level;
    level.name = name;
    level.elevation_m = level_["elevation"].as<double>();
    level.metres_a_pixel = scale();
    for (const YAML::Node & wall : level_["walls"]) {
      level.walls.push_back(
        {level.metres_a_pixel * vertex(wall[0]), level.metres_a_pixel * vertex(wall[1])});
    }
    for (const YAML::Node & floor : level_["floors"]) {
      level.floors.emplace_back();
      for (const YAML::Node & corner : floor["vertices"]) {
        level.floors.back().push_back(level.metres_a_pixel * vertex(corner));
      }
    }
    return level;
  }

  [[nodiscard]] Eigen::Vector2d vertex(const YAML::Node & index) const
  {
    return pixels_.at(index.as<std::size_t>());
  }

  /// The mean over the measurements; a typed value is [type, value].
  [[nodiscard]] double scale() const
  {
    double sum = 0.0;
    for (const YAML::Node & measurement : level_["measurements"]) {
      const double pixels = (vertex(measurement[1]) - vertex(measurement[0])).norm();
      sum += measurement[2]["distance"][1].as<double>() / pixels;
    }
    return sum / static_cast<double>(level_["measurements"].size());
  }

  YAML::Node level_;
  std::vector<Eigen::Vector2d> pixels_;
};

/// A level as a grid: cells that a wall touches, floor that none touches, and unknown elsewhere.
inline stetro_site::OccupancyGrid rasterise(const BuildingLevel & level, double resolution_m)
{
  using stetro_site::Cell;
  Eigen::Array2d low = level.walls.at(0).from_m.array();
  Eigen::Array2d high = low;
  for (const auto & wall : level.walls) {
    low = low.min(wall.from_m.array()).min(wall.to_m.array());
    high = high.max(wall.from_m.array()).max(wall.to_m.array());
  }
  const Eigen::Array2d first = (low / resolution_m).floor() - 1.0;
  const Eigen::Array2i size = ((high / resolution_m).ceil() + 1.0 - first).cast<int>();
  const stetro_site::GridFrame frame{
    size.x(), size.y(), resolution_m, resolution_m * first.matrix(), 0.0};
  const stetro_site::OccupancyGrid blank{
    frame, std::vector<Cell>(static_cast<std::size_t>(size.prod()), Cell::kUnknown)};
  std::vector<Cell> cells = blank.cells();
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const Eigen::Vector2d centre_m = blank.centre_m({column, row});
      const auto is_around = [&](const auto & floor) {
        return stetro_site::encloses(floor, centre_m);
      };
      if (std::any_of(level.floors.begin(), level.floors.end(), is_around)) {
        cells[blank.offset({column, row})] = Cell::kFree;
      }
    }
  }
  for (const auto & wall : level.walls) {
    for (const auto cell : stetro_site::touched_cells(blank, wall)) {
      cells[blank.offset(cell)] = Cell::kOccupied;
    }
  }
  return stetro_site::OccupancyGrid{frame, std::move(cells)};
}

}  // namespace recorded

#endif  // TESTS__RECORDED__BUILDING_MAP_HPP_
