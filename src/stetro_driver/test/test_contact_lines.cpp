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

#include <string>

#include "contact_bench.hpp"
#include "linux/lines/contact_lines.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

constexpr ContactPlace kStop = ContactPlace::kEmergencyStop;
constexpr ContactPlace kBumper = ContactPlace::kLeftMiddle;

class ContactLinesTest : public ::testing::Test
{
protected:
  ContactLatest latest() { return contacts_.latest(bench_.clock().now()); }
  ContactReading at(ContactPlace place)
  {
    return latest().contacts[static_cast<std::size_t>(place)];
  }
  std::string refusal()
  {
    try {
      contacts_.start();
    } catch (const HardwareError & error) {
      return error.what();
    }
    return "";
  }
  /// Waits until the levels were read after this call.
  bool looked_again()
  {
    const Time now = bench_.clock().now();
    return eventually([&] { return latest().read > now; });
  }
  ContactTrouble trouble(ContactPlace place) const
  {
    return contacts_.report().troubles[static_cast<std::size_t>(place)];
  }

  ContactBench bench_;
  ContactLines contacts_{bench_.config(), bench_.lines(), bench_.clock()};
};

TEST_F(ContactLinesTest, BeforeTheStartNothingIsToBeUsed)
{
  EXPECT_EQ(latest().fault, IoFaultKind::kNotConfigured);
  EXPECT_TRUE(at(kBumper).fault);
  EXPECT_TRUE(latest().emergency_stop_latched);
}

TEST_F(ContactLinesTest, EachSwitchIsSeenAtItsPlace)
{
  contacts_.start();
  EXPECT_EQ(latest().fault, std::nullopt);
  EXPECT_FALSE(latest().emergency_stop_latched);
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    const auto place = static_cast<ContactPlace>(i);
    const Time before = bench_.clock().now();
    bench_.press(place, true);
    EXPECT_TRUE(eventually([&] { return at(place).closed; })) << kContactNames[i];
    EXPECT_FALSE(at(place).fault) << kContactNames[i];
    EXPECT_GE(at(place).last_change, before - milliseconds{1}) << kContactNames[i];
    for (std::size_t other = 0; other < kContactPlaces; ++other) {
      EXPECT_EQ(latest().contacts[other].closed, other == i) << kContactNames[other];
    }
    bench_.press(place, false);
    EXPECT_TRUE(eventually([&] { return !at(place).closed; })) << kContactNames[i];
  }
}

TEST_F(ContactLinesTest, ABouncingSwitchWhoseNewestEdgesAreLostEndsRight)
{
  contacts_.start();
  bench_.lines().set_bounces(30);  // 61 edges in 12 ms, the queue keeps 16
  for (const bool pressed : {true, false, true, false}) {
    bench_.press(kBumper, pressed);
    EXPECT_TRUE(eventually([&] { return at(kBumper).closed == pressed; }));
  }
  const auto place = static_cast<std::size_t>(kBumper);
  EXPECT_EQ(contacts_.report().statistics[place].presses, 2u) << "two presses, whatever bounced";
}

TEST_F(ContactLinesTest, LevelsAreReadWithoutAnyEdge)
{
  contacts_.start();
  bench_.lines().lose_edges(bench_.line(kBumper), true);
  bench_.press(kBumper, true);
  EXPECT_TRUE(eventually([&] { return at(kBumper).closed; }));
  bench_.press(kBumper, false);
  EXPECT_TRUE(eventually([&] { return !at(kBumper).closed; }));
  EXPECT_EQ(contacts_.report().statistics[static_cast<std::size_t>(kBumper)].unheralded, 1u);
}

TEST_F(ContactLinesTest, TheEmergencyStopLatchesAndOnlyAResetAfterTheReleaseEndsIt)
{
  contacts_.start();
  bench_.press(kStop, true);
  ASSERT_TRUE(eventually([&] { return latest().emergency_stop_latched; }));
  auto refused = contacts_.reset_emergency_stop();
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->kind, IoFaultKind::kEmergencyStop);
  EXPECT_TRUE(latest().emergency_stop_latched);

  bench_.press(kStop, false);
  ASSERT_TRUE(eventually([&] { return !at(kStop).closed; }));
  EXPECT_TRUE(latest().emergency_stop_latched) << "releasing it is not enough";
  EXPECT_FALSE(contacts_.reset_emergency_stop());
  EXPECT_FALSE(latest().emergency_stop_latched) << "at once";
  ASSERT_TRUE(looked_again());
  EXPECT_FALSE(latest().emergency_stop_latched) << "and stays so";
}

