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

#include "stetro_localizer/fused/bumper_aiding.hpp"
#include "stetro_localizer/fused/riser_switch_aiding.hpp"
#include "support/jacobian.hpp"

namespace stetro_localizer
{
namespace
{

TEST(BumperAiding, JacobianHolds)
{
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const double block_x_m : {0.15, 0.0, -0.15}) {
      expect_jacobian_holds([&](const StateVector & state) {
        return expect_bumper(state, side, block_x_m, 0.15, 0.23);
      });
    }
  }
}

// D1-4: y = (R_w/2) cos psi + |l| sin |psi|, with l = 0.225 m for the end that leans outward.
TEST(BumperAiding, GapIsZeroWhereTheEndTouches)
{
  StateVector state = StateVector::Zero();
  state[kStateWidth] = 2.05;
  state[kStateYaw] = -0.05;  // turned to the right: the front end touches the right wall
  state[kStateY] = 0.115 * std::cos(0.05) + 0.225 * std::sin(0.05);
  EXPECT_NEAR(expect_bumper(state, Side::kRight, 0.15, 0.15, 0.23).value(), 0.0, 1e-12);
  EXPECT_GT(expect_bumper(state, Side::kRight, -0.15, 0.15, 0.23).value(), 0.01);
  state[kStateY] = 2.05 - state[kStateY];  // and the rear end the left one
  EXPECT_NEAR(expect_bumper(state, Side::kLeft, -0.15, 0.15, 0.23).value(), 0.0, 1e-12);
}

TEST(RiserSwitchAiding, JacobianHolds)
{
  for (const double tip_y_m : {0.08, -0.08}) {
    expect_jacobian_holds(
      [&](const StateVector & state) { return expect_riser_switch(state, 0.075, tip_y_m); });
  }
}

TEST(RiserSwitchAiding, BothTouchWhenSquareToTheRiser)
{
  StateVector state = StateVector::Zero();
  state[kStateWidth] = 2.05;
  state[kStateY] = 1.025;
  state[kStateX] = -0.075;
  EXPECT_NEAR(expect_riser_switch(state, 0.075, 0.08).value(), 0.0, 1e-12);
  // A riser that recedes to the left by rho is square to a body turned by -rho.
  state[kStateRiserAhead] = 0.01;
  state[kStateYaw] = -0.01;
  EXPECT_NEAR(
    expect_riser_switch(state, 0.075, 0.08).value(),
    expect_riser_switch(state, 0.075, -0.08).value(), 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
