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

#include "profiles/recorded_floor.hpp"

#include <limits>
#include <random>
#include <utility>

#include "profiles/grid_scanner.hpp"
#include "profiles/room_scanner.hpp"
#include "profiles/roughened.hpp"
#include "recorded/building_map.hpp"
#include "stetro_site/grid_caster.hpp"
#include "stetro_site/map_file.hpp"
#include "stetro_site/segment_caster.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_site::Unknown;
using stetro_supervisor::RangeProfile;
using stetro_supervisor::ScannerPose;

constexpr double kRough = 0.3;  // of the cells along a wall's face
constexpr std::uint64_t kSeed = 1;
constexpr double kCell = 0.05;  // of the grid that tells a drawn floor's free space

/// What the map says of its places, and where its walls are: the same for all checks on it.
void work_out(RecordedFloor & floor)
{
  const auto & grid = *floor.grid;
  floor.walls = std::make_shared<const stetro_site::DistanceField>(floor.grid, Unknown::kFree);
  const Eigen::Vector2d low = grid.centre_m({0, 0});
  const Eigen::Vector2d high = grid.centre_m({grid.columns() - 1, grid.rows() - 1});
  floor.layer = std::make_shared<const stetro_supervisor::UsabilityLayer>(
    *floor.map, *floor.free, low, high, stetro_supervisor::UsabilityParams{});
}

RecordedFloor drawn_floor(const std::string & name, const recorded::BuildingLevel & level)
{
  RecordedFloor floor;
  floor.name = name;
  floor.level = level.name;
  floor.drawn = true;
  floor.grid =
    std::make_shared<const stetro_site::OccupancyGrid>(recorded::rasterise(level, kCell));
  floor.free = std::make_shared<const stetro_site::GridFreeSpace>(floor.grid);
  floor.is_free = [free = floor.free](const Eigen::Vector2d & p) { return free->is_free(p); };
  floor.map = std::make_shared<const stetro_site::SegmentCaster>(level.walls);
  floor.world = [walls = level.walls](const ScannerPose & pose, std::size_t beams, double reach_m) {
    RangeProfile scan = scanned(walls, pose, beams);
    for (double & range : scan.ranges_m) {
      range = range < reach_m ? range : std::numeric_limits<double>::infinity();
    }
    return scan;
  };
  work_out(floor);
  return floor;
}

}  // namespace

stetro_supervisor::ScanCheckParams scan_check_params_of(const RecordedFloor & floor)
{
  return stetro_supervisor::scan_check_params(floor.drawn ? 0.0 : floor.grid->resolution_m());
}

RecordedFloor grid_floor(const std::string & name, const std::string & yaml)
{
  RecordedFloor floor;
  floor.name = name;
  floor.grid = std::make_shared<const stetro_site::OccupancyGrid>(stetro_site::load_map(yaml).grid);
  floor.free = std::make_shared<const stetro_site::GridFreeSpace>(floor.grid);
  floor.is_free = [free = floor.free](const Eigen::Vector2d & p) { return free->is_free(p); };
  floor.map = std::make_shared<const stetro_site::GridCaster>(*floor.grid, Unknown::kFree);
  const auto seen = [](std::shared_ptr<const stetro_site::OccupancyGrid> grid) -> World {
    return [grid = std::move(grid)](const ScannerPose & pose, std::size_t beams, double reach_m) {
      return scanned(*grid, pose, beams, reach_m);
    };
  };
  std::mt19937_64 random(kSeed);
  floor.world = seen(floor.grid);
  floor.rough_world = seen(
    std::make_shared<const stetro_site::OccupancyGrid>(roughened(*floor.grid, kRough, random)));
  work_out(floor);
  return floor;
}

std::vector<RecordedFloor> recorded_floors(const std::string & folder)
{
  const std::string maps = folder + "/maps/";
  std::vector<RecordedFloor> floors{
    grid_floor("tau_fl4", maps + "tau_fl4/my_map.yaml"),
    grid_floor("tau_lab446", maps + "tau_lab446/my_map.yaml"),
    grid_floor("uw_hallway", maps + "uw_hallway/map.yaml"),
    grid_floor("tb3_world", maps + "tb3_world/map.yaml")};
  for (const auto & level : recorded::BuildingMap::read(maps + "hotel/hotel.building.yaml")) {
    floors.push_back(drawn_floor("hotel", level));
  }
  return floors;
}

}  // namespace stetro_bringup
