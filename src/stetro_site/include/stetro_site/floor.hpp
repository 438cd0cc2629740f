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

#ifndef STETRO_SITE__FLOOR_HPP_
#define STETRO_SITE__FLOOR_HPP_

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/polygon.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_site
{

/// A floor drawn as polygons in the floor's own frame.
struct PolygonWalls
{
  Polygon outline;                 ///< the walls around it [m]
  std::vector<Polygon> obstacles;  ///< columns and the like inside [m]
};

/// A floor drawn as a grid map in the ROS map_server format.
struct GridMapFile
{
  std::string path;  ///< the YAML file of the map, absolute or relative to the working directory
  std::shared_ptr<const OccupancyGrid> grid;  ///< what it says; null until it is read
};

/// How a floor is drawn; `std::monostate` if nobody has drawn it.
using FloorDrawing = std::variant<std::monostate, PolygonWalls, GridMapFile>;

/// A level part of the building between flights.
struct Floor
{
  std::string id;        ///< also the name of the floor's frame
  Pose pose_in_map;      ///< of the floor's frame; z is the elevation
  FloorDrawing drawing;  ///< in the floor's frame

  [[nodiscard]] double elevation_m() const noexcept { return pose_in_map.z_m; }
  [[nodiscard]] bool is_drawn() const noexcept
  {
    return !std::holds_alternative<std::monostate>(drawing);
  }
};

}  // namespace stetro_site

#endif  // STETRO_SITE__FLOOR_HPP_
