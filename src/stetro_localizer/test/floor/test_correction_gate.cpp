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

#include "stetro_localizer/floor/correction_gate.hpp"

namespace stetro_localizer
{
namespace
{

using Trust = CorrectionGate::Trust;

constexpr int kHall = 0;  // places of floors in a site
constexpr int kLobby = 1;

GateLimits limits(double false_alarm = 1e-4)
{
  return {chi_square_3_quantile(false_alarm), 3, 0.3, 0.15};
}

PoseFix fix_at(double x_m, double y_m, double yaw_rad, double sigma_m = 0.02)
{
  PoseFix fix;
  fix.pose << x_m, y_m, yaw_rad;
  fix.covariance = Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, 0.01 * 0.01).asDiagonal();
  return fix;
}

/// A robot that believes to stand at the origin within 3 cm and 1 deg.
class CorrectionGateTest : public testing::Test
{
protected:
  CorrectionGateTest() : gate(limits())
  {
    FloorMatrix P = FloorMatrix::Zero();
    P.diagonal() << 0.03 * 0.03, 0.03 * 0.03, 0.0175 * 0.0175, 1e-6, 4e-4;
    filter.set(FloorVector::Zero(), P);
  }

  CorrectionOutcome judge(const PoseFix & fix, int floor = kHall)
  {
    return gate.judge(filter, fix, floor);
  }

  void drive(double dt_s, double v_mps)
  {
    const auto step = [&](FloorFilter & one) { one.roll(dt_s, v_mps, 0.0, 3e-3, 5e-4); };
    step(filter);
    gate.follow(step);
  }

  FloorFilter filter;
  CorrectionGate gate;
};

TEST_F(CorrectionGateTest, FusesWhatIsNear)
{
  gate.trust(kHall);
  EXPECT_EQ(judge(fix_at(0.02, -0.01, 0.005)), CorrectionOutcome::kFused);
  EXPECT_GT(filter[kFloorX], 0.01);
  EXPECT_EQ(gate.refused(), 0);
}

TEST_F(CorrectionGateTest, RefusesWhatIsFarAndChangesNothing)
{
  gate.trust(kHall);
  const FloorVector before = filter.state();
  EXPECT_EQ(judge(fix_at(1.0, 0.0, 0.0)), CorrectionOutcome::kGated);
  EXPECT_EQ(filter.state(), before);
  EXPECT_EQ(gate.refused(), 1);
  EXPECT_EQ(judge(fix_at(0.0, 0.0, 0.0)), CorrectionOutcome::kFused);
  EXPECT_EQ(gate.refused(), 0) << "a sound one ends the doubt";
}

// The share of sound corrections that a gate of 1 % refuses, in 20000: between 0.75 % and 1.25 %
// lies everything but 4e-4 of the binomial law.
TEST_F(CorrectionGateTest, RefusesSoundCorrectionsAsRarelyAsItSays)
{
  constexpr int kTrials = 20000;
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  int refused = 0;
  for (int i = 0; i < kTrials; ++i) {
    FloorFilter believed = filter;
    CorrectionGate one(limits(0.01));
    one.trust(kHall);
    PoseFix fix = fix_at(0.0, 0.0, 0.0);
    for (int axis = 0; axis < 3; ++axis) {  // where it is, and what the correction has wrong
      const double sigma = std::sqrt(believed.variance(axis) + fix.covariance(axis, axis));
      fix.pose[axis] = sigma * normal(random);
    }
    refused += one.judge(believed, fix, kHall) == CorrectionOutcome::kGated ? 1 : 0;
  }
  EXPECT_GT(refused, 150);
  EXPECT_LT(refused, 250);
}

// Carried two metres away: three corrections along its way say so.
TEST_F(CorrectionGateTest, IsLostWhenAStreakOfRefusedOnesAgrees)
{
  gate.trust(kHall);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0)), CorrectionOutcome::kGated);
  drive(1.0, 0.2);
  EXPECT_EQ(judge(fix_at(2.2, 1.0, 0.0)), CorrectionOutcome::kGated);
  drive(1.0, 0.2);
  EXPECT_EQ(judge(fix_at(2.4, 1.0, 0.0)), CorrectionOutcome::kGatedLost);
  EXPECT_EQ(gate.trust(), Trust::kLost);
  EXPECT_FALSE(gate.has_rival()) << "others must find it";
}

