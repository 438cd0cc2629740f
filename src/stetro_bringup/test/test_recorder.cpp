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

#include "stetro_bringup/recorder.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;
using Time = std::chrono::nanoseconds;

Estimate estimate_at(Time stamp)
{
  Estimate estimate;
  estimate.sample.stamp = stamp;
  estimate.block_heights_m = {0.28, 0.14, 0.14};
  return estimate;
}

StairSample truth_at(Time stamp, double y_m)
{
  StairSample truth;
  truth.stamp = stamp;
  truth.y_m = y_m;
  return truth;
}

struct Rows
{
  std::vector<TraceRow> rows;
  std::vector<bool> standing;
  Recorder recorder{[this](const TraceRow & row, bool stands) {
    rows.push_back(row);
    standing.push_back(stands);
  }};
};

}  // namespace

TEST(Recorder, WaitsForWhatIsStillOnItsWay)
{
  Rows seen;
  seen.recorder.add_estimate(estimate_at(1000ms));
  EXPECT_TRUE(seen.rows.empty());
  seen.recorder.add_truth(truth_at(1000ms, 0.7));  // overtaken by the estimate
  seen.recorder.add_range(1000ms, "side_left", 0.6);
  seen.recorder.add_outcome(1000ms, "side_left", "fused");
  seen.recorder.add_estimate(estimate_at(1200ms));
  ASSERT_EQ(seen.rows.size(), 1u);
  ASSERT_TRUE(seen.rows[0].truth.has_value());
  EXPECT_DOUBLE_EQ(seen.rows[0].truth->y_m, 0.7);
  EXPECT_DOUBLE_EQ(seen.rows[0].sensors.at("side_left").range_m, 0.6);
  EXPECT_EQ(seen.rows[0].sensors.at("side_left").outcome, "fused");
}

TEST(Recorder, TakesTheTruthNearestInTimeAndNoneThatIsFarAway)
{
  Rows seen;
  seen.recorder.add_truth(truth_at(996ms, 1.0));
  seen.recorder.add_truth(truth_at(1003ms, 2.0));
  seen.recorder.add_estimate(estimate_at(1000ms));
  seen.recorder.add_estimate(estimate_at(1050ms));
  seen.recorder.flush();
  ASSERT_EQ(seen.rows.size(), 2u);
  EXPECT_DOUBLE_EQ(seen.rows[0].truth->y_m, 2.0);
  EXPECT_FALSE(seen.rows[1].truth.has_value());
}

TEST(Recorder, GivesRowsInOrderOfTime)
{
  Rows seen;
  seen.recorder.add_estimate(estimate_at(1033ms));
  seen.recorder.add_estimate(estimate_at(1000ms));
  seen.recorder.flush();
  ASSERT_EQ(seen.rows.size(), 2u);
  EXPECT_LT(seen.rows[0].estimate.stamp, seen.rows[1].estimate.stamp);
}

TEST(Recorder, TellsStandingFromClimbing)
{
  Rows seen;
  auto lifted = estimate_at(1000ms);
  lifted.block_heights_m = {0.28, 0.32, 0.14};
  seen.recorder.add_estimate(lifted);
  seen.recorder.add_estimate(estimate_at(1100ms));
  seen.recorder.flush();
  EXPECT_EQ(seen.standing, (std::vector<bool>{false, true}));
}

}  // namespace stetro_bringup
