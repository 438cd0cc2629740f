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

#include "stetro_config/rule.hpp"

namespace stetro_config
{
namespace
{

TEST(Rule, IntervalsAreClosedAndMoreThanIsOpen)
{
  constexpr Within kWithin{0.05, 0.25};
  EXPECT_TRUE(kWithin.accepts(0.05));
  EXPECT_TRUE(kWithin.accepts(0.25));
  EXPECT_FALSE(kWithin.accepts(0.2500001));
  EXPECT_TRUE((Within{1, 16}.accepts(std::int64_t{16})));
  EXPECT_FALSE((Within{1, 16}.accepts(std::int64_t{17})));
  EXPECT_TRUE(AtLeast{0.0}.accepts(0.0));
  EXPECT_FALSE(MoreThan{0.0}.accepts(0.0));
}

TEST(Rule, TextsAreChosenNamedOrNotEmpty)
{
  EXPECT_TRUE((OneOf{"paper", "fused"}.accepts("fused")));
  EXPECT_FALSE((OneOf{"paper", "fused"}.accepts("Fused")));
  EXPECT_FALSE(NonEmpty{}.accepts(std::string{}));
  EXPECT_TRUE(Identifier{}.accepts("flight_2"));
  for (const char * text : {"", "2nd", "_a", "a b", "a/b", "A", "a-b"}) {
    EXPECT_FALSE(Identifier{}.accepts(text)) << text;
  }
}

TEST(Rule, ListsAreCountedAndEachElementIsJudged)
{
  const Each each{Within{0.0, 1.0}, 1, 2};
  EXPECT_TRUE(each.accepts(std::vector<double>{0.0, 1.0}));
  EXPECT_FALSE(each.accepts(std::vector<double>{}));
  EXPECT_FALSE(each.accepts(std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_FALSE(each.accepts(std::vector<double>{0.0, 1.1}));
}

TEST(Rule, SpeaksInWords)
{
  EXPECT_EQ(accepted_words(Kind::kDouble, Within{1e-4, 0.1}), "a finite number, 0.0001 to 0.1");
  EXPECT_EQ(accepted_words(Kind::kBool, Any{}), "true or false");
  EXPECT_EQ(AtLeast{2}.words(), "at least 2");
  EXPECT_EQ(MoreThan{0}.words(), "more than 0");
  EXPECT_EQ((OneOf{"paper", "fused"}.words()), "one of paper, fused");
  EXPECT_EQ((Each{Within{0, 1}, 3, 3}.words()), "3 of them, each 0 to 1");
  EXPECT_EQ((Each{Any{}, 1}.words()), "at least 1 of them");
  EXPECT_EQ((Each{AtLeast{0}, 0, 4}.words()), "at most 4 of them, each at least 0");
  EXPECT_EQ((Each{AtLeast{0}}.words()), "each at least 0");
}

}  // namespace
}  // namespace stetro_config
