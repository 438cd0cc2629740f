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

#include "accuracy/fault_watch.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_localizer::Integrity;

constexpr double kOnset_s = 100.0;

/// Ticks of a climb about the onset of a fault, with a body that moves as it is told.
class Struck
{
public:
  explicit Struck(TellingMotion telling = TellingMotion::kAny) : watch({kOnset_s, telling})
  {
    moment_.accepted = true;
    moment_.truth.tread_width_m = 2.05;
    tick(1, Integrity::kOk);  // the last one before the onset
  }

  /// Ticks in which the body moves by so much each. [m, m, rad]
  Struck & tick(
    int count, Integrity integrity, double along_m = 0.0, double across_m = 0.0,
    double turned_rad = 0.0)
  {
    for (int i = 0; i < count; ++i) {
      moment_.truth.x_m += along_m;
      moment_.truth.y_m += across_m;
      moment_.truth.yaw_rad += turned_rad;
      moment_.estimate.integrity = integrity;
      moment_.elapsed_s = 0.01 * ticks_++;
      watch.watch(moment_);
    }
    return *this;
  }

  /// Ticks in which a block rises by so much each. [m]
  Struck & raise(std::size_t block, int count, double up_m)
  {
    for (int i = 0; i < count; ++i) {
      moment_.truth.block_heights_m[block] += up_m;
      tick(1, Integrity::kOk);
    }
    return *this;
  }

  FaultWatch watch;

private:
  Moment moment_;
  int ticks_ = 9999;
};

TEST(FaultWatch, TimesTheMotionInWhichAFaultWasBelieved)
{
  Struck climb(TellingMotion::kNearRightWall);
  climb.tick(30, Integrity::kOk);               // stands
  climb.tick(20, Integrity::kOk, 2e-4);         // up the stairs at 2 cm/s
  climb.tick(10, Integrity::kOk, 0.0, 1.5e-3);  // along the tread at 15 cm/s
  climb.tick(5, Integrity::kDegraded, 0.0, 1.5e-3).tick(50, Integrity::kOk, 0.0, 1.5e-3);
  const Detection & detection = climb.watch.detection();
  EXPECT_TRUE(detection.struck);
  EXPECT_TRUE(detection.detected);
  EXPECT_FALSE(detection.never_ok);
  EXPECT_DOUBLE_EQ(detection.time_s, 0.60);
  EXPECT_DOUBLE_EQ(detection.motion_s, 0.30);
  EXPECT_DOUBLE_EQ(detection.telling_motion_s, 0.10);
}

TEST(FaultWatch, EachSensorHasItsTellingMotion)
{
  const auto telling_s = [](TellingMotion telling) {
    Struck climb(telling);
    climb.tick(10, Integrity::kOk, -2e-4);               // along
    climb.tick(20, Integrity::kOk, 0.0, -1.5e-3);        // across
    climb.tick(40, Integrity::kOk, 0.0, 0.0, -1e-3);     // turning
    climb.tick(80, Integrity::kOk, 1e-5, 1e-5, 0.5e-4);  // creeps less than any motion
    return climb.watch.detection().telling_motion_s;
  };
  EXPECT_DOUBLE_EQ(telling_s(TellingMotion::kNearRightWall), 0.20);
  EXPECT_DOUBLE_EQ(telling_s(TellingMotion::kAlong), 0.50) << "the front pair feels a turn, too";
  EXPECT_DOUBLE_EQ(telling_s(TellingMotion::kTurning), 0.40);
  EXPECT_DOUBLE_EQ(telling_s(TellingMotion::kAny), 0.70);
}

// From wall to wall at 15 cm/s, 2.05 m: either wall is in reach for 1.2 m, 8 s, of it.
TEST(FaultWatch, ASideSensorTellsNothingOfAWallOutOfReach)
{
  for (const auto telling : {TellingMotion::kNearLeftWall, TellingMotion::kNearRightWall}) {
    Struck climb(telling);
    climb.tick(1366, Integrity::kOk, 0.0, 1.5e-3);
    EXPECT_NEAR(climb.watch.detection().telling_motion_s, 8.0, 0.011);
  }
}

