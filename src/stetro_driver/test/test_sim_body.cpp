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

#include "pilot.hpp"
#include "sim/sim_body.hpp"

namespace stetro_driver::sim
{
namespace
{

using test::paper_stairs;

/// The perfect body on perfect stairs, put down somewhere.
struct Scene
{
  explicit Scene(const BodyPose & pose, const StairShape & stairs = paper_stairs())
  : world(stairs), body(shape, world, 0.5, {0.0, 0.0, 0.0})
  {
    body.place(pose);
  }

  void roll(double x_m) { body.move({x_m, 0.0, 0.0}); }

  BodyShape shape;
  StairWorld world;
  SimBody body;
};

/// Sweeping tread i, block 2's front edge 1 cm from riser i+1: tread-local 0.235.
BodyPose sweeping(int i) { return {0.32 * i - 0.085, 1.025, 0.0}; }

TEST(SimBody, StandsAsTheDesignSays)
{
  const Scene scene{sweeping(3)};
  EXPECT_EQ(scene.body.step(), 3);
  EXPECT_NEAR(scene.body.underside_m(1), 0.56, 1e-12);  // one tread higher
  EXPECT_NEAR(scene.body.underside_m(2), 0.42, 1e-12);
  EXPECT_NEAR(scene.body.underside_m(3), 0.42, 1e-12);
  EXPECT_NEAR(scene.body.load(1), 1.0 / 3.0, 1e-12);
}

TEST(SimBody, StopsWithAllBlocksDownAtTheFirstRiser)
{
  Scene scene{{-0.5, 1.025, 0.0}};
  scene.roll(0.4);
  EXPECT_NEAR(scene.body.pose().x_m, -0.225, 1e-7) << "block 1's face on the riser";
  EXPECT_EQ(scene.body.fall(), Fall::kNone);
}

TEST(SimBody, BlockThreeMeetsTheRiserAfterSixteenCentimetres)
{
  Scene scene{sweeping(1)};
  scene.body.lift(2, 1.0);
  EXPECT_NEAR(scene.body.underside_m(2), 0.14 + 0.18, 1e-12) << "the upper lock ends the lift";
  const double from_m = scene.body.pose().x_m;
  scene.roll(0.5);
  EXPECT_NEAR(scene.body.pose().x_m - from_m, 0.16, 1e-6);
  scene.body.lower(2, 1.0);
  EXPECT_TRUE(scene.body.standing(2));
  EXPECT_NEAR(scene.body.underside_m(2), 0.28, 1e-12);
  EXPECT_EQ(scene.body.step(), 2) << "counted on touch-down, D1-12";
}

TEST(SimBody, SwitchesCloseAfterSeventeenCentimetres)
{
  Scene scene{sweeping(1)};
  scene.body.lift(2, 1.0);
  scene.roll(0.5);
  scene.body.lower(2, 1.0);
  scene.body.lift(3, 1.0);
  scene.body.lift(1, 1.0);
  EXPECT_NEAR(scene.body.underside_m(3), 0.32, 1e-12) << "4 cm over the tread, D3-5";
  EXPECT_NEAR(scene.body.load(2), 1.0, 1e-12);
  EXPECT_NEAR(scene.body.switch_gap_m(0.08), 0.17, 1e-6);
  scene.roll(0.17);
  EXPECT_NEAR(scene.body.switch_gap_m(0.08), 0.0, 1e-6);
  EXPECT_NEAR(scene.body.switch_gap_m(-0.08), 0.0, 1e-6);
  scene.roll(0.05);
  EXPECT_NEAR(scene.body.switch_gap_m(0.08), -0.001, 1e-6) << "the switches yield by a millimetre";
}

TEST(SimBody, FallsWhenABlockIsLoweredOnNothing)
{
  Scene scene{sweeping(1)};
  scene.body.lift(2, 1.0);
  scene.roll(0.16);
  scene.body.lower(2, 1.0);
  scene.body.lift(3, 1.0);
  scene.body.lift(1, 1.0);
  scene.roll(0.17);
  scene.body.lower(3, 0.05);
  EXPECT_TRUE(scene.body.standing(3));
  // Back so far that block 3 is wholly over tread 1 again: 0.565 - 0.175 - 0.075 = 0.315 < 0.32.
  scene.body.lift(3, 1.0);
  scene.roll(-0.175);
  EXPECT_EQ(scene.body.fall(), Fall::kNone);
  scene.body.lower(3, 0.5);
  EXPECT_EQ(scene.body.fall(), Fall::kLoweredOnNothing) << "it stood on tread 2";
}

TEST(SimBody, TipsOffANosingThatOnlyItsEdgeFinds)
{
  Scene scene{sweeping(1)};
  scene.body.lift(2, 1.0);
  scene.roll(0.08);  // block 2's centre is 5 mm before the nosing, its front half over it
  scene.body.lower(2, 1.0);
  EXPECT_EQ(scene.body.fall(), Fall::kTippedOffNosing);
}

TEST(SimBody, StandsOnANosingThatItsCentreIsOver)
{
  Scene scene{sweeping(1)};
  scene.body.lift(2, 1.0);
  scene.roll(0.09);  // 5 mm past it
  scene.body.lower(2, 1.0);
  EXPECT_EQ(scene.body.fall(), Fall::kNone);
  EXPECT_TRUE(scene.body.standing(2));
}

TEST(SimBody, FallsWhenLiftedWithoutSupport)
{
  Scene two{sweeping(1)};
  two.body.lift(1, 0.05);
  two.body.lift(2, 0.05);
  EXPECT_EQ(two.body.fall(), Fall::kLiftedWithoutSupport);
  Scene three{sweeping(1)};
  three.body.lift(2, 0.05);
  three.body.lift(3, 0.05);
  EXPECT_EQ(three.body.fall(), Fall::kLiftedWithoutSupport);
}

TEST(SimBody, FallsWhenItRollsOverANosing)
{
  Scene scene{sweeping(1)};
  scene.roll(-0.08);  // block 1's centre is 0.065 from its nosing
  EXPECT_EQ(scene.body.fall(), Fall::kRolledOverNosing);
}

TEST(SimBody, BothBumpersAreSquareAtTheWall)
{
  Scene scene{{0.235, 0.3, 0.0}};
  scene.body.move({0.0, -0.185, 0.0});
  EXPECT_NEAR(scene.body.pose().y_m, 0.115, 1e-9) << "y = R_w / 2";
  EXPECT_NEAR(scene.body.bumper_gap_m(1, false), 0.0, 1e-9);
  EXPECT_NEAR(scene.body.bumper_gap_m(2, false), 0.0, 1e-9);
  EXPECT_NEAR(scene.body.bumper_gap_m(3, false), 0.0, 1e-9);
  scene.body.move({0.0, -0.1, 0.0});
  EXPECT_NEAR(scene.body.pose().y_m, 0.113, 1e-6) << "bumpers yield by 2 mm, walls do not";
}

TEST(SimBody, AWallContactMovesByThreePointNineMillimetresPerDegree)
{
  const double degree = 3.14159265358979323846 / 180.0;
  Scene scene{{0.235, 0.3, degree}};
  const double gap_m = scene.body.bumper_gap_m(3, false);
  // Turned left, the rear end is nearer to the right wall: (R_w/2) cos + 0.225 sin.
  EXPECT_NEAR(0.3 - gap_m, 0.115 * std::cos(degree) + 0.225 * std::sin(degree), 1e-9);
  EXPECT_NEAR(0.3 - gap_m - 0.115, 0.0039, 0.0001);
  EXPECT_GT(scene.body.bumper_gap_m(1, false), gap_m + 0.005) << "0.3 sin(1 deg) farther";
}

TEST(SimBody, SkidsAlongTheWallThatItIsPushedAgainst)
{
  Scene scene{{-0.5, 0.2, -0.3}};
  for (int i = 0; i < 100; ++i) {
    scene.roll(0.003);
  }
  EXPECT_GT(scene.body.pose().x_m, -0.5 + 0.15) << "it goes on along the wall";
  EXPECT_GT(scene.body.bumper_gap_m(1, false), -0.0021) << "and not into it";
  EXPECT_GT(scene.body.pose().yaw_rad, -0.3) << "the push turns it flush";
}

TEST(SimBody, TurnsFlushWhenItPushesARiser)
{
  Scene scene{{-0.3, 1.025, 0.05}};
  for (int i = 0; i < 60; ++i) {
    scene.roll(0.005);
  }
  EXPECT_NEAR(scene.body.pose().yaw_rad, 0.0, 0.002);
}

TEST(SimBody, CannotTurnIntoAWall)
{
  Scene scene{{0.235, 0.115, 0.0}};
  scene.body.move({0.0, 0.0, 0.2});
  EXPECT_LT(std::abs(scene.body.pose().yaw_rad), 0.012) << "2 mm of bumper over 0.225 m";
  EXPECT_NEAR(scene.body.pose().y_m, 0.115, 1e-6);
}

TEST(SimBody, ABodyWiderThanTheTreadDoesNotFit)
{
  StairShape narrow = paper_stairs();
  narrow.width_foot_m = 0.22;
  narrow.width_top_m = 0.22;
  EXPECT_THROW((Scene{{-0.5, 0.11, 0.0}, narrow}), std::invalid_argument);
  // 0.45 m of robot on 0.32 m of tread: block 1 would stand inside riser 2.
  EXPECT_THROW((Scene{{0.12, 1.025, 0.0}}), std::invalid_argument);
}

TEST(SimBody, ATreadAsNarrowAsTheBodyHoldsIt)
{
  StairShape narrow = paper_stairs();
  narrow.width_foot_m = 0.23;
  narrow.width_top_m = 0.23;
  Scene scene{{-0.5, 0.115, 0.0}, narrow};
  scene.body.move({0.0, 0.05, 0.0});
  EXPECT_NEAR(scene.body.pose().y_m, 0.117, 1e-6) << "the 2 mm that the bumper yields";
  scene.body.move({0.1, 0.0, 0.0});
  EXPECT_NEAR(scene.body.pose().x_m, -0.4, 1e-6) << "along the walls it is free";
}

}  // namespace
}  // namespace stetro_driver::sim
