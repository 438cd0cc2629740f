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

#include "stetro_supervisor/tread_offset.hpp"

namespace stetro_supervisor
{

TEST(TreadOffset, AddsUpOdometryWithoutAReference)
{
  TreadOffset offset;
  offset.zero();
  offset.roll(0.004);
  offset.roll(-0.001);
  EXPECT_NEAR(offset.value_m(), 0.003, 1e-12);
  EXPECT_FALSE(offset.has_reference());
}

TEST(TreadOffset, FollowsTheFrontRangeNotTheSitesTread)
{
  TreadOffset offset;
  offset.zero();
  for (int i = 0; i < 10; ++i) {
    offset.see(0.219, 0.033);  // the tread is 4 mm deeper than the site says: no matter
  }
  ASSERT_TRUE(offset.has_reference());
  for (int i = 0; i < 200; ++i) {
    offset.see(0.213, 0.033);  // 6 mm nearer to the riser, unnoticed by the wheels
  }
  EXPECT_NEAR(offset.value_m(), 0.006, 1e-4);
}

TEST(TreadOffset, LeavesOutAnotherSurface)
{
  TreadOffset offset;
  offset.zero();
  for (int i = 0; i < 10; ++i) {
    offset.see(0.215, 0.033);
  }
  offset.see(0.60, 0.033);
  EXPECT_NEAR(offset.value_m(), 0.0, 1e-12);
}

}  // namespace stetro_supervisor
