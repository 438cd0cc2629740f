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

#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/side_range_aiding.hpp"
#include "support/jacobian.hpp"

namespace stetro_localizer
{
namespace
{

TEST(SideRangeAiding, JacobianHolds)
{
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const SideRangeAiding aiding(
      side, {0.03, side == Side::kLeft ? 0.05 : -0.05}, ConeOnWall(0.4363));
    expect_jacobian_holds([&aiding](const StateVector & state) { return aiding.expect(state); });
  }
}

// Square to the walls, 0.615 m from the right one: 0.565 m from the sensor 5 cm outward.
TEST(SideRangeAiding, ReadsTheGapToTheWall)
{
  StateVector state = StateVector::Zero();
  state[kStateY] = 0.615;
  state[kStateWidth] = 2.05;
  const SideRangeAiding right(Side::kRight, {0.0, -0.05}, ConeOnWall(0.0));
  EXPECT_NEAR(right.expect(state).value(), 0.565, 1e-12);
  const SideRangeAiding left(Side::kLeft, {0.0, 0.05}, ConeOnWall(0.0));
  EXPECT_NEAR(left.expect(state).value(), 1.385, 1e-12);
  state[offset_index(Ranger::kSideLeft)] = 0.01;
  state[gain_index(Ranger::kSideLeft)] = 0.02;
  EXPECT_NEAR(left.expect(state).value(), 1.385 * 1.02 + 0.01, 1e-12);
}

// The inverse is the paper estimator's own measurement, written by another hand.
TEST(SideRangeAiding, AgreesWithTheInverseModel)
{
  for (unsigned seed = 1; seed <= 20; ++seed) {
    StateVector state = some_state(seed);
    state.tail<kStateCount - kStateFirstCalibration>().setZero();
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const SideRangeParams mount{0.1, side == Side::kLeft ? 0.05 : -0.05};
      const double range_m = SideRangeAiding(side, mount, ConeOnWall(0.0)).expect(state).value();
      const double y_m = SideRange(side, mount).y_m(range_m, state[kStateYaw], state[kStateWidth]);
      EXPECT_NEAR(y_m, state[kStateY], 1e-12);
    }
  }
}

// A sum over rays of equal solid angle, in place of the closed form.
double summed_stretch(double half_rad, double incidence_rad)
{
  const double c0 = std::cos(half_rad);
  double light = 0.0;
  double moment = 0.0;
  constexpr int kRings = 400;
  constexpr int kTurns = 360;
  for (int i = 0; i < kRings; ++i) {
    const double cos_a = c0 + (1.0 - c0) * (i + 0.5) / kRings;
    const double sin_a = std::sqrt(1.0 - cos_a * cos_a);
    for (int k = 0; k < kTurns; ++k) {
      const double phi = 2.0 * std::acos(-1.0) * k / kTurns;
      const double c =
        std::cos(incidence_rad) * cos_a + std::sin(incidence_rad) * sin_a * std::cos(phi);
      light += c * c * c;
      moment += c * c;
    }
  }
  return moment / light;
}

TEST(ConeOnWall, IsTheMeanOfItsRays)
{
  const ConeOnWall cone(0.4363);
  for (const double incidence : {-0.3, 0.0, 0.1, 0.25}) {
    EXPECT_NEAR(cone.stretch(incidence), summed_stretch(0.4363 / 2.0, incidence), 1e-6)
      << incidence;
    const double difference = (cone.stretch(incidence + 1e-6) - cone.stretch(incidence - 1e-6));
    EXPECT_NEAR(cone.slope(incidence), difference / 2e-6, 1e-7) << incidence;
  }
  EXPECT_NEAR(cone.stretch(0.0), 1.0118, 2e-4);
}

// What fused_estimator.md and cone.hpp say of 25 degrees, by the sum over rays.
TEST(ConeOnWall, GrowsWithTheSlantNearlyAsItsAxis)
{
  const double half_rad = 0.4363 / 2.0;
  const double square = summed_stretch(half_rad, 0.0);
  const auto beside_axis = [&](double incidence_rad) {
    return summed_stretch(half_rad, incidence_rad) * std::cos(incidence_rad);
  };
  constexpr double kDegree = 0.017453292519943;
  EXPECT_NEAR(beside_axis(10.0 * kDegree) / square - 1.0, -0.0007, 5e-5);
  EXPECT_NEAR(beside_axis(30.0 * kDegree) / square - 1.0, -0.008, 3e-4);
  EXPECT_NEAR(beside_axis(10.0 * kDegree) - 1.0, 0.011, 3e-4);
  EXPECT_GT(beside_axis(35.0 * kDegree), 1.0);
  EXPECT_LT(beside_axis(36.0 * kDegree), 1.0);
  EXPECT_NEAR(std::acos(1.0 / square) / kDegree, 8.8, 0.05) << "a slant, to a model without cone";
}

TEST(ConeOnWall, OfZeroIsARay)
{
  const ConeOnWall ray(0.0);
  EXPECT_NEAR(ray.stretch(0.2), 1.0 / std::cos(0.2), 1e-12);
  EXPECT_NEAR(ray.slope(0.2), std::tan(0.2) / std::cos(0.2), 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