// Up by 18 cm at 6 cm a second, 3 s: a down sensor tells in the last 13 cm of it, block3_front in
// the last 5.
TEST(FaultWatch, ALiftTellsOfTheSensorsBelow)
{
  const auto telling_s = [](TellingMotion telling, std::size_t block) {
    Struck climb(telling);
    climb.tick(100, Integrity::kOk).raise(block, 300, 6e-4).tick(100, Integrity::kOk);
    climb.raise(block, 300, -6e-4);
    return climb.watch.detection().telling_motion_s;
  };
  EXPECT_NEAR(telling_s(TellingMotion::kBlock1Rises, 0), 2.17, 0.011);
  EXPECT_NEAR(telling_s(TellingMotion::kBlock2Rises, 1), 2.17, 0.011);
  EXPECT_NEAR(telling_s(TellingMotion::kBlock2Clears, 1), 0.84, 0.011);
  EXPECT_EQ(telling_s(TellingMotion::kBlock2Rises, 0), 0.0);
}

TEST(FaultWatch, SwitchesTellWhereTheyTouch)
{
  const auto telling_s = [](TellingMotion telling) {
    Struck climb(telling);
    climb.tick(1366, Integrity::kOk, 0.0, 1.5e-3);  // from wall to wall: the last one to 2.049 m
    return climb.watch.detection().telling_motion_s;
  };
  EXPECT_NEAR(telling_s(TellingMotion::kAtLeftWall), 0.9, 0.02) << "the last 13.5 cm";
  EXPECT_NEAR(telling_s(TellingMotion::kAtRightWall), 0.89, 0.02);
}

// A hundred times 0.01 is not 1 when it is added up.
TEST(FaultWatch, OneSecondIsOneSecond)
{
  Struck climb;
  climb.tick(100, Integrity::kOk, 2e-4).tick(1, Integrity::kLost);
  EXPECT_TRUE(climb.watch.detection().detected);
  EXPECT_LE(climb.watch.detection().motion_s, 1.0);
}

TEST(FaultWatch, MissesWhatIsNeverNoticed)
{
  Struck climb;
  climb.tick(250, Integrity::kOk);
  EXPECT_TRUE(climb.watch.detection().struck);
  EXPECT_FALSE(climb.watch.detection().detected);
  EXPECT_DOUBLE_EQ(climb.watch.detection().time_s, 2.5);
  EXPECT_EQ(climb.watch.detection().motion_s, 0.0);
}

TEST(FaultWatch, NoticesInTheTickOfTheOnset)
{
  Struck climb;
  climb.tick(1, Integrity::kDegraded);
  EXPECT_TRUE(climb.watch.detection().detected);
  EXPECT_FALSE(climb.watch.detection().never_ok);
  EXPECT_EQ(climb.watch.detection().time_s, 0.0);
}

TEST(FaultWatch, AnAlarmFromBeforeTheOnsetNoticesNothing)
{
  FaultWatch watch({kOnset_s, TellingMotion::kAny});
  Moment moment;
  moment.accepted = true;
  const auto tick = [&](double elapsed_s, Integrity integrity) {
    moment.elapsed_s = elapsed_s;
    moment.estimate.integrity = integrity;
    watch.watch(moment);
  };
  tick(99.99, Integrity::kDegraded);
  EXPECT_FALSE(watch.detection().struck);
  tick(100.00, Integrity::kDegraded);
  EXPECT_TRUE(watch.detection().struck);
  EXPECT_TRUE(watch.detection().never_ok);
  EXPECT_FALSE(watch.detection().detected);
  tick(100.01, Integrity::kOk);
  EXPECT_FALSE(watch.detection().never_ok);
  EXPECT_FALSE(watch.detection().detected);
  tick(100.02, Integrity::kLost);
  EXPECT_FALSE(watch.detection().never_ok);
  EXPECT_TRUE(watch.detection().detected);
  EXPECT_DOUBLE_EQ(watch.detection().time_s, 0.01) << "only that it was believed";
}

TEST(FaultWatch, AClimbThatEndsBeforeTheOnsetIsNotStruck)
{
  FaultWatch watch({kOnset_s, TellingMotion::kAny});
  Moment moment;
  moment.elapsed_s = 150.0;
  watch.watch(moment);
  EXPECT_FALSE(watch.detection().struck) << "not under way";
  moment.elapsed_s = 99.0;
  moment.accepted = true;
  watch.watch(moment);
  EXPECT_FALSE(watch.detection().struck) << "too early";
}

}  // namespace
}  // namespace stetro_bringup
