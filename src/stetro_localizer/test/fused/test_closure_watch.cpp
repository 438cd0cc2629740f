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

#include "stetro_localizer/fused/closure_watch.hpp"

namespace stetro_localizer
{
namespace
{

ContactSample touching(int second, bool left, bool right)
{
  ContactSample sample;
  sample.stamp = std::chrono::seconds(second);
  sample.left[0] = {true, left};
  sample.right[2] = {true, right};
  return sample;
}

// 12 mm and 10 mm across, 4 mm of the width at the left wall: 26 mm are to be expected.
TEST(ClosureWatch, AllowsTheProtectionLevelsOfBothWalls)
{
  ClosureWatch watch;
  EXPECT_FALSE(watch.violated(1.0)) << "nothing was said about y";
  watch.note(touching(1000, true, false), 0.012, 0.004);
  watch.note(touching(1001, true, false), 0.001, 0.004);  // corrected: of no interest
  watch.note(touching(1002, false, false), 0.001, 0.004);
  EXPECT_FALSE(watch.violated(1.0)) << "one wall is half of it";
  watch.note(touching(1020, false, true), 0.010, 0.004);
  EXPECT_FALSE(watch.violated(std::nullopt));
  EXPECT_FALSE(watch.violated(0.0255));
  EXPECT_FALSE(watch.violated(-0.0255));
  EXPECT_TRUE(watch.violated(0.0265));
  EXPECT_TRUE(watch.violated(-0.0265));
}

}  // namespace
}  // namespace stetro_localizer
