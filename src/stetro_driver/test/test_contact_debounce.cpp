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

#include <random>

#include "linux/lines/contact_debounce.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Time kStart = seconds{1000};

/// Open at the start; released after 15 ms of quiet.
ContactDebounce open_contact()
{
  ContactDebounce contact;
  contact.begin(false, false);
  return contact;
}

TEST(ContactDebounce, ClosesAtTheFirstEdgeAndOpensAfterQuiet)
{
  ContactDebounce contact = open_contact();
  contact.edge(true, kStart);
  EXPECT_TRUE(contact.closed());
  EXPECT_EQ(contact.reading().last_change, kStart);

  contact.edge(false, kStart + milliseconds{40});
  contact.level(false, kStart + milliseconds{41});
  EXPECT_TRUE(contact.closed());
  EXPECT_TRUE(contact.settling());
  contact.level(false, kStart + milliseconds{54});
  EXPECT_TRUE(contact.closed()) << "14 ms of quiet";
  contact.level(false, kStart + milliseconds{55});
  EXPECT_FALSE(contact.closed()) << "15 ms of quiet";
  EXPECT_EQ(contact.reading().last_change, kStart + milliseconds{40}) << "when it let go";
  EXPECT_FALSE(contact.settling());
}

// Property: however it bounces, a press and a release are one press and one release.
TEST(ContactDebounce, BouncesAreOnePress)
{
  std::mt19937 random{20261123};
  std::uniform_int_distribution<int> bounces{0, 40};
  std::uniform_int_distribution<int> pause_us{50, 900};
  for (int run = 0; run < 200; ++run) {
    ContactDebounce contact = open_contact();
    Time now = kStart;
    int changes = 0;
    bool closed = false;
    for (const bool target : {true, false}) {
      for (int i = 2 * bounces(random); i >= 0; --i) {
        const bool active = (i % 2 == 0) == target;  // the last one is the target
        contact.edge(active, now);
        contact.level(active, now);
        changes += contact.closed() != closed ? 1 : 0;
        closed = contact.closed();
        now += microseconds{pause_us(random)};
      }
      now += milliseconds{20};
      contact.level(target, now);
      changes += contact.closed() != closed ? 1 : 0;
      closed = contact.closed();
      EXPECT_EQ(closed, target) << "run " << run;
    }
    EXPECT_EQ(changes, 2) << "run " << run;
    EXPECT_EQ(contact.statistics().presses, 1u) << "run " << run;
  }
}

TEST(ContactDebounce, ATouchTooShortForTheLevelCounts)
{
  ContactDebounce contact = open_contact();
  contact.edge(true, kStart);
  contact.edge(false, kStart + microseconds{300});
  contact.level(false, kStart + milliseconds{1});
  EXPECT_TRUE(contact.closed());
  contact.level(false, kStart + milliseconds{16});
  EXPECT_FALSE(contact.closed());
}

TEST(ContactDebounce, ALevelWhoseEdgeWasLostCounts)
{
  ContactDebounce contact = open_contact();
  contact.level(true, kStart);
  EXPECT_TRUE(contact.closed());
  EXPECT_EQ(contact.statistics().unheralded, 1u);
  contact.level(false, kStart + milliseconds{10});
  contact.level(false, kStart + milliseconds{25});
  EXPECT_FALSE(contact.closed()) << "15 ms after the level showed it";
}

TEST(ContactDebounce, ClosedAtTheStartIsAFaultUntilItWasSeenOpen)
{
  ContactDebounce contact;
  contact.begin(true, false);
  EXPECT_EQ(contact.trouble(), ContactTrouble::kStuckClosed);
  EXPECT_TRUE(contact.reading().fault);
  contact.level(true, kStart);
  EXPECT_TRUE(contact.reading().fault) << "still";
  contact.level(false, kStart + milliseconds{10});
  EXPECT_TRUE(contact.reading().fault) << "may be a bounce";
  contact.level(false, kStart + milliseconds{25});
  EXPECT_FALSE(contact.reading().fault);

  contact.begin(true, true);
  EXPECT_FALSE(contact.reading().fault) << "a button may be pressed";
  EXPECT_TRUE(contact.closed());
}

TEST(ContactDebounce, ALooseWireIsAFaultUntilASecondOfQuiet)
{
  ContactDebounce contact{{milliseconds{15}, 20}};
  contact.begin(false, false);
  Time now = kStart;
  contact.level(false, now);
  for (int i = 0; i < 20; ++i) {
    contact.edge(i % 2 == 0, now += milliseconds{1});
  }
  contact.level(false, now);
  EXPECT_EQ(contact.trouble(), ContactTrouble::kNone) << "20 edges may be a switch";
  contact.edge(true, now += milliseconds{1});
  contact.level(true, now);
  EXPECT_EQ(contact.trouble(), ContactTrouble::kChatters);
  contact.level(false, kStart + milliseconds{1000});
  EXPECT_EQ(contact.trouble(), ContactTrouble::kChatters) << "in that second it did";
  contact.level(false, kStart + milliseconds{2000});
  EXPECT_EQ(contact.trouble(), ContactTrouble::kNone) << "a second without an edge";
}

TEST(ContactDebounce, ALostLineIsAFaultUntilItIsReadAgain)
{
  ContactDebounce contact = open_contact();
  contact.lose();
  EXPECT_EQ(contact.trouble(), ContactTrouble::kLost);
  EXPECT_TRUE(contact.reading().fault);
  contact.level(false, kStart);
  EXPECT_FALSE(contact.reading().fault);
}

}  // namespace
}  // namespace stetro_driver::linux_io
