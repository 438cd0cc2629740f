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
#include <stdexcept>

#include "stetro_localizer/measurement/bumper_contact.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kDeg = M_PI / 180.0;
constexpr double kWidth = 2.05;

BumperContact papers_robot() { return BumperContact(BumperParams{}); }

TEST(BumperContact, PutsASquareRobotHalfItsContactWidthFromTheWall)
{
  const auto right = papers_robot().fix(Side::kRight, {true, true, true}, 0.0, 0.0, kWidth);
  ASSERT_TRUE(right.has_value());
  EXPECT_NEAR(right->y_m, 0.115, 1e-12);
  EXPECT_NEAR(right->variance_m2, 1.5e-6, 1e-12);  // the bumpers' 1 mm, and their squareness
  const auto left = papers_robot().fix(Side::kLeft, {true, true, true}, 0.0, 0.0, kWidth);
  EXPECT_NEAR(left->y_m, 1.935, 1e-12);  // 2.05 - 0.115
}

// D1-2: y = (R_w/2) cos psi + |l| sin |psi|; 22.5 cm are 3.9 mm a degree.
TEST(BumperContact, AddsTheLeverOfTheEndThatTouches)
{
  const auto at = [](double yaw_deg, std::array<bool, 3> closed) {
    return papers_robot().fix(Side::kRight, closed, yaw_deg * kDeg, 0.0, kWidth);
  };
  const auto front = at(-1.0, {true, false, false});
  EXPECT_NEAR(front->lever_m, 0.225, 1e-12);
  EXPECT_NEAR(front->y_m, 0.115 * std::cos(kDeg) + 0.225 * std::sin(kDeg), 1e-12);
  EXPECT_NEAR(front->y_m - 0.115, 0.0039, 0.0001);
  EXPECT_NEAR(at(1.0, {false, false, true})->lever_m, 0.225, 1e-12);
  EXPECT_NEAR(at(1.0, {false, true, false})->lever_m, 0.075, 1e-12);
  EXPECT_NEAR(at(-0.1, {false, false, true})->lever_m, 0.225, 1e-12)
    << "the rear bumper alone tells that the rear touches";
}

TEST(BumperContact, TrustsTwoEndsMoreThanTheHeading)
{
  const auto fix = papers_robot().fix(Side::kRight, {true, true, true}, -4 * kDeg, 0.005, kWidth);
  EXPECT_NEAR(fix->y_m, 0.115, 1e-12);
  EXPECT_NEAR(fix->variance_m2, 1.5e-6, 1e-12);
}

// The point (l, -R_w/2) of the body lies on the wall: worked by rotating it, not by the formula.
TEST(BumperContact, AgreesWithTheRotatedCorner)
{
  for (const double yaw_deg : {-6.0, -2.0, -0.5}) {
    const double yaw = yaw_deg * kDeg;
    const double corner_y = 0.225 * std::sin(yaw) - 0.115 * std::cos(yaw);
    const auto fix = papers_robot().fix(Side::kRight, {true, false, false}, yaw, 0.0, kWidth);
    EXPECT_NEAR(fix->y_m + corner_y, 0.0, 1e-12) << yaw_deg << " deg";
  }
}

TEST(BumperContact, TakesTheHeadingsDoubtIntoAccount)
{
  const auto fix = papers_robot().fix(Side::kRight, {true, true, false}, 0.0, kDeg * kDeg, kWidth);
  EXPECT_NEAR(fix->variance_m2, 1e-6 + std::pow(0.225 * kDeg, 2), 1e-9);
}

TEST(BumperContact, SaysNothingWithoutAContact)
{
  EXPECT_FALSE(papers_robot().fix(Side::kLeft, {false, false, false}, 0.0, 0.0, kWidth));
}

TEST(BumperContact, RefusesARobotWithoutWidth)
{
  BumperParams params;
  params.contact_width_m = 0.0;
  EXPECT_THROW(BumperContact{params}, std::invalid_argument);
}

}  // namespace
}  // namespace stetro_localizer
