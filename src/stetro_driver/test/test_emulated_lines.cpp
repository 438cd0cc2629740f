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

#include "device_bench.hpp"
#include "emulator/emulated_lines.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::LineBias;
using linux_io::LineEdge;
using std::chrono::milliseconds;
using std::chrono::seconds;

const LineName kButton{"chip", 3};
const LineName kOther{"chip", 4};

class EmulatedLinesTest : public ::testing::Test
{
protected:
  void open()
  {
    ASSERT_FALSE(
      lines_.open({{"chip", 3, true, LineBias::kPullUp}, {"chip", 4, false, LineBias::kPullDown}}));
  }
  /// All edges until it has been quiet for 20 ms.
  std::vector<LineEdge> edges()
  {
    std::vector<LineEdge> all;
    std::vector<LineEdge> some;
    do {
      EXPECT_FALSE(lines_.wait(milliseconds{20}, some));
      all.insert(all.end(), some.begin(), some.end());
    } while (!some.empty());
    return all;
  }

  EmulatedLines lines_{linux_io::DeviceClock{}};
};

TEST_F(EmulatedLinesTest, TurnsLevelsIntoActiveAndFloatsToTheBias)
{
  open();
  EXPECT_EQ(lines_.levels().value().to_ulong(), 0b00u) << "nobody drives them";
  lines_.drive(kButton, false);
  lines_.drive(kOther, true);
  EXPECT_EQ(lines_.levels().value().to_ulong(), 0b11u);
  const auto pressed = edges();
  ASSERT_EQ(pressed.size(), 2u);
  EXPECT_TRUE(pressed[0].active && pressed[1].active);
  lines_.release(kButton);
  const auto released = edges();
  ASSERT_EQ(released.size(), 1u);
  EXPECT_EQ(released[0].line, 0u);
  EXPECT_FALSE(released[0].active);
  EXPECT_GE(released[0].stamp, pressed[0].stamp);
}

TEST_F(EmulatedLinesTest, BouncesAndEndsWhereItIsDriven)
{
  open();
  lines_.set_bounces(3);
  lines_.drive(kButton, false);
  const auto pressed = edges();
  ASSERT_EQ(pressed.size(), 7u) << "3 there and back, and the last";
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    EXPECT_EQ(pressed[i].active, i % 2 == 0) << i;
  }
  EXPECT_TRUE(lines_.levels().value()[0]);
}

TEST_F(EmulatedLinesTest, DropsTheNewestEdgesBeyondSixteenAndSaysNothing)
{
  open();
  for (int i = 0; i < 21; ++i) {
    lines_.drive(kButton, i % 2 == 1);
  }
  const auto kept = edges();
  ASSERT_EQ(kept.size(), 16u);
  EXPECT_FALSE(kept.back().active) << "the sixteenth";
  EXPECT_TRUE(lines_.levels().value()[0]) << "the level is right";
}

TEST_F(EmulatedLinesTest, LosesEdgesOrKeepsALevelOnDemand)
{
  open();
  lines_.lose_edges(kButton, true);
  lines_.drive(kButton, false);
  EXPECT_TRUE(edges().empty());
  EXPECT_TRUE(lines_.levels().value()[0]);
  lines_.lose_edges(kButton, false);
  lines_.stick(kButton, false);
  lines_.drive(kButton, true);
  EXPECT_TRUE(lines_.levels().value()[0]) << "stuck";
  lines_.stick(kButton, std::nullopt);
  EXPECT_FALSE(lines_.levels().value()[0]);
}

TEST_F(EmulatedLinesTest, ALooseWireChangesAllTheTime)
{
  open();
  lines_.set_chatter(kButton, true);
  std::size_t count = 0;
  std::vector<LineEdge> some;
  ASSERT_TRUE(eventually([&] {
    EXPECT_FALSE(lines_.wait(milliseconds{20}, some));
    return (count += some.size()) > 50;
  }));
  lines_.set_chatter(kButton, false);
  static_cast<void>(edges());
  EXPECT_FALSE(lines_.levels().value()[0]) << "back to what holds it";
}

TEST_F(EmulatedLinesTest, AChipThatWasUnpluggedMustBeRequestedAgain)
{
  open();
  lines_.set_plugged("chip", false);
  std::vector<LineEdge> none;
  const auto fault = lines_.wait(seconds{10}, none);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kSilent);
  EXPECT_FALSE(lines_.levels().ok());
  EXPECT_TRUE(lines_.open({{"chip", 3}}));
  lines_.set_plugged("chip", true);
  EXPECT_FALSE(lines_.levels().ok());
  open();
  EXPECT_TRUE(lines_.levels().ok());
}

TEST_F(EmulatedLinesTest, RefusesLinesThatAreTakenOrDoNotExist)
{
  lines_.set_taken(kOther, true);
  EXPECT_TRUE(lines_.open({{"chip", 4}}));
  lines_.set_taken(kOther, false);
  EXPECT_FALSE(lines_.open({{"chip", 4}}));
  lines_.replace("chip", 4);
  const auto fault = lines_.open({{"chip", 4}});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kBadAnswer);
}

}  // namespace
}  // namespace stetro_driver::emulator
