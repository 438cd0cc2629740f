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

#include <cmath>
#include <random>

#include "linux/motion/twist_to_wheels.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kHalfPi = 1.57079632679489661923;

// Wheels of 50 mm at (0.2, +-0.1) and (-0.2, +-0.1), the right ones mounted the other way round.
WheelsConfig four_wheels()
{
  WheelsConfig config;
  config.diameter_m = 0.05;
  config.wheels = {
    {{1, 0.2, 0.1, false}, {2, 0.2, -0.1, true}, {3, -0.2, 0.1, false}, {4, -0.2, -0.1, true}}};
  return config;
}

void expect_wheels(const WheelValues & got, const WheelValues & expected)
{
  for (std::size_t i = 0; i < kWheels; ++i) {
    EXPECT_NEAR(got[i], expected[i], 1e-12) << "wheel " << i;
  }
}

TEST(TwistToWheels, RollsForwardAndSideways)
{
  const TwistToWheels geometry{four_wheels()};
  expect_wheels(geometry.to_wheels({0.1, 0.0, 0.0}, 0.0), {4.0, -4.0, 4.0, -4.0});  // 0.1 / 0.025
  expect_wheels(geometry.to_wheels({0.0, -0.05, 0.0}, kHalfPi), {-2.0, 2.0, -2.0, 2.0});
}

TEST(TwistToWheels, TurnsCounterClockwiseWithTheFrontWheelsToTheLeft)
{
  const TwistToWheels geometry{four_wheels()};
  // At pi/2 the front contacts move by +0.2 m/rad along y, the rear ones by -0.2: 0.1 / 0.025.
  expect_wheels(geometry.to_wheels({0.0, 0.0, 0.5}, kHalfPi), {4.0, -4.0, -4.0, 4.0});
}

TEST(TwistToWheels, GivesNothingSquareToTheWheels)
{
  const TwistToWheels geometry{four_wheels()};
  expect_wheels(geometry.to_wheels({0.0, 0.1, 0.0}, 0.0), {});
  expect_wheels(geometry.to_wheels({0.1, 0.0, 0.0}, kHalfPi), {});
}

// Property: there and back is the identity for what the wheels can do.
TEST(TwistToWheels, ThereAndBackIsTheIdentity)
{
  const TwistToWheels geometry{four_wheels()};
  std::mt19937 random{20260404};
  std::uniform_real_distribution<double> speed{-0.3, 0.3};
  std::uniform_real_distribution<double> angle{0.0, kHalfPi};
  for (int i = 0; i < 500; ++i) {
    const double steering = angle(random);
    const double v = speed(random);
    const BodyTwist twist{v * std::cos(steering), v * std::sin(steering), speed(random)};
    const BodyTwist back = geometry.to_twist(geometry.to_wheels(twist, steering), steering);
    EXPECT_NEAR(back.vx_m_s, twist.vx_m_s, 1e-12) << "sample " << i;
    EXPECT_NEAR(back.vy_m_s, twist.vy_m_s, 1e-12) << "sample " << i;
    EXPECT_NEAR(back.wz_rad_s, twist.wz_rad_s, 1e-12) << "sample " << i;
  }
}

TEST(TwistToWheels, CannotTellATurnFromWheelsInOneLine)
{
  WheelsConfig config = four_wheels();
  config.wheels = {{{1, 0.2, 0.0, false}, {}, {2, -0.2, 0.0, false}, {}}};
  const TwistToWheels geometry{config};
  const BodyTwist twist = geometry.to_twist({4.0, 0.0, 4.0, 0.0}, 0.0);
  EXPECT_NEAR(twist.vx_m_s, 0.1, 1e-12);
  EXPECT_EQ(twist.wz_rad_s, 0.0);
  EXPECT_FALSE(geometry.exists(1));
}

}  // namespace
}  // namespace stetro_driver::linux_io
