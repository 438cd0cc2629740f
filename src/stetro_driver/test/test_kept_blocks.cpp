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

#include <fstream>
#include <string>

#include "device_bench.hpp"
#include "linux/motion/kept_blocks.hpp"

namespace stetro_driver::linux_io
{
namespace
{

class KeptBlocksTest : public ::testing::Test
{
protected:
  void keep(const BlocksKnown & known) { KeptBlocks{path_}.keep(known); }

  TempDirectory directory_{};
  const std::string path_ = (directory_.path() / "blocks").string();
  const BlocksKnown striding_{
    {0.1401, -0.0002}, {true, false, true}, {false, true, false}, {{{0.1, 0.0}, {0.14, 0.0}, {}}}};
};

void expect_same(const BlocksKnown & a, const BlocksKnown & b)
{
  EXPECT_EQ(a.extensions_m, b.extensions_m);
  EXPECT_EQ(a.standing, b.standing);
  EXPECT_EQ(a.locked, b.locked);
  EXPECT_EQ(a.stood_at_m, b.stood_at_m);
}

TEST_F(KeptBlocksTest, AreThereForTheNextProgram)
{
  EXPECT_FALSE(KeptBlocks{path_}.load());
  keep(striding_);
  KeptBlocks next{path_};
  const auto known = next.load();
  ASSERT_TRUE(known);
  expect_same(*known, striding_);
  EXPECT_EQ(next.trouble(), "");
}

TEST_F(KeptBlocksTest, AreNotGuessedFromADamagedFile)
{
  keep(striding_);
  std::ofstream{path_, std::ios::app} << "block 4\n";
  KeptBlocks next{path_};
  EXPECT_FALSE(next.load());
  EXPECT_NE(next.trouble().find(path_), std::string::npos);
}

TEST_F(KeptBlocksTest, SayWhyTheyCannotBeKept)
{
  KeptBlocks kept{"/proc/blocks"};
  kept.keep(striding_);
  EXPECT_TRUE(eventually([&] { return !kept.trouble().empty(); }));
}

TEST_F(KeptBlocksTest, AreKeptNowhereWithoutAPath)
{
  KeptBlocks kept{""};
  kept.keep(striding_);
  EXPECT_FALSE(kept.load());
  EXPECT_EQ(kept.trouble(), "");
}

TEST(KeptBlocksText, HasNothingButThreeBlocksWithNumbers)
{
  const std::string text = encode(BlocksKnown{});
  EXPECT_TRUE(decode_blocks(text));
  EXPECT_FALSE(decode_blocks(text + "block 4\n"));
  EXPECT_FALSE(decode_blocks(text.substr(0, text.size() / 2)));
  EXPECT_FALSE(decode_blocks("extensions_m nan 0\n" + text.substr(text.find('\n') + 1)));
  EXPECT_FALSE(decode_blocks(""));
}

}  // namespace
}  // namespace stetro_driver::linux_io
