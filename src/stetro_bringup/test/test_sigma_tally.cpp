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

#include "accuracy/sigma_tally.hpp"

namespace stetro_bringup
{

TEST(SigmaTally, CountsWhatItsSigmaExplains)
{
  SigmaTally tally;
  tally.add(0.001, 0.002);    // half a sigma
  tally.add(-0.0039, 0.002);  // 1.95
  tally.add(0.004, 0.002);    // 2
  EXPECT_EQ(tally.count(), 3u);
  EXPECT_NEAR(tally.inside_95(), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(tally.mean_square(), (0.25 + 1.95 * 1.95 + 4.0) / 3.0, 1e-9);
}

TEST(SigmaTally, LeavesOutWhatIsNotKnown)
{
  SigmaTally tally;
  tally.add(std::nan(""), 0.002);
  tally.add(0.001, std::nan(""));
  tally.add(0.001, 0.0);
  EXPECT_EQ(tally.count(), 0u);
  EXPECT_TRUE(std::isnan(tally.inside_95()));
  EXPECT_TRUE(std::isnan(tally.mean_square()));
}

}  // namespace stetro_bringup
