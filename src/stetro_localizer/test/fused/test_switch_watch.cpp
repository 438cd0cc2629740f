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

#include "stetro_localizer/fused/switch_watch.hpp"
#include "support/standing_robot.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr int kSteps = 16;

/// A robot that knows where it stands, and its switches ten times a second.
struct Rig
{
  Rig() : watch(stetro_site::RobotGeometry{})
  {
    for (Switch & one : contacts.left) {
      one.known = true;
    }
    contacts.right = contacts.left;
    contacts.riser_left.known = contacts.riser_right.known = true;
    at(1.0, 0.0);
    robot.know(kStateX, -0.2, 0.002);
  }

  void at(double y_m, double yaw_rad)
  {
    robot.know(kStateY, y_m, 0.002);
    robot.know(kStateYaw, yaw_rad, 0.002);
  }

  void hear(double duration_s)
  {
    for (int i = 0; i <= static_cast<int>(duration_s * 10.0 + 0.5); ++i) {
      now += milliseconds(100);
      contacts.stamp = now;
      watch.note(contacts, robot.core, kSteps);
    }
  }

  void push(double vx_mps, double duration_s)
  {
    robot.core.contacts = contacts;
    for (int i = 0; i <= static_cast<int>(duration_s * 100.0 + 0.5); ++i) {
      now += milliseconds(10);
      watch.note(OdometrySample{now, vx_mps, 0.0, 0.0}, robot.core);
    }
  }

  StandingRobot robot;
  SwitchWatch watch;
  ContactSample contacts;
  Nanoseconds now = std::chrono::seconds(1001);
};

TEST(SwitchWatch, OneThatDoesNotKnowItsStateIsDead)
{
  for (int i = 0; i < 8; ++i) {
    Rig rig;
    Switch & one = i < 3    ? rig.contacts.left[static_cast<std::size_t>(i)]
                   : i < 6  ? rig.contacts.right[static_cast<std::size_t>(i - 3)]
                   : i == 6 ? rig.contacts.riser_left
                            : rig.contacts.riser_right;
    rig.hear(1.0);
    EXPECT_FALSE(rig.watch.any_dead());
    one.known = false;
    rig.hear(0.0);
    EXPECT_TRUE(rig.watch.any_dead()) << i;
  }
}

// 3 cm and four times the doubt of y, 8 mm, from the wall a bumper is open.
TEST(SwitchWatch, ABumperThatStaysClosedOffTheWallIsStuck)
{
  Rig rig;
  rig.contacts.right[1].closed = true;
  rig.at(0.115 + 0.035, 0.0);
  rig.hear(2.0);
  EXPECT_FALSE(rig.watch.any_stuck());
  rig.at(0.115 + 0.045, 0.0);
  rig.hear(0.3);
  EXPECT_TRUE(rig.watch.any_stuck());
  rig.at(0.115, 0.0);
  rig.hear(1.0);
  EXPECT_TRUE(rig.watch.any_stuck()) << "the wall does not mend it";
  rig.contacts.right[1].closed = false;
  rig.hear(0.0);
  EXPECT_FALSE(rig.watch.any_stuck());
}

// Turned by 0.05 rad to the left, the front bumper's end leads the middle one's by 7.5 mm.
TEST(SwitchWatch, ABumperThatLeadsClosesFirst)
{
  Rig rig;
  rig.at(2.05 - 0.115, 0.05);
  rig.contacts.left[1].closed = true;
  rig.hear(0.3);
  EXPECT_TRUE(rig.watch.any_stuck());

  Rig nearly_square;
  nearly_square.at(2.05 - 0.115, 0.02);  // 3 mm are within what bumpers differ
  nearly_square.contacts.left[1].closed = true;
  nearly_square.hear(5.0);
  EXPECT_FALSE(nearly_square.watch.any_stuck());

  Rig other_one;
  other_one.at(2.05 - 0.115, 0.05);
  other_one.contacts.left[0].closed = true;
  other_one.hear(5.0);
  EXPECT_FALSE(other_one.watch.any_stuck()) << "those behind are not yet at the wall";
}

TEST(SwitchWatch, ARiserSwitchThatStaysClosedOffTheRiserIsStuck)
{
  Rig rig;
  rig.contacts.riser_left.closed = true;
  rig.robot.know(kStateX, -0.075 - 0.03, 0.002);
  rig.hear(2.0);
  EXPECT_FALSE(rig.watch.any_stuck());
  rig.robot.know(kStateX, -0.075 - 0.05, 0.002);
  rig.hear(0.3);
  EXPECT_TRUE(rig.watch.any_stuck());
}

// 2 cm a second against one switch turn the robot until the other one closes, 16 cm beside it.
TEST(SwitchWatch, ARiserSwitchThatOpposesThePushIsStuck)
{
  Rig rig;
  rig.contacts.riser_right.closed = true;
  rig.push(0.02, 1.4);
  EXPECT_FALSE(rig.watch.any_stuck());
  rig.push(-0.02, 5.0);
  EXPECT_FALSE(rig.watch.any_stuck()) << "backing off opens them one after the other";
  rig.push(0.02, 1.5);
  EXPECT_TRUE(rig.watch.any_stuck());
}

}  // namespace
}  // namespace stetro_localizer
