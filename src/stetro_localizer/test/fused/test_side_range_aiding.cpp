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
    const SideRangeAiding aiding(side, {0.03, side == Side::kLeft ? 0.05 : -0.05}, 0.0117);
    expect_jacobian_holds([&aiding](const StateVector & state) { return aiding.expect(state); });
  }
}

// Square to the walls, 0.615 m from the right one: 0.565 m from the sensor 5 cm outward.
TEST(SideRangeAiding, ReadsTheGapToTheWall)
{
  StateVector state = StateVector::Zero();
  state[kStateY] = 0.615;
  state[kStateWidth] = 2.05;
  const SideRangeAiding right(Side::kRight, {0.0, -0.05}, 0.0);
  EXPECT_NEAR(right.expect(state).value(), 0.565, 1e-12);
  const SideRangeAiding left(Side::kLeft, {0.0, 0.05}, 0.0);
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
      const double range_m = SideRangeAiding(side, mount, 0.0).expect(state).value();
      const double y_m = SideRange(side, mount).y_m(range_m, state[kStateYaw], state[kStateWidth]);
      EXPECT_NEAR(y_m, state[kStateY], 1e-12);
    }
  }
}

// Midpoint sum over solid angle, in place of the integrals.
TEST(Cone, ReadsAFlatWallTooFar)
{
  const double half_rad = 0.4363 / 2.0;
  double light = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double theta = half_rad * (i + 0.5) / 100000.0;
    const double weight = std::sin(theta) * std::pow(std::cos(theta), 3);
    light += weight;
    moment += weight / std::cos(theta);
  }
  EXPECT_NEAR(cone_excess(0.4363), moment / light - 1.0, 1e-9);
  EXPECT_NEAR(cone_excess(0.4363), 0.0118, 2e-4);
  EXPECT_EQ(cone_excess(0.0), 0.0);
}

}  // namespace
}  // namespace stetro_localizer
