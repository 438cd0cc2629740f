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

#ifndef SUPPORT__LIDAR_IN_TWO_FLOORS_HPP_
#define SUPPORT__LIDAR_IN_TWO_FLOORS_HPP_

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <variant>
#include <vector>

#include "stetro_site/wall_segments.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/profile_witness.hpp"
#include "support/two_floors.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{

/// A lidar that may stand anywhere on the floors `ground`, `landing` and `first`.
class LidarInTwoFloors : public testing::Test
{
protected:
  LidarInTwoFloors()
  {
    lidar.x_m = 0.05;
    lidar.yaw_rad = 0.3;
    for (const char * id : {"ground", "landing", "first"}) {
      floors.push_back(std::make_unique<DrawnFloor>(site, id, params.resolution_m));
    }
  }

  /// With 1 cm of noise, and 3 of 100 beams without an echo. \param more walls that no map has
  std::shared_ptr<Scan> scan_at(
    std::size_t floor, const FloorPlace & place,
    const std::vector<stetro_site::Segment> & more = {})
  {
    constexpr double kPi = 3.14159265358979312;
    auto walls = stetro_site::wall_segments(
      std::get<stetro_site::PolygonWalls>(floors[floor]->floor().drawing));
    walls.insert(walls.end(), more.begin(), more.end());
    const ScannerPose at = scanner_at(place, lidar);
    auto scan = std::make_shared<Scan>();
    scan->profile.fan = {-kPi, 2.0 * kPi / 360.0, 360};
    auto fan = scan->profile.fan;
    fan.first_rad += at.yaw_rad;
    WallCaster{walls}.cast(at.position_m, fan, 12.0, scan->profile.ranges_m);
    std::normal_distribution<double> noise{0.0, 0.01};
    std::bernoulli_distribution drops{0.03};
    for (double & range : scan->profile.ranges_m) {
      range = drops(random) ? HUGE_VAL : range + noise(random);
    }
    return scan;
  }

  const stetro_site::Site site = two_floors(16, 8);
  stetro_site::Lidar lidar;
  FloorParams params;
  std::vector<std::unique_ptr<DrawnFloor>> floors;
  std::mt19937 random{20260303};
};

}  // namespace stetro_supervisor

#endif  // SUPPORT__LIDAR_IN_TWO_FLOORS_HPP_