// Carried upstairs: what agrees is on another floor, and one of the pose's own is no part of it.
TEST_F(CorrectionGateTest, IsLostWhenAStreakOfAnotherFloorAgrees)
{
  gate.trust(kHall);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kOtherFloor);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kHall), CorrectionOutcome::kGated);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kOtherFloor);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kOtherFloor);
  EXPECT_EQ(gate.trust(), Trust::kKnown) << "the one between broke the streak";
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kGatedLost);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kAwaited);
  EXPECT_EQ(gate.judge(filter, fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kReset);
  EXPECT_EQ(gate.floor(), kLobby);
}

TEST_F(CorrectionGateTest, IsNotLostWhenTheRefusedOnesDisagree)
{
  gate.trust(kHall);
  for (int i = 1; i <= 10; ++i) {
    EXPECT_EQ(judge(fix_at(1.0 * i, -1.0 * i, 0.0)), CorrectionOutcome::kGated);
  }
  EXPECT_EQ(gate.trust(), Trust::kKnown);
  EXPECT_EQ(gate.refused(), 10) << "but it is doubted";
}

// Two that agree when the 0.2 m that it drove between them are taken out.
TEST_F(CorrectionGateTest, IsFoundByTwoThatAgree)
{
  gate.distrust(Trust::kLost, kHall);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0)), CorrectionOutcome::kAwaited);
  EXPECT_EQ(gate.trust(), Trust::kLost);
  drive(1.0, 0.2);
  EXPECT_EQ(judge(fix_at(2.2, 1.0, 0.0)), CorrectionOutcome::kReset);
  EXPECT_EQ(gate.trust(), Trust::kKnown);
  EXPECT_NEAR(filter[kFloorX], 2.2, 0.005);
  EXPECT_NEAR(filter[kFloorY], 1.0, 1e-9);
  EXPECT_LT(std::sqrt(filter.variance(kFloorX)), 0.02) << "both count";
}

TEST_F(CorrectionGateTest, StaysLostWhenTwoDisagree)
{
  gate.distrust(Trust::kLost, kHall);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0)), CorrectionOutcome::kAwaited);
  drive(1.0, 0.2);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0)), CorrectionOutcome::kAwaited) << "it should have moved";
  EXPECT_EQ(gate.trust(), Trust::kLost);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0)), CorrectionOutcome::kReset) << "the later two do agree";
}

TEST_F(CorrectionGateTest, IsFoundOnAnotherFloorByTwoOfThatFloor)
{
  gate.distrust(Trust::kNever, -1);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0), kHall), CorrectionOutcome::kAwaited);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kAwaited);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0), kLobby), CorrectionOutcome::kReset);
  EXPECT_EQ(gate.floor(), kLobby);
  EXPECT_EQ(judge(fix_at(2.0, 1.0, 0.0), kHall), CorrectionOutcome::kOtherFloor);
}

// Along a corridor two corrections know nothing of x, and agree about that.
TEST_F(CorrectionGateTest, IsNotFoundByTwoThatKnowLittle)
{
  gate.distrust(Trust::kLost, kHall);
  PoseFix corridor = fix_at(0.0, 1.0, 0.0);
  corridor.covariance(0, 0) = 25.0;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(judge(corridor), CorrectionOutcome::kAwaited);
  }
  EXPECT_EQ(gate.trust(), Trust::kLost);
}

}  // namespace
}  // namespace stetro_localizer
