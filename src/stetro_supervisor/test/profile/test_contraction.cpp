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

#include <vector>

#include "stetro_supervisor/profile/contraction.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

TEST(Contraction, EmptyRoomComesHomeInOneStep)
{
  const WallCaster room(rectangle({0.0, 0.0}, {10.0, 10.0}));
  const auto found = contraction(room, {3.0, 7.0}, {720, 30.0, 0.1});
  ASSERT_TRUE(found);
  EXPECT_LT(found->spectral_radius, 0.02) << "the centroid of a convex room stays where it is";
}

TEST(Contraction, CorridorBeyondReachKnowsNothingLengthwise)
{
  const WallCaster corridor(rectangle({-100.0, 0.0}, {100.0, 2.0}));
  const auto found = contraction(corridor, {0.0, 1.2}, {720, 12.0, 0.1});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->jacobian(0, 0), 1.0, 0.02) << "the profile moves along with the scanner";
  EXPECT_LT(found->jacobian(1, 1), 0.5) << "and not across";
}

// A hall with an open side: a third of the beams meet nothing. From places on both sides of the
// truth the search's first step leaves errors whose difference is J e.
TEST(Contraction, IsWhatAStepOfThePublishedSearchLeavesOfAnError)
{
  std::vector<stetro_site::Segment> walls = rectangle({0.0, 0.0}, {9.0, 6.0});
  walls.erase(walls.begin() + 1);  // the side at x = 9
  for (const auto & side : rectangle({3.0, 3.5}, {4.0, 4.5})) {
    walls.push_back(side);
  }
  const WallCaster hall(walls);
  constexpr double kStep = 0.2;
  const Eigen::Vector2d truth{5.5, 2.5};
  const auto found = contraction(hall, truth, as_published({720, 12.0, kStep}));
  ASSERT_TRUE(found);
  RangeProfile scan{{0.0, 6.283185307179586 / 720, 720}, {}};
  hall.cast(truth, scan.fan, 12.0, scan.ranges_m);
  PublishedLimits once;
  once.reach_m = 12.0;
  once.iterations = 1;
  for (const Eigen::Vector2d & error : {Eigen::Vector2d(kStep, 0.0), Eigen::Vector2d(0.0, kStep)}) {
    const auto left_of = [&](const Eigen::Vector2d & e) -> Eigen::Vector2d {
      return published_search(hall, Beams(scan), {truth + e, 0.0}, once).positions_m.back() - truth;
    };
    const Eigen::Vector2d left = 0.5 * (left_of(error) - left_of(-error));
    EXPECT_LT((left - found->jacobian * error).norm(), 1e-9);
  }
}

// A door onto a long passage: the published steps follow its few long beams, the guarded cut them.
TEST(Contraction, OfTheGuardedStepsKnowsTheirCap)
{
  std::vector<stetro_site::Segment> walls = rectangle({0.0, 0.0}, {4.0, 4.0});
  walls.erase(walls.begin() + 1);  // the side at x = 4
  walls.push_back({{4.0, 0.0}, {4.0, 1.9}});
  walls.push_back({{4.0, 2.1}, {4.0, 4.0}});
  for (const auto & side : rectangle({4.0, 1.0}, {40.0, 3.0})) {
    walls.push_back(side);
  }
  walls.erase(walls.end() - 1);  // the passage's end at x = 4 is the door's wall
  const WallCaster room(walls);
  const ContractionParams guarded{1440, 50.0, 0.05};
  const auto steps = contraction(room, {2.0, 1.9}, guarded);
  const auto published = contraction(room, {2.0, 1.9}, as_published(guarded));
  ASSERT_TRUE(steps && published);
  EXPECT_LT(steps->spectral_radius, 0.5 * published->spectral_radius);
}

}  // namespace
}  // namespace stetro_supervisor
