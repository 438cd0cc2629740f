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

#include <array>
#include <limits>

#include "stetro_localizer/fused/range_watch.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

/// Eight sensors of a robot that stands on a tread, 33 ms apart, none of which repeats itself.
class Watched
{
public:
  Watched() : watch(stetro_site::RobotGeometry{}, 0.05)
  {
    for (const Place place : stetro_site::kPlaces) {
      statuses[stetro_site::index_of(place)] = RangeStatus::kValid;
    }
    stand({0.14, 0.0, 0.0}, {true, true, true});
  }

  void stand(std::array<double, 3> height_m, std::array<bool, 3> bears)
  {
    BlockSample sample;
    for (std::size_t i = 0; i < 3; ++i) {
      sample.blocks[i] = {height_m[i], bears[i] ? 0.4 : 0.0, true, false, false};
    }
    watch.note(sample, travel_m);
  }

  void look(int arrays)
  {
    for (int i = 0; i < arrays; ++i) {
      now += milliseconds(33);
      ++arrays_seen;
      RangeSample sample;
      sample.stamp = now;
      for (const Place place : stetro_site::kPlaces) {
        const auto status = statuses[stetro_site::index_of(place)];
        sample[place] = {now, range_m + (arrays_seen % 2) * 0.001, 0.0, status};
      }
      watch.note(sample, travel_m, riser_m);
    }
  }

  void sets(Place place, RangeStatus status) { statuses[stetro_site::index_of(place)] = status; }

  RangeWatch watch;
  std::array<RangeStatus, stetro_site::kPlaces.size()> statuses{};
  double range_m = 0.2;
  double travel_m = 0.0;
  double riser_m = 0.085;
  Nanoseconds now = std::chrono::seconds(1000);
  int arrays_seen = 0;
};

TEST(RangeWatch, EveryPlaceIsDeadAfterItsPatience)
{
  for (const Place place : stetro_site::kPlaces) {
    Watched robot;
    const Nanoseconds since = robot.now;
    robot.look(10);
    EXPECT_FALSE(robot.watch.any_dead(robot.now, since, 0.5));
    robot.sets(place, RangeStatus::kFault);
    robot.look(15);  // 0.495 s
    EXPECT_FALSE(robot.watch.any_dead(robot.now, since, 0.5));
    robot.look(1);
    EXPECT_TRUE(robot.watch.any_dead(robot.now, since, 0.5)) << stetro_site::name_of(place);
  }
}

TEST(RangeWatch, EveryPlaceThatRepeatsItselfIsStuck)
{
  for (const Place place : stetro_site::kPlaces) {
    Watched robot;
    robot.look(10);
    EXPECT_FALSE(robot.watch.any_stuck());
    RangeSample sample;
    for (int i = 0; i < 12; ++i) {
      sample.stamp = robot.now += milliseconds(33);
      sample[place] = {sample.stamp, 0.212, 0.0, RangeStatus::kValid};
      robot.watch.note(sample, 0.0, 0.085);
    }
    EXPECT_TRUE(robot.watch.any_stuck()) << stetro_site::name_of(place);
  }
}

// A badly calibrated sensor 3.5 cm above its tread says too near, rightly. 5 cm up it cannot.
TEST(RangeWatch, ADownSensorMustSeeThatItsBlockWasLifted)
{
  for (const Place place : {Place::kBlock1Down, Place::kBlock2Down}) {
    const bool front = place == Place::kBlock1Down;
    Watched robot;
    robot.sets(place, RangeStatus::kTooNear);
    robot.look(100);
    EXPECT_FALSE(robot.watch.any_stuck());
    const auto raise = [&](double by_m) {
      robot.stand({front ? 0.14 + by_m : 0.14, front ? 0.0 : by_m, 0.0}, {!front, front, true});
    };
    raise(0.03);
    robot.look(100);
    EXPECT_FALSE(robot.watch.any_stuck()) << "3.5 + 3 cm less an offset of 4 cm";
    raise(0.06);
    robot.look(15);  // half a second
    EXPECT_TRUE(robot.watch.any_stuck());
    robot.stand({0.14, 0.0, 0.0}, {true, true, true});
    robot.look(100);
    EXPECT_TRUE(robot.watch.any_stuck()) << "and it stays stuck on the ground";
    robot.sets(place, RangeStatus::kValid);
    robot.look(1);
    EXPECT_FALSE(robot.watch.any_stuck());
  }
}

TEST(RangeWatch, ADownSensorOfABlockThatStandsSeesTheTread)
{
  Watched robot;
  robot.sets(Place::kBlock2Down, RangeStatus::kNoTarget);
  robot.look(14);
  EXPECT_FALSE(robot.watch.any_stuck());
  robot.look(1);
  EXPECT_TRUE(robot.watch.any_stuck());
}

// A block that was carried over the next tread may be near the ground again.
TEST(RangeWatch, ABlockThatHasRolledOnMayBeNearTheGround)
{
  Watched robot;
  robot.sets(Place::kBlock2Down, RangeStatus::kTooNear);
  robot.travel_m = 0.16;
  robot.stand({0.14, 0.18, 0.0}, {true, false, true});
  robot.look(100);
  EXPECT_FALSE(robot.watch.any_stuck());
}

// Block 2's rear face is 3.5 cm before block3_front: too near, if it is badly calibrated. Lifted by
// 18 cm it gives way to the riser, 0.085 + 0.11 m off.
TEST(RangeWatch, Block3FrontMustSeeTheRiserBelowBlock2)
{
  Watched robot;
  robot.sets(Place::kBlock3Front, RangeStatus::kTooNear);
  robot.look(100);
  EXPECT_FALSE(robot.watch.any_stuck());
  robot.stand({0.14, 0.18, 0.0}, {true, false, true});
  robot.riser_m = -0.06;  // it has rolled: 5 cm
  robot.look(100);
  EXPECT_FALSE(robot.watch.any_stuck());
  robot.riser_m = std::numeric_limits<double>::quiet_NaN();
  robot.look(100);
  EXPECT_FALSE(robot.watch.any_stuck());
  robot.riser_m = 0.085;
  robot.look(15);
  EXPECT_TRUE(robot.watch.any_stuck());
}

TEST(RangeWatch, OneOfThreeInFrontThatSeesNothingIsBlind)
{
  for (const Place place : {Place::kFrontLeft, Place::kStairFront, Place::kFrontRight}) {
    Watched robot;
    robot.sets(place, RangeStatus::kNoTarget);
    robot.range_m = 1.0;  // nearly out of reach: the other two may miss it as well
    robot.look(100);
    EXPECT_FALSE(robot.watch.any_stuck());
    robot.range_m = 0.3;
    robot.look(15);
    EXPECT_TRUE(robot.watch.any_stuck()) << stetro_site::name_of(place);
  }
}

}  // namespace
}  // namespace stetro_localizer
