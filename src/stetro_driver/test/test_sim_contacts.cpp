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

#include "pilot.hpp"
#include "sim/sim_contacts.hpp"

namespace stetro_driver::sim
{
namespace
{

using test::paper_stairs;

class SimContactsTest : public ::testing::Test
{
protected:
  SimContactsTest() : world_(paper_stairs()), body_(shape_, world_, 0.5, {}) {}

  bool closed(const SimContacts & contacts, ContactPlace place) const
  {
    return contacts.readings()[static_cast<std::size_t>(place)].closed;
  }

  BodyShape shape_;
  StairWorld world_;
  SimBody body_;
  FaultInjector none_{{}};
};

TEST_F(SimContactsTest, AllBumpersOfASideCloseWhenSquare)
{
  SimContacts contacts{no_errors(), 1};
  body_.place({0.235, 0.1151, 0.0});
  contacts.observe(body_, Time{10}, none_);
  EXPECT_FALSE(closed(contacts, ContactPlace::kRightFront));
  body_.place({0.235, 0.1149, 0.0});
  contacts.observe(body_, Time{20}, none_);
  for (const auto place :
       {ContactPlace::kRightFront, ContactPlace::kRightMiddle, ContactPlace::kRightRear}) {
    EXPECT_TRUE(closed(contacts, place));
    EXPECT_EQ(contacts.readings()[static_cast<std::size_t>(place)].last_change, Time{20});
  }
  EXPECT_FALSE(closed(contacts, ContactPlace::kLeftFront));
}

TEST_F(SimContactsTest, OnlyTheNearEndClosesWhenTurned)
{
  SimContacts contacts{no_errors(), 1};
  body_.place({0.235, 0.1185, 0.0174533});  // one degree to the left: the rear is 3.9 mm nearer
  contacts.observe(body_, Time{10}, none_);
  EXPECT_TRUE(closed(contacts, ContactPlace::kRightRear));
  EXPECT_FALSE(closed(contacts, ContactPlace::kRightMiddle));
  EXPECT_FALSE(closed(contacts, ContactPlace::kRightFront));
}

TEST_F(SimContactsTest, BumpersCloseWithinAMillimetre)
{
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SimContacts contacts{SimErrors{}, seed};
    body_.place({0.235, 0.1161, 0.0});
    contacts.observe(body_, Time{10}, none_);
    EXPECT_FALSE(closed(contacts, ContactPlace::kRightMiddle)) << "seed " << seed;
    body_.place({0.235, 0.1139, 0.0});
    contacts.observe(body_, Time{20}, none_);
    EXPECT_TRUE(closed(contacts, ContactPlace::kRightMiddle)) << "seed " << seed;
  }
}

TEST_F(SimContactsTest, ADeadSwitchSaysSoAndAStuckOneDoesNot)
{
  SimContacts contacts{no_errors(), 1};
  FaultInjector faults{parse_sim_faults("dead:right_rear@0, stuck:right_front@0")};
  body_.place({0.235, 0.114, 0.0});
  contacts.observe(body_, Time{10}, faults);
  EXPECT_FALSE(closed(contacts, ContactPlace::kRightRear));
  EXPECT_TRUE(contacts.readings()[static_cast<std::size_t>(ContactPlace::kRightRear)].fault);
  EXPECT_FALSE(closed(contacts, ContactPlace::kRightFront));
  EXPECT_FALSE(contacts.readings()[static_cast<std::size_t>(ContactPlace::kRightFront)].fault);
  EXPECT_TRUE(closed(contacts, ContactPlace::kRightMiddle));
}

}  // namespace
}  // namespace stetro_driver::sim
