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

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "flight_file.hpp"
#include "stetro_config/map_reader.hpp"
#include "stetro_site/map_file.hpp"
#include "stetro_site/site.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Any;
using stetro_config::Faults;
using stetro_config::Identifier;
using stetro_config::MapReader;
using stetro_config::NonEmpty;
using stetro_config::Within;

Polygon read_outline(MapReader & map)
{
  Polygon outline;
  for (MapReader & corner : map.require_maps("outline")) {
    const auto x_m = corner.require<double>("x_m", Any{});
    const auto y_m = corner.require<double>("y_m", Any{});
    outline.emplace_back(x_m, y_m);
    corner.finish();
  }
  if (map.sound()) {
    const std::string flaw = flaw_of(outline);
    if (!flaw.empty()) {
      map.refuse("outline", flaw, "a closed line of three corners or more that never meets itself");
    }
  }
  return outline;
}

PolygonWalls read_walls(MapReader map)
{
  PolygonWalls walls;
  walls.outline = read_outline(map);
  for (MapReader & obstacle : map.find_maps("obstacles")) {
    walls.obstacles.push_back(read_outline(obstacle));
    obstacle.finish();
  }
  map.finish();
  return walls;
}

/// A map's path counts from the folder of the site file. Its faults are the site file's as well.
GridMapFile read_grid_map(MapReader & floor, std::vector<std::string> & notes)
{
  const auto written = floor.require<std::string>("map", NonEmpty{});
  const std::filesystem::path folder = std::filesystem::path{floor.origin().file}.parent_path();
  GridMapFile file{(folder / written).string(), nullptr};
  std::error_code ignored;
  if (written.empty()) {
    return file;  // a fault already says so
  }
  if (!std::filesystem::is_regular_file(file.path, ignored)) {
    floor.refuse("map", written, "a map_server YAML file; there is none at " + file.path);
    return file;
  }
  Faults faults;
  auto map = read_map(file.path, faults);
  for (const auto & fault : faults) {
    floor.refuse("map", written, "a map without faults; " + to_string(fault));
  }
  if (map) {
    file.grid = std::make_shared<const OccupancyGrid>(std::move(map->grid));
    for (const std::string & note : map->notes) {
      notes.push_back(floor.name_of("map") + ": " + note);
    }
  }
  return file;
}

Floor read_floor(MapReader & map, std::vector<std::string> & notes)
{
  Floor floor;
  floor.id = map.require<std::string>("id", Identifier{});
  const auto elevation_m = map.require<double>("elevation_m", Within{-1000.0, 1000.0});
  if (auto pose = map.find_map("pose")) {
    floor.pose_in_map = read_pose(std::move(*pose), false);
  }
  floor.pose_in_map.z_m = elevation_m;
  auto walls = map.find_map("walls");
  if (map.has("map")) {
    floor.drawing = read_grid_map(map, notes);
    if (walls) {
      map.refuse("walls", "a map", "either map or walls");
    }
  } else if (walls) {
    floor.drawing = read_walls(std::move(*walls));
  } else {
    static_cast<void>(map.find<std::string>("map", NonEmpty{}));  // so that it is a known key
  }
  map.finish();
  return floor;
}

/// Remembers where the keys stand that later checks may refuse.
void remember(const MapReader & map, std::map<std::string, stetro_config::Origin> & origins)
{
  for (const std::string & key : map.keys()) {
    origins.emplace(map.name_of(key), map.origin(key));
  }
}

}  // namespace

std::optional<Site> read_site(const std::string & path, Faults & faults)
{
  MapReader file = MapReader::from_file(path, faults);
  SiteSpec spec;
  spec.origins.emplace("", file.origin());
  // A segment that could not be read would have its neighbours blamed as well.
  bool is_whole = file.has("floors");
  spec.name = file.require<std::string>("name", NonEmpty{});
  spec.tolerance_m = file.optional("tolerance_m", kDefaultTolerance, Within{0.0, 0.1});
  for (MapReader & map : file.require_maps("floors")) {
    remember(map, spec.origins);
    spec.floors.push_back(read_floor(map, spec.notes));
    is_whole = is_whole && map.sound();
  }
  for (MapReader & map : file.find_maps("flights")) {
    remember(map, spec.origins);
    auto flight = read_flight(map, spec.tolerance_m, spec.notes);
    is_whole = is_whole && flight;
    if (flight) {
      spec.flights.push_back(std::move(*flight));
    }
  }
  file.finish();
  const Faults contradictions = is_whole ? check_graph(spec) : Faults{};
  for (const auto & fault : contradictions) {
    faults.add(fault);
  }
  const bool is_sound = file.sound() && contradictions.empty();
  return is_sound ? std::optional{Site{std::move(spec)}} : std::nullopt;
}

}  // namespace stetro_site
