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

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "stetro_supervisor/floor/range_search.hpp"
#include "support/lidar_in_two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr Time kNow = std::chrono::seconds{1000};

}  // namespace

class RangeSearchTest : public LidarInTwoFloors
{
protected:
  /// What the four sensors read on a floor, by the walls themselves and with 2 cm of error.
  Observation seen_from(std::size_t floor, const FloorPlace & place, double reach_m = 1.2)
  {
    const WallCaster walls{stetro_site::wall_segments(
      std::get<stetro_site::PolygonWalls>(floors[floor]->floor().drawing))};
    std::uniform_real_distribution<double> error{-0.02, 0.02};
    Observation seen;
    const auto read = [&](stetro_site::Place sensor, double yaw_rad) {
      const auto & mounting = robot.at(sensor);
      std::vector<double> range;
      walls.cast(
        place.position_m + rotation(place.yaw_rad) * Eigen::Vector2d(mounting.x_m, mounting.y_m),
        {place.yaw_rad + yaw_rad, 0.1, 1}, reach_m, range);
      Range & said = seen.ranges[stetro_site::index_of(sensor)].emplace();
      said.time = kNow;
      said.status = std::isfinite(range[0]) ? RangeStatus::kValid : RangeStatus::kNoTarget;
      said.range_m = range[0] + error(random);
    };
    read(stetro_site::Place::kFrontLeft, 0.0);
    read(stetro_site::Place::kFrontRight, 0.0);
    read(stetro_site::Place::kSideLeft, 1.5707963267948966);
    read(stetro_site::Place::kSideRight, -1.5707963267948966);
    return seen;
  }

  RangeAnswer search(const Observation & seen, std::vector<ProfileWitness *> asked)
  {
    RangeSearch search{std::move(asked), range_beams_of(seen, kNow, robot, params)};
    for (int i = 0; i < 2000; ++i) {
      if (const auto answer = search.step()) {
        return *answer;
      }
    }
    return {};
  }

  stetro_site::RobotGeometry robot;
  ProfileWitness ground{*floors[0], lidar, params};
  ProfileWitness landing{*floors[1], lidar, params};
};

TEST_F(RangeSearchTest, TakesWhatIsHeardAndHealthy)
{
  Observation seen = seen_from(0, {"ground", {1.0, 1.0}, 0.3, Eigen::Matrix3d::Zero()});
  seen.ranges[stetro_site::index_of(stetro_site::Place::kFrontLeft)]->status =
    RangeStatus::kNoTarget;
  seen.ranges[stetro_site::index_of(stetro_site::Place::kSideLeft)]->status = RangeStatus::kStale;
  seen.ranges[stetro_site::index_of(stetro_site::Place::kSideRight)]->time -= std::chrono::hours{1};
  const RangeBeams beams = range_beams_of(seen, kNow, robot, params);
  ASSERT_EQ(beams.beams.size(), 2u);
  EXPECT_EQ(beams.ranges_m[0], kNone);
  EXPECT_NEAR(beams.beams[0].origin_m.x(), 0.19, 1e-12);
}

// Four ranges of 1.2 m leave most of a room: wherever the robot is, that is what the answer says.
TEST_F(RangeSearchTest, IsAmbiguousOnRealFloors)
{
  std::uniform_real_distribution<double> x{0.4, 4.6};
  std::uniform_real_distribution<double> y{0.4, 3.6};
  std::uniform_real_distribution<double> yaw{-3.1, 3.1};
  for (int i = 0; i < 8;) {
    const FloorPlace truth{"ground", {x(random), y(random)}, yaw(random), Eigen::Matrix3d::Zero()};
    if (floors[0]->free_space().clearance_m(truth.position_m) < 0.3) {
      continue;
    }
    ++i;
    const auto answer = search(seen_from(0, truth), {&ground, &landing});
    EXPECT_EQ(answer.verdict, Verdict::kAmbiguous) << answer.reason;
    EXPECT_FALSE(answer.found);
    EXPECT_GT(answer.area_m2, 0.5) << answer.reason;
  }
}

TEST_F(RangeSearchTest, SaysWhenNoPlaceAgrees)
{
  Observation seen = seen_from(0, {"ground", {1.0, 1.0}, 0.3, Eigen::Matrix3d::Zero()});
  for (auto & range : seen.ranges) {
    if (range) {
      range->range_m = 30.0;
      range->status = RangeStatus::kValid;
    }
  }
  const auto answer = search(seen, {&ground});
  EXPECT_EQ(answer.verdict, Verdict::kNoVerdict);
  EXPECT_NE(answer.reason.find("no place agrees with all"), std::string::npos) << answer.reason;
}

// A closet with one deep bay is told by sensors that reach all of its walls.
TEST_F(RangeSearchTest, FindsTheOnlyPlace)
{
  stetro_site::SiteSpec spec;
  spec.name = "closet";
  spec.floors.push_back(
    {"closet",
     {},
     stetro_site::PolygonWalls{
       {{0.0, 0.0}, {1.5, 0.0}, {1.5, 0.6}, {3.0, 0.6}, {3.0, 1.3}, {0.0, 1.3}}, {}}});
  floors[0] = std::make_unique<DrawnFloor>(stetro_site::Site{spec}, "closet", 0.02);
  params.beam_error_m = 0.03;
  robot.range_sensor.reliable_range_m = 4.0;
  ProfileWitness closet{*floors[0], lidar, params};
  const FloorPlace truth{"closet", {0.5, 0.95}, 0.0, Eigen::Matrix3d::Zero()};
  const auto answer = search(seen_from(0, truth, 4.0), {&closet});
  ASSERT_TRUE(answer.found) << answer.reason;
  EXPECT_LT((answer.found->position_m - truth.position_m).norm(), 0.15);
  EXPECT_NEAR(answer.found->yaw_rad, 0.0, 0.15);
}

}  // namespace stetro_supervisor
