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

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <memory>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "stetro_site/frame_transform.hpp"
#include "support/lidar_in_two_floors.hpp"

namespace stetro_supervisor
{

/// The ground floor in cells of 5 cm that lie askew to its walls, which the scans are of.
class ProfileWitnessOnCells : public LidarInTwoFloors
{
protected:
  ProfileWitnessOnCells()
  {
    const auto & walls = std::get<stetro_site::PolygonWalls>(floors[0]->floor().drawing);
    stetro_site::GridFrame frame;
    frame.columns = 170;
    frame.rows = 150;
    frame.resolution_m = 0.05;
    frame.origin_m = {0.9, -1.7};
    frame.yaw_rad = 0.35;
    const stetro_site::OccupancyGrid empty{
      frame, std::vector<stetro_site::Cell>(170 * 150, stetro_site::Cell::kFree)};
    auto cells = empty.cells();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Eigen::Vector2d at = empty.centre_m(empty.cell(i));
      const bool inside = stetro_site::encloses(walls.outline, at) &&
                          !stetro_site::encloses(walls.obstacles.at(0), at);
      cells[i] = inside ? stetro_site::Cell::kFree : stetro_site::Cell::kOccupied;
    }
    stetro_site::SiteSpec spec;
    spec.name = "mapped";
    spec.floors.push_back(
      {"ground",
       {},
       stetro_site::GridMapFile{
         "", std::make_shared<const stetro_site::OccupancyGrid>(frame, std::move(cells))}});
    mapped = std::make_unique<DrawnFloor>(stetro_site::Site{spec}, "ground", params.resolution_m);
  }

  FloorPlace anywhere()
  {
    std::uniform_real_distribution<double> x{0.4, 4.6};
    std::uniform_real_distribution<double> y{0.4, 3.6};
    std::uniform_real_distribution<double> yaw{-3.1, 3.1};
    FloorPlace place{"ground", {0.0, 0.0}, 0.0, Eigen::Matrix3d::Zero()};
    while (mapped->free_space().clearance_m(place.position_m) < 0.3) {
      place.position_m = {x(random), y(random)};
      place.yaw_rad = yaw(random);
    }
    return place;
  }

  std::unique_ptr<DrawnFloor> mapped;
};

// By how many of its own standard deviations it is wrong is chi-square of three: below 16.3 in 999
// of 1000 cases, were the cells' errors normal.
TEST_F(ProfileWitnessOnCells, KnowsThatCellsErr)
{
  ProfileWitness witness{*mapped, lidar, params};
  std::normal_distribution<double> off{0.0, 0.05};
  int found = 0;
  double worst = 0.0;
  constexpr int kCases = 100;
  for (int i = 0; i < kCases; ++i) {
    const FloorPlace truth = anywhere();
    FloorPlace told = truth;
    told.position_m += Eigen::Vector2d(off(random), off(random));
    const auto testimony = witness.about(*scan_at(0, truth), told);
    if (!testimony.found) {
      continue;
    }
    ++found;
    const auto & place = *testimony.found;
    Eigen::Vector3d error;
    error << place.position_m - truth.position_m,
      stetro_site::wrap_angle(place.yaw_rad - truth.yaw_rad);
    worst = std::max(worst, error.dot(place.covariance.ldlt().solve(error)));
    EXPECT_LT(error.head<2>().norm(), 0.05) << "case " << i;
  }
  EXPECT_GE(found, 97);
  EXPECT_LT(worst, 16.3);
}

}  // namespace stetro_supervisor
