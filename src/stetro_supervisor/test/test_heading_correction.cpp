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

#include "stetro_supervisor/climb_params.hpp"
#include "stetro_supervisor/heading_correction.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kDeg = kRadPerDeg;

double rate(HeadingCorrection & law, double heading_deg, int direction, double offset_m = 0.0)
{
  const ClimbParams params;
  law.update(params, heading_deg * kDeg, direction, offset_m);
  return law.rate_rps(params, heading_deg * kDeg, direction, offset_m);
}

}  // namespace

TEST(HeadingCorrection, TurnsAgainstTheHeadingInBothTravelDirections)  // D1-6, D3-11
{
  for (const int direction : {-1, 0, +1}) {
    HeadingCorrection law;
    EXPECT_LT(rate(law, +4.0, direction), 0.0) << "turned left, so turn right; " << direction;
    HeadingCorrection other;
    EXPECT_GT(rate(other, -4.0, direction), 0.0) << "turned right, so turn left; " << direction;
  }
}

TEST(HeadingCorrection, IsSilentInTheDeadBand)  // D3-1: the printed branch acts for -3 < h <= 3
{
  HeadingCorrection law;
  for (const double heading : {-2.9, -1.0, 0.0, 1.0, 2.9}) {
    EXPECT_EQ(rate(law, heading, +1), 0.0) << heading;
  }
}

TEST(HeadingCorrection, GoesOnUntilOneDegreeInsideTheDeadBand)
{
  HeadingCorrection law;
  EXPECT_LT(rate(law, 3.1, +1), 0.0);
  EXPECT_LT(rate(law, 2.9, +1), 0.0) << "hysteresis: started beyond 3, ends at 2";
  EXPECT_LT(rate(law, 2.1, +1), 0.0);
  EXPECT_EQ(rate(law, 1.9, +1), 0.0);
  EXPECT_EQ(rate(law, 2.9, +1), 0.0) << "ended, starts again only beyond 3";
}

TEST(HeadingCorrection, LeansSoThatTravelTakesTheOffsetAway)
{
  // dx/dt = -vy sin(psi): beyond the line (+) and going left needs psi > 0, going right psi < 0
  for (const int direction : {-1, +1}) {
    for (const double offset : {-0.005, +0.005}) {
      HeadingCorrection law;
      const double wz = rate(law, 0.0, direction, offset);
      EXPECT_LT(-direction * std::sin(wz) * offset, 0.0) << direction << " " << offset;
    }
  }
}

TEST(HeadingCorrection, ClosedLoopReducesTheHeadingWhicheverWayItTravels)
{
  for (const int direction : {-1, +1}) {
    for (const double start_deg : {-6.0, 6.0}) {
      HeadingCorrection law;
      double heading = start_deg;
      for (int i = 0; i < 200; ++i) {
        heading += rate(law, heading, direction) * 0.05 / kDeg;
      }
      EXPECT_LE(std::abs(heading), 2.0 + 0.3) << direction << " from " << start_deg;
    }
  }
}

}  // namespace stetro_supervisor
