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

#include "accuracy/noticing.hpp"

namespace stetro_bringup
{
namespace
{

Detection noticed_after(double time_s, double motion_s, double telling_motion_s)
{
  Detection detection;
  detection.struck = detection.detected = true;
  detection.time_s = time_s;
  detection.motion_s = motion_s;
  detection.telling_motion_s = telling_motion_s;
  return detection;
}

TEST(FaultNoticing, OnlyANoticedFaultIsInTime)
{
  Detection missed = noticed_after(90.0, 0.5, 0.2);
  missed.detected = false;
  const FaultNoticing all = noticing_of(std::vector<Detection>{
    noticed_after(4.0, 1.0, 0.5), noticed_after(7.0, 1.5, 1.0), noticed_after(6.0, 3.0, 1.01),
    missed});
  EXPECT_EQ(all.struck, 4u);
  EXPECT_EQ(all.missed, 1u);
  EXPECT_EQ(all.in_time, 1u) << "within 1 s of motion, 1 s included";
  EXPECT_EQ(all.in_telling_time, 2u);
  EXPECT_DOUBLE_EQ(all.latest_s, 7.0);
  EXPECT_DOUBLE_EQ(all.latest_telling_s, 1.01);
}

TEST(MiscountNoticing, CountsTheNoticedByTheClimbsBegun)
{
  const MiscountNoticing all = noticing_of(std::vector<Miscount>{
    {0, MiscountEnd::kNoticed},
    {0, MiscountEnd::kNoticed},
    {1, MiscountEnd::kNoticed},
    {3, MiscountEnd::kNoticed},
    {0, MiscountEnd::kCorrected},
    {2, MiscountEnd::kUnnoticed}});
  EXPECT_EQ(all.began, 6u);
  EXPECT_EQ(all.before_next_climb, 2u);
  EXPECT_EQ(all.within_one_step, 3u);
  EXPECT_EQ(all.by_climbs, (std::vector<std::uint64_t>{2, 1, 0, 1}));
  EXPECT_EQ(all.corrected, 1u);
  EXPECT_EQ(all.unnoticed, 1u);
  EXPECT_TRUE(noticing_of(std::vector<Miscount>{}).by_climbs.empty());
}

}  // namespace
}  // namespace stetro_bringup
