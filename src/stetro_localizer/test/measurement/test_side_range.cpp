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
#include <stdexcept>

#include "stetro_localizer/measurement/side_range.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kDeg = M_PI / 180.0;
constexpr double kWidth = 2.05;

SideRange beam(Side side, double mount_x_m = 0.0, double mount_y_m = 0.05)
{
  return {side, {mount_x_m, side == Side::kLeft ? mount_y_m : -mount_y_m}};
}

TEST(SideRange, ReadsTheWallContactOfTheHouse)
{
  // Contact: centre at R_w/2 = 0.115, sensor 0.05 off the centre: it reads 0.065.
  EXPECT_NEAR(beam(Side::kRight).y_m(0.065, 0.0, kWidth), 0.115, 1e-12);
  EXPECT_NEAR(beam(Side::kLeft).y_m(0.065, 0.0, kWidth), 2.05 - 0.115, 1e-12);
}

// D1-4: at 5 deg the cosine is 0.46 cm at 120 cm and 0.05 cm at 14 cm; 10 cm of lever are 0.87 cm.
TEST(SideRange, ModelsCosineAndLeverArm)
{
  const SideRange centred = beam(Side::kRight, 0.0, 0.0);
  EXPECT_NEAR(1.20 - centred.y_m(1.20, 5 * kDeg, kWidth), 0.0046, 0.0001);
  EXPECT_NEAR(0.14 - centred.y_m(0.14, 5 * kDeg, kWidth), 0.0005, 0.0001);
  const SideRange forward = beam(Side::kRight, 0.10, 0.0);
  EXPECT_NEAR(
    centred.y_m(0.5, 5 * kDeg, kWidth) - forward.y_m(0.5, 5 * kDeg, kWidth), 0.0087, 0.0001);
}

// d_R + d_L + s = W where both see: the two sides agree on y at every heading.
TEST(SideRange, BothSidesGiveTheSamePlace)
{
  std::mt19937 random{20260301};
  std::uniform_real_distribution<double> yaw{-0.3, 0.3};
  std::uniform_real_distribution<double> place{0.3, 1.7};
  for (int i = 0; i < 200; ++i) {
    const double y_m = place(random);
    const double yaw_rad = yaw(random);
    const SideRange left = beam(Side::kLeft, 0.03);
    const SideRange right = beam(Side::kRight, 0.03);
    const double d_left = left.range_m(y_m, yaw_rad, kWidth);
    const double d_right = right.range_m(y_m, yaw_rad, kWidth);
    EXPECT_NEAR(left.y_m(d_left, yaw_rad, kWidth), y_m, 1e-12) << "sample " << i;
    EXPECT_NEAR(right.y_m(d_right, yaw_rad, kWidth), y_m, 1e-12) << "sample " << i;
    EXPECT_NEAR((d_left + d_right + 0.10) * std::cos(yaw_rad), kWidth, 1e-12) << "sample " << i;
  }
}

TEST(SideRange, SlopesMatchCentralDifferences)
{
  constexpr double kStep = 1e-6;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SideRange model = beam(side, 0.04);
    for (const double yaw_rad : {-0.4, 0.0, 0.2}) {
      const double by_yaw =
        (model.y_m(0.7, yaw_rad + kStep, kWidth) - model.y_m(0.7, yaw_rad - kStep, kWidth)) /
        (2 * kStep);
      const double by_range =
        (model.y_m(0.7 + kStep, yaw_rad, kWidth) - model.y_m(0.7 - kStep, yaw_rad, kWidth)) /
        (2 * kStep);
      EXPECT_NEAR(model.slope_yaw(0.7, yaw_rad), by_yaw, 1e-8);
      EXPECT_NEAR(model.slope_range(yaw_rad), by_range, 1e-8);
    }
  }
}

TEST(SideRange, RefusesAMountingOnTheOtherSide)
{
  EXPECT_THROW(SideRange(Side::kLeft, {0.0, -0.05}), std::invalid_argument);
  EXPECT_THROW(SideRange(Side::kRight, {0.0, 0.05}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_localizer
