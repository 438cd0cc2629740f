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

#include "stetro_config/suggestion.hpp"

namespace stetro_config
{
namespace
{

TEST(Suggestion, CountsKeystrokes)
{
  EXPECT_EQ(keystrokes_between("riser", "riser"), 0U);
  EXPECT_EQ(keystrokes_between("", "abc"), 3U);
  EXPECT_EQ(keystrokes_between("kitten", "sitting"), 3U);  // the textbook example
  EXPECT_EQ(keystrokes_between("raiser", "riser"), 1U);
  EXPECT_EQ(keystrokes_between("rsier", "riser"), 1U) << "neighbours swapped";
}

TEST(Suggestion, NamesTheNearest)
{
  const std::vector<std::string> known{"riser_m", "tread_m", "width_m"};
  EXPECT_EQ(suggest("raiser_m", known), "a known key; did you mean riser_m?");
  EXPECT_EQ(suggest("tread", known), "a known key; did you mean tread_m?");
}

TEST(Suggestion, FindsANameWhoseGroupWasForgotten)
{
  EXPECT_EQ(
    suggest("sigma_m", {"rate_hz", "tof.sigma_m"}), "a known key; did you mean tof.sigma_m?");
}

TEST(Suggestion, ListsAllWhenNothingIsNear)
{
  EXPECT_EQ(suggest("colour", {"riser_m", "tread_m"}), "a known key: riser_m, tread_m");
  EXPECT_EQ(suggest(std::string(100000, 'x'), {"a"}), "a known key: a");
  EXPECT_EQ(suggest("x", {}), "no key at all");
}

}  // namespace
}  // namespace stetro_config
