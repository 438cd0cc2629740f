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

#include "linux/motion/steering.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kHalfPi = 1.57079632679489661923;
constexpr double kPeriodS = 0.02;

// The rear servo is mounted the other way round.
SteeringConfig config()
{
  SteeringConfig config;
  config.speed_rad_s = 1.0;
  config.joints = {{{5, -0.5, false}, {6, 0.5, true}}};
  return config;
}

TEST(Steering, ConvertsBetweenServoAndJoint)
{
  const SteeringConfig c = config();
  EXPECT_NEAR(joint_rad(c.joints[0], 0.2), 0.7, 1e-12);
  EXPECT_NEAR(joint_rad(c.joints[1], 0.2), 0.3, 1e-12);
  for (const JointConfig & joint : c.joints) {
    EXPECT_NEAR(joint_rad(joint, servo_rad(joint, 1.234)), 1.234, 1e-12);
  }
}

TEST(Steering, BeginsWhereTheWheelsStand)
{
  Steering steering{config()};
  steering.measure({-0.2, 0.2});  // both at 0.3
  EXPECT_NEAR(steering.reading().angle_rad, 0.3, 1e-12);
  EXPECT_NEAR(steering.reading().target_rad, 0.3, 1e-12);
  EXPECT_FALSE(steering.reading().moving);
  EXPECT_NEAR(steering.servo_goals_rad()[0], -0.2, 1e-12);
  EXPECT_NEAR(steering.servo_goals_rad()[1], 0.2, 1e-12);
}

TEST(Steering, GoesThereAtItsSpeedWithServosThatFollow)
{
  Steering steering{config()};
  steering.measure({-0.5, 0.5});
  steering.turn_to(kHalfPi);
  int periods = 0;
  while (periods == 0 || steering.reading().moving) {
    const double before = steering.servo_goals_rad()[0];
    steering.advance(kPeriodS);
    EXPECT_LE(steering.servo_goals_rad()[0] - before, kPeriodS + 1e-12) << "a leg of one period";
    steering.measure(steering.servo_goals_rad());
    ASSERT_LT(++periods, 200);
  }
  EXPECT_EQ(periods, 79);  // 1.5708 rad at 1 rad/s in periods of 0.02 s
  EXPECT_NEAR(steering.reading().angle_rad, kHalfPi, 1e-9);
}

TEST(Steering, HoldsWhereItsGoalIs)
{
  Steering steering{config()};
  steering.measure({-0.5, 0.5});
  steering.turn_to(kHalfPi);
  steering.advance(kPeriodS);
  steering.hold();
  steering.advance(kPeriodS);
  EXPECT_NEAR(steering.reading().target_rad, 0.02, 1e-12);
}

TEST(Steering, NeverRunsFarAheadOfWheelsThatAreStuck)
{
  Steering steering{config()};
  steering.measure({-0.5, 0.5});
  steering.turn_to(kHalfPi);
  for (int i = 0; i < 200; ++i) {
    steering.advance(kPeriodS);
    steering.measure({-0.5, 0.5});
  }
  EXPECT_NEAR(steering.servo_goals_rad()[0], -0.25, 1e-9);
  EXPECT_TRUE(steering.reading().moving) << "it is not there";
}

TEST(Steering, NoticesThatFrontAndRearDisagree)
{
  Steering steering{config()};
  steering.measure({-0.5, 0.5});
  EXPECT_FALSE(steering.torn());
  steering.measure({-0.3, 0.5});
  EXPECT_TRUE(steering.torn());
}

}  // namespace
}  // namespace stetro_driver::linux_io
