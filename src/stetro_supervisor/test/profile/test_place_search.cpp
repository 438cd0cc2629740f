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

#include <algorithm>
#include <cmath>
#include <vector>

#include "stetro_supervisor/profile/circular_misfit.hpp"
#include "stetro_supervisor/profile/place_search.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kPi = 3.141592653589793;

TEST(CircularMisfit, CountsTheScanFromAnotherBeam)
{
  const std::vector<double> model{1.0, 2.0, 3.0, 4.0};
  const std::vector<double> scan{3.0, 4.0, 1.0, 2.0};  // begins two beams on
  EXPECT_DOUBLE_EQ(circular_misfit(scan, model, 2, 10.0), 0.0);
  EXPECT_DOUBLE_EQ(circular_misfit(scan, model, 0, 10.0), 2.0);
  EXPECT_DOUBLE_EQ(circular_misfit(scan, model, 0, 0.5), 0.5) << "capped";
}

class PlaceSearch : public ::testing::Test
{
protected:
  Beams scanned(const ScannerPose & pose) const
  {
    RangeProfile scan;
    scan.fan = {0.0, 2.0 * kPi / 72.0, 72};
    map_.cast(pose.position_m, {pose.yaw_rad, scan.fan.step_rad, 72}, 30.0, scan.ranges_m);
    return Beams(scan);
  }

  SearchGrid grid_{0.5, 4000, 6, 30.0};
  const WallCaster map_{rectangle({0.0, 0.0}, {9.0, 5.0})};
  const FreeSpace everywhere_ = [](const Eigen::Vector2d & p) {
    return p.x() > 0.0 && p.x() < 9.0 && p.y() > 0.0 && p.y() < 5.0;
  };
};

TEST_F(PlaceSearch, BestPlaceIsNextToTheTruth)
{
  const ScannerPose truth{{2.2, 3.7}, 0.3};
  const SearchArea area{{{5.0, 2.0}, 0.3}, 4.0, 0.0};
  const auto places = likely_places(map_, everywhere_, scanned(truth), area, grid_);
  ASSERT_FALSE(places.empty());
  EXPECT_LT((places[0].pose.position_m - truth.position_m).norm(), 0.5);
}

TEST_F(PlaceSearch, OblongRoomLooksAlikeFromTwoHeadings)
{
  const ScannerPose truth{{3.0, 2.0}, 0.0};
  const SearchArea area{{{4.5, 2.5}, 0.0}, 3.0, kPi};
  const auto places = likely_places(map_, everywhere_, scanned(truth), area, grid_);
  ASSERT_GE(places.size(), 2u);
  const auto near = [&](const ScannerPose & pose) {
    return std::any_of(places.begin(), places.begin() + 2, [&pose](const Place & place) {
      return (place.pose.position_m - pose.position_m).norm() < 0.5 &&
             std::abs(std::remainder(place.pose.yaw_rad - pose.yaw_rad, 2.0 * kPi)) < 0.2;
    });
  };
  EXPECT_TRUE(near(truth));
  EXPECT_TRUE(near({{6.0, 3.0}, kPi})) << "the same place turned about the centre";
}

TEST_F(PlaceSearch, TriesOnlyFreePlaces)
{
  const SearchArea area{{{4.5, 2.5}, 0.0}, 3.0, 0.0};
  const auto places = likely_places(
    map_, [](const Eigen::Vector2d &) { return false; }, scanned({{3.0, 2.0}, 0.0}), area, grid_);
  EXPECT_TRUE(places.empty());
}

}  // namespace
}  // namespace stetro_supervisor