TEST_F(ContactLinesTest, ATouchOfTheEmergencyStopLatchesAndARestartForgetsNothing)
{
  contacts_.start();
  bench_.press(kStop, true);
  bench_.press(kStop, false);  // no level shows it, two edges do
  EXPECT_TRUE(eventually([&] { return latest().emergency_stop_latched; }));
  contacts_.stop();
  contacts_.start();
  EXPECT_TRUE(latest().emergency_stop_latched);
}

TEST_F(ContactLinesTest, ACutWireOfTheEmergencyStopStopsTheRobot)
{
  contacts_.start();
  bench_.lines().release(bench_.line(kStop));
  EXPECT_TRUE(eventually([&] { return latest().emergency_stop_latched; }));
  EXPECT_TRUE(contacts_.reset_emergency_stop());
}

TEST_F(ContactLinesTest, APressedEmergencyStopAtTheStartIsLatchedAndNoFault)
{
  bench_.press(kStop, true);
  contacts_.start();
  EXPECT_TRUE(latest().emergency_stop_latched);
  EXPECT_TRUE(at(kStop).closed);
  EXPECT_FALSE(at(kStop).fault);
}

TEST_F(ContactLinesTest, AStuckSwitchAtTheStartIsAFaultUntilItWasSeenOpen)
{
  bench_.lines().stick(bench_.line(kBumper), false);
  contacts_.start();
  EXPECT_TRUE(at(kBumper).fault);
  EXPECT_EQ(trouble(kBumper), ContactTrouble::kStuckClosed);
  EXPECT_FALSE(at(ContactPlace::kLeftFront).fault) << "the others are well";
  bench_.lines().stick(bench_.line(kBumper), std::nullopt);
  EXPECT_TRUE(eventually([&] { return !at(kBumper).fault; }));
  bench_.press(kBumper, true);
  EXPECT_TRUE(eventually([&] { return at(kBumper).closed && !at(kBumper).fault; }));
}

TEST_F(ContactLinesTest, ALooseWireIsAFaultOfThatContactAlone)
{
  contacts_.start();
  bench_.lines().set_chatter(bench_.line(kBumper), true);
  EXPECT_TRUE(eventually([&] { return trouble(kBumper) == ContactTrouble::kChatters; }));
  EXPECT_TRUE(eventually([&] { return at(kBumper).fault; }));
  EXPECT_FALSE(at(ContactPlace::kLeftFront).fault);
  EXPECT_EQ(latest().fault, std::nullopt);
  bench_.lines().set_chatter(bench_.line(kBumper), false);
  EXPECT_TRUE(eventually([&] { return !at(kBumper).fault; }));
}

TEST_F(ContactLinesTest, AllSwitchesClosedAtTheStartAreACableAndRefused)
{
  for (std::size_t i = 0; i + 1 < kContactPlaces; ++i) {
    bench_.press(static_cast<ContactPlace>(i), true);
  }
  const OpenResources before;
  const std::string text = refusal();
  EXPECT_NE(text.find("all 8 bumpers and riser switches are closed"), std::string::npos) << text;
  EXPECT_TRUE(OpenResources{} == before);
  bench_.press(kBumper, false);
  EXPECT_EQ(refusal(), "");
}

TEST_F(ContactLinesTest, AContactThatIsNotFittedSaysSo)
{
  bench_.config().lines[0].chip = "none";
  ContactLines contacts{bench_.config(), bench_.lines(), bench_.clock()};
  contacts.start();
  EXPECT_TRUE(contacts.latest(bench_.clock().now()).contacts[0].fault);
  EXPECT_EQ(contacts.report().troubles[0], ContactTrouble::kNotFitted);
  EXPECT_EQ(contacts.report().troubles[1], ContactTrouble::kNone);
}

TEST(ContactLines, RefusesAWiringThatCannotBe)
{
  ContactBench bench;
  auto config = bench.config();
  config.lines[static_cast<std::size_t>(kStop)].chip = "none";
  EXPECT_THROW(ContactLines(config, bench.lines(), bench.clock()), HardwareError);
  config = bench.config();
  config.lines[1] = config.lines[0];
  EXPECT_THROW(ContactLines(config, bench.lines(), bench.clock()), HardwareError);
}

TEST(ContactLinesConfig, ListsEveryLineByItsPlace)
{
  ContactLinesConfig config;
  auto fields = stetro_config::fields_of(config);
  ASSERT_EQ(fields.size(), 3 + 4 * kContactPlaces);
  EXPECT_EQ(fields.back().name, "emergency_stop.bias");
  EXPECT_TRUE(fields.back().assign(std::string{"pull_down"}));
  EXPECT_EQ(config.lines.back().request().bias, LineBias::kPullDown);
  EXPECT_FALSE(config.lines.back().request().active_low) << "it opens from ground";
  EXPECT_TRUE(config.lines.front().request().active_low);
}

}  // namespace
}  // namespace stetro_driver::linux_io
