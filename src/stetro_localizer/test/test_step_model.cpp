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

#include <limits>
#include <stdexcept>

#include "stetro_config/field.hpp"
#include "support/stair_models.hpp"

namespace stetro_localizer
{
namespace
{

/// Votes of a touch-down one tread higher by heights and load alone.
LiftVotes touch_down(double level_m)
{
  LiftVotes votes;
  votes.open = votes.lift_seen = true;
  votes.bearing = true;
  votes.level_m = level_m;
  votes.block1_above = 1;
  return votes;
}

TEST(ReadingModel, IsADensityWithAFloor)
{
  const ReadingModel model{0.01, 0.05, 1.2};
  // flat top 0.075 wide: 0.95 / (0.075 + 0.01 sqrt(2 pi)) + 0.05 / 1.2
  EXPECT_NEAR(model.density(0.05, {0.035, 0.11}), 9.53538, 1e-5);
  // two standard deviations beyond: e^-2 of the first term
  EXPECT_NEAR(model.density(0.13, {0.035, 0.11}), 9.49371 * 0.135335 + 0.04167, 1e-4);
  EXPECT_NEAR(model.density(1.0, {0.035, 0.11}), 0.05 / 1.2, 1e-12) << "the floor";
  double mass = 0.0;
  for (int i = -600; i < 600; ++i) {
    mass += model.density(i * 0.001, {0.035, 0.11}) * 0.001;
  }
  EXPECT_NEAR(mass, 1.0, 1e-6);
}

TEST(ReadingWindow, IsNotMovedByASpike)
{
  ReadingWindow window;
  EXPECT_FALSE(window.median());
  for (const double value : {0.10, 0.11, 0.90, 0.12, 0.02, 0.11}) {
    window.add(value);
  }
  EXPECT_NEAR(window.median().value(), 0.11, 1e-7) << "of the last five";
}

// 0.5 x 0.45 x 99.7346 x 0.995 x 0.98: prior, height at its mode, load right, motion flag right.
TEST(StepModel, WeighsATouchDownAsWorkedByHand)
{
  const LiftWeights weights = papers().weigh(3, touch_down(kRiser));
  EXPECT_NEAR(weights.landed[2], 21.88152, 1e-4);
  EXPECT_NEAR(weights.landed[1], 0.05 * 1e-5 * 0.9751, 1e-12) << "35 standard deviations off";
  EXPECT_NEAR(weights.landed[0], 0.225 * 1e-5 * 0.9751, 1e-12);
  // halts in the air below the lock, 0.1 / (span + 0.01003), over each of the three treads
  EXPECT_NEAR(weights.aloft, 1.12440e-3 + 6.5781e-5 + 1.70445e-4, 1e-8);
  EXPECT_NEAR(weights.jump, 1e-3 * 0.9751, 1e-9);
  EXPECT_NEAR(weights.landed[2] / weights.sum(), 0.999893, 1e-6);
}

TEST(StepModel, LetsEachVoteChangeTheOddsByItsLikelihoodRatio)
{
  LiftVotes votes = touch_down(0.0);
  const auto odds = [](const LiftVotes & v) {
    const LiftWeights weights = papers().weigh(3, v);
    return weights.landed[2] / weights.landed[1];
  };
  const double before = odds(votes);
  votes.travel_m = 0.16;  // sigma 15.75 mm: 0.95 / (0.15 + 0.03948) + 0.05 against 0.05
  EXPECT_NEAR(odds(votes) / before, 101.3, 0.1) << "the wheels say: one tread higher";
  votes.travel_m.reset();
  votes.block3_front_m = 0.036;
  EXPECT_GT(odds(votes) / before, 100.0) << "and so does block3_front";
  votes.travel_m = 0.16;
  const LiftWeights weights = papers().weigh(3, votes);
  EXPECT_GT(weights.landed[1], 0.9 * weights.sum()) << "but the height outweighs both";
  votes.switch_way_m = 0.01;
  EXPECT_LT(odds(votes), 1e-4) << "the riser is where it was before the roll";
}

TEST(StepModel, KnowsTheEndsOfTheFlight)
{
  LiftVotes votes = touch_down(kRiser);
  EXPECT_EQ(papers().weigh(kSteps, votes).landed[2], 0.0);
  votes.level_m = -kRiser;
  EXPECT_EQ(papers().weigh(0, votes).landed[0], 0.0);
  votes.level_m = kRiser;
  votes.front_m = std::numeric_limits<double>::infinity();
  EXPECT_GT(papers().weigh(15, votes).landed[2], 5.0 * papers().weigh(14, votes).landed[2])
    << "nothing ahead: block 1 is on the landing";
}

TEST(StepModel, RefusesRisersThatTheHeightsCannotTell)
{
  EXPECT_THROW(model_of({{0.019, 0.3}}), std::invalid_argument);
}

TEST(StepFilterParams, AreInTheirOwnBounds)
{
  StepFilterParams params;
  stetro_config::FieldCollector list;
  visit_step_filter(params, list);
  for (const stetro_config::Field & field : list.take()) {
    EXPECT_TRUE(field.accepts(field.get())) << field.name;
  }
}

}  // namespace
}  // namespace stetro_localizer
