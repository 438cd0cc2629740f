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

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "support/hand_set_blocks.hpp"

namespace stetro_localizer
{
namespace
{

TEST(StepFilterStart, RefusesWhatItIsToldIfTheBlocksCannotStandSo)
{
  HandSetBlocks level;
  level.filter.tell(5);
  EXPECT_EQ(level.stand({0.0, 0.0, 0.0}), StepEvent::kLost);
  HandSetBlocks foot;
  foot.filter.assume_foot();
  EXPECT_EQ(foot.stand({0.14, 0.0, 0.0}), StepEvent::kLost) << "may be any tread";
  for (const int step : {-1, 17, 200}) {
    EXPECT_FALSE(foot.filter.has(step));
    EXPECT_THROW(foot.filter.tell(step), std::invalid_argument) << step;
    StepState stored;
    stored.step = step;
    EXPECT_THROW(foot.filter.restore(stored), std::invalid_argument) << step;
  }
}

TEST(StepFilterStart, HoldsWhatItIsToldForMostProbableUntilTheBlocksHaveSettled)
{
  HandSetBlocks sweeping;
  sweeping.filter.tell(5);
  EXPECT_EQ(sweeping.filter.most_probable(), 5);
  EXPECT_FALSE(sweeping.filter.step()) << "not yet certain";
  sweeping.stand({0.14, 0.0, 0.0});
  EXPECT_EQ(sweeping.filter.most_probable(), 5);
  EXPECT_EQ(sweeping.filter.step(), 5);
  HandSetBlocks level;
  level.filter.tell(5);
  level.stand({0.0, 0.0, 0.0});
  EXPECT_FALSE(level.filter.most_probable()) << "the blocks cannot stand so";
}

struct Restart
{
  const char * what;
  std::array<double, 3> heights_m;
  std::array<bool, 3> bearing;
  std::optional<int> step;
};

TEST(StepFilterStart, ResolvesARestartWithTheBlockAloft)
{
  const std::vector<Restart> cases{
    {"still aloft", {0.14, 0.18, 0.0}, {true, false, true}, 3},
    {"still aloft, half way down", {0.14, 0.16, 0.0}, {true, false, true}, 3},
    {"touched down one higher", {0.14, 0.14, 0.0}, {true, true, true}, 4},
    {"touched down on the old tread", {0.14, 0.0, 0.0}, {true, true, true}, 3},
    {"block 1 moved too", {0.28, 0.14, 0.0}, {true, true, true}, {}},
    {"half a riser", {0.14, 0.07, 0.0}, {true, true, true}, {}},
  };
  for (const Restart & restart : cases) {
    HandSetBlocks after;
    after.filter.restore(aloft_over(3).filter.state_to_store().value());
    EXPECT_FALSE(after.filter.step()) << "not before the blocks were seen";
    EXPECT_TRUE(after.filter.state_to_store()) << "what was stored is not lost meanwhile";
    after.hold(restart.heights_m, restart.bearing);
    EXPECT_EQ(after.filter.step(), restart.step) << restart.what;
  }
}

TEST(StepFilterStart, ResolvesARestartOfAStandingRobot)
{
  const std::vector<Restart> cases{
    {"as it was", {0.14, 0.0, 0.0}, {true, true, true}, 3},
    {"block 2 lifted meanwhile", {0.14, 0.05, 0.0}, {true, false, true}, 3},
    {"block 3 lifted meanwhile", {0.14, 0.0, 0.04}, {true, true, false}, 3},
    {"all stand, otherwise", {0.14, 0.14, 0.0}, {true, true, true}, {}},
    {"level", {0.0, 0.0, 0.0}, {true, true, true}, {}},
  };
  for (const Restart & restart : cases) {
    HandSetBlocks after;
    after.filter.restore(sweeping(3).filter.state_to_store().value());
    after.hold(restart.heights_m, restart.bearing);
    EXPECT_EQ(after.filter.step(), restart.step) << restart.what;
  }
  HandSetBlocks on;
  on.filter.restore(sweeping(3).filter.state_to_store().value());
  on.hold({0.14, 0.05, 0.0}, {true, false, true});
  on.hold({0.14, 0.18, 0.0}, {true, false, true});
  on.stand({0.14, 0.14, 0.0});
  EXPECT_EQ(on.filter.step(), 4) << "the lift-off is what was stored";
}

}  // namespace
}  // namespace stetro_localizer
