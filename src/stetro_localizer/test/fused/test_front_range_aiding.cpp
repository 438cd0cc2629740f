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

#include "stetro_localizer/fused/front_range_aiding.hpp"
#include "support/jacobian.hpp"

namespace stetro_localizer
{
namespace
{

/// Near the middle of treads of 32 cm, square to the risers, so far before the one ahead.
StateVector standing_before_riser(double gap_m)
{
  StateVector state = StateVector::Zero();
  state[kStateX] = -gap_m;
  state[kStateY] = 1.0;
  state[kStateWidth] = 2.05;
  state[kStateTreadHere] = state[kStateTreadAhead] = 0.32;
  return state;
}

TEST(FrontRangeAiding, JacobianHolds)
{
  for (const SeenRiser seen :
       {SeenRiser::kBehind, SeenRiser::kAhead, SeenRiser::kNext, SeenRiser::kAfterNext}) {
    const FrontRangeAiding aiding(Ranger::kFrontRight, 0.19, -0.1, ConeOnWall(0.4363));
    expect_jacobian_holds(
      [&](const StateVector & state) { return aiding.expect(state, seen, 0.32); });
  }
}

// 8.5 cm before riser i+1, sensors 19 cm ahead, tread of 32 cm: 0.32 + 0.085 - 0.19 = 0.215 m.
TEST(FrontRangeAiding, ReadsTheGapToTheNextRiser)
{
  StateVector state = standing_before_riser(0.085);
  const FrontRangeAiding left(Ranger::kFrontLeft, 0.19, 0.1, ConeOnWall(0.0));
  EXPECT_NEAR(left.expect(state, SeenRiser::kNext).value(), 0.215, 1e-12);
  EXPECT_NEAR(left.expect(state, SeenRiser::kAfterNext, 0.30).value(), 0.515, 1e-12);
  state[kStateX] = -0.5;
  EXPECT_NEAR(left.expect(state, SeenRiser::kAhead).value(), 0.31, 1e-12);
}

// On a tread of 32 cm with 25 cm to go base_link is 7 cm past the riser behind; block 3's sensor,
// 11 cm farther back, is 4 cm before it.
TEST(FrontRangeAiding, ReadsTheGapOfBlock3ToTheRiserBehind)
{
  const StateVector state = standing_before_riser(0.25);
  const FrontRangeAiding block3(Ranger::kBlock3Front, -0.11, 0.0, ConeOnWall(0.0));
  EXPECT_NEAR(block3.expect(state, SeenRiser::kBehind).value(), 0.04, 1e-12);
}

// S-B eq. (2), D1-6: the difference of the pair over its baseline is the tangent of the heading.
TEST(FrontRangeAiding, DifferenceOfThePairIsTheHeading)
{
  StateVector state = standing_before_riser(0.085);
  state[kStateYaw] = 0.05;
  const FrontRangeAiding left(Ranger::kFrontLeft, 0.19, 0.1, ConeOnWall(0.0));
  const FrontRangeAiding right(Ranger::kFrontRight, 0.19, -0.1, ConeOnWall(0.0));
  const double difference_m =
    left.expect(state, SeenRiser::kNext).value() - right.expect(state, SeenRiser::kNext).value();
  EXPECT_NEAR(std::atan2(difference_m, 0.2), 0.05, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
