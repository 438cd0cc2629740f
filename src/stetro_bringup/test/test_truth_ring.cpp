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

#include "accuracy/truth_ring.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

TEST(TruthRing, MeetsAnEstimateAtItsOwnTime)
{
  TruthRing ring;
  EXPECT_FALSE(ring.at(1000ms));
  stetro_driver::GroundTruth truth;
  for (int tick = 0; tick < 200; ++tick) {
    truth.time = 1000ms + tick * 10ms;
    truth.y_m = 0.001 * tick;
    truth.step = tick < 150 ? 1 : 2;
    ring.add(truth);
  }
  EXPECT_NEAR(ring.at(2000ms)->y_m, 0.100, 1e-12);
  EXPECT_NEAR(ring.at(2003ms)->y_m, 0.1003, 1e-12) << "between two ticks";
  EXPECT_EQ(ring.at(2495ms)->step, 1);
  EXPECT_EQ(ring.at(2500ms)->step, 2);
  EXPECT_FALSE(ring.at(3000ms)) << "that is the future";
  EXPECT_FALSE(ring.at(1500ms)) << "that is forgotten";
}

// A quarter of the way from one tick to the next, and the step changes with the later one: the body
// moves on, what is told of a tread stays the earlier tread's.
TEST(TruthRing, MixesWhatMovesAndKeepsWhatBelongsToATread)
{
  stetro_driver::GroundTruth before;
  before.time = 1000ms;
  before.step = 1;
  before.x_m = 0.100;
  before.yaw_rad = 0.02;
  before.z_m = 0.14;
  before.tread_x_m = 0.300;
  before.riser_ahead_m = 0.020;
  stetro_driver::GroundTruth after = before;
  after.time = 1008ms;
  after.x_m = 0.104;
  after.yaw_rad = -0.02;
  after.tread_x_m = 0.304;
  after.riser_ahead_m = 0.016;
  TruthRing same_tread;
  same_tread.add(before);
  same_tread.add(after);
  const auto mixed = same_tread.at(1002ms);
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->time, 1002ms);
  EXPECT_NEAR(mixed->x_m, 0.101, 1e-12);
  EXPECT_NEAR(mixed->yaw_rad, 0.01, 1e-12);
  EXPECT_NEAR(mixed->tread_x_m, 0.301, 1e-12);
  EXPECT_NEAR(mixed->riser_ahead_m, 0.019, 1e-12);

  after.step = 2;
  after.z_m = 0.28;
  after.tread_x_m = -0.016;
  after.riser_ahead_m = 0.336;
  TruthRing next_tread;
  next_tread.add(before);
  next_tread.add(after);
  const auto stepping = next_tread.at(1002ms);
  ASSERT_TRUE(stepping);
  EXPECT_EQ(stepping->step, 1);
  EXPECT_EQ(stepping->z_m, 0.14);
  EXPECT_NEAR(stepping->x_m, 0.101, 1e-12);
  EXPECT_EQ(stepping->tread_x_m, 0.300);
  EXPECT_EQ(stepping->riser_ahead_m, 0.020);
  EXPECT_EQ(next_tread.at(1008ms)->riser_ahead_m, 0.336);
  EXPECT_FALSE(next_tread.at(999ms)) << "before the first";
}

TEST(TruthRing, KeepsItsLastHundredAndTwentyEightTicks)
{
  TruthRing ring;
  stetro_driver::GroundTruth truth;
  for (int tick = 0; tick <= static_cast<int>(TruthRing::kKept); ++tick) {
    truth.time = tick * 10ms;
    ring.add(truth);
  }
  EXPECT_FALSE(ring.at(0ms)) << "pushed out by the last";
  EXPECT_FALSE(ring.at(9ms));
  EXPECT_TRUE(ring.at(10ms));
  EXPECT_TRUE(ring.at(1280ms));
}

}  // namespace
}  // namespace stetro_bringup
