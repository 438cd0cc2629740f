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

#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/floor/floor_search.hpp"
#include "support/lidar_in_two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::wrap_angle;

constexpr double kPi = 3.14159265358979312;

}  // namespace

class FloorSearchTest : public LidarInTwoFloors
{
protected:
  FloorSearchTest()
  {
    for (const auto & floor : floors) {
      witnesses.emplace_back(*floor, lidar, params);
    }
  }

  SearchAnswer search(const std::shared_ptr<const Scan> & scan, std::vector<ProfileWitness *> asked)
  {
    FloorSearch search{std::move(asked), scan, lidar, params};
    for (int i = 0; i < 1000; ++i) {
      const auto began = std::chrono::steady_clock::now();
      const auto answer = search.step();
      longest_s = std::max(
        longest_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
      steps = i;
      if (answer) {
        return *answer;
      }
    }
    return {};
  }

  std::vector<ProfileWitness *> all()
  {
    std::vector<ProfileWitness *> asked;
    for (auto & witness : witnesses) {
      asked.push_back(&witness);
    }
    return asked;
  }

  std::vector<ProfileWitness> witnesses;
  double longest_s = 0.0;
  int steps = 0;
};

TEST_F(FloorSearchTest, FindsTheFloorThePlaceAndTheHeading)
{
  const FloorPlace truth{"landing", {11.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  const auto answer = search(scan_at(1, truth), all());
  ASSERT_TRUE(answer.found) << answer.reason;
  EXPECT_EQ(answer.found->floor_id, "landing");
  EXPECT_LT((answer.found->position_m - truth.position_m).norm(), 0.02);
  EXPECT_NEAR(wrap_angle(answer.found->yaw_rad - truth.yaw_rad), 0.0, 0.01);
  std::cout << steps << " steps, the longest " << 1e3 * longest_s << " ms\n";
}

// Property: wherever the robot stands on a floor that it knows, the answer is right or none.
TEST_F(FloorSearchTest, IsNeverWrongOnRandomPlaces)
{
  std::uniform_real_distribution<double> x{0.4, 4.6};
  std::uniform_real_distribution<double> y{0.4, 3.6};
  std::uniform_real_distribution<double> yaw{-kPi, kPi};
  int found = 0;
  int tried = 0;
  while (tried < 12) {
    const FloorPlace truth{"ground", {x(random), y(random)}, yaw(random), Eigen::Matrix3d::Zero()};
    if (floors[0]->free_space().clearance_m(truth.position_m) < 0.3) {
      continue;
    }
    ++tried;
    const auto answer = search(scan_at(0, truth), {&witnesses[0]});
    if (answer.found) {
      ++found;
      EXPECT_LT((answer.found->position_m - truth.position_m).norm(), 0.03) << tried;
      EXPECT_NEAR(wrap_angle(answer.found->yaw_rad - truth.yaw_rad), 0.0, 0.02) << tried;
    } else {
      std::cout << tried << ": " << answer.reason << "\n";
    }
  }
  EXPECT_GE(found, 11);
}

TEST_F(FloorSearchTest, BearsPeopleAndABox)
{
  const FloorPlace truth{"ground", {1.5, 2.4}, -0.7, Eigen::Matrix3d::Zero()};
  auto strangers = rectangle({3.4, 2.6}, {3.8, 3.0});
  for (const auto & leg :
       {rectangle({1.0, 1.4}, {1.12, 1.52}), rectangle({1.2, 1.4}, {1.32, 1.5})}) {
    strangers.insert(strangers.end(), leg.begin(), leg.end());
  }
  const auto answer = search(scan_at(0, truth, strangers), {&witnesses[0]});
  ASSERT_TRUE(answer.found) << answer.reason;
  EXPECT_LT((answer.found->position_m - truth.position_m).norm(), 0.03);
}

TEST_F(FloorSearchTest, SaysNothingOfAScanFromAnotherFloor)
{
  const FloorPlace truth{"landing", {11.2, 1.3}, 2.1, Eigen::Matrix3d::Zero()};
  const auto answer = search(scan_at(1, truth), {&witnesses[0]});
  EXPECT_FALSE(answer.found);
  EXPECT_EQ(answer.verdict, Verdict::kNoVerdict);
  EXPECT_FALSE(answer.reason.empty());
}

// On 290 000 cells a table takes up to 0.3 s, and a tick of the supervisor lasts 0.05 s.
TEST_F(FloorSearchTest, BuildsTheTablesOfALargeFloorOverManySteps)
{
  constexpr int kCells = 538;
  stetro_site::GridFrame frame;
  frame.columns = frame.rows = kCells;
  frame.resolution_m = 0.05;
  std::vector<stetro_site::Cell> hall(kCells * kCells, stetro_site::Cell::kFree);
  for (std::size_t i = 0; i < kCells; ++i) {
    for (const std::size_t wall :
         {i, (kCells - 1) * kCells + i, i * kCells, (i + 1) * kCells - 1}) {
      hall[wall] = stetro_site::Cell::kOccupied;
    }
  }
  stetro_site::SiteSpec spec;
  spec.name = "hall";
  spec.floors.push_back(
    {"hall",
     {},
     stetro_site::GridMapFile{
       "", std::make_shared<const stetro_site::OccupancyGrid>(frame, std::move(hall))}});
  const stetro_site::Site site_of_hall{spec};
  const DrawnFloor floor{site_of_hall, "hall", params.resolution_m};
  ProfileWitness witness{floor, lidar, params};
  FloorSearch search{
    {&witness}, scan_at(0, {"ground", {1.0, 1.0}, 0.4, Eigen::Matrix3d::Zero()}), lidar, params};
  for (steps = 0; !witness.headings().is_built(0); ++steps) {
    ASSERT_FALSE(search.step());
  }
  // Four of its eight tables look along diagonals: on average past a third of one, 250 cells, from
  // each of 290 000 cells, 4 million of which are a tick's work.
  EXPECT_NEAR(steps, 4 * 250 * 0.29 / 4.0, 10);
}

// A square room looks the same from four places.
TEST_F(FloorSearchTest, IsAmbiguousInASquareRoom)
{
  stetro_site::SiteSpec spec;
  spec.name = "square";
  spec.floors.push_back(
    {"square",
     {},
     stetro_site::PolygonWalls{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}, {}}});
  const stetro_site::Site square{spec};
  floors[0] = std::make_unique<DrawnFloor>(square, "square", params.resolution_m);
  ProfileWitness witness{*floors[0], lidar, params};
  const FloorPlace truth{"square", {1.0, 1.4}, 0.4, Eigen::Matrix3d::Zero()};
  const auto answer = search(scan_at(0, truth), {&witness});
  EXPECT_EQ(answer.verdict, Verdict::kAmbiguous) << answer.reason;
  EXPECT_EQ(answer.alternatives.size(), 3u);
  EXPECT_FALSE(answer.found);
}

}  // namespace stetro_supervisor
