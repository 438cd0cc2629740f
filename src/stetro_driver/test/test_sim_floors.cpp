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

// The simulated robot between its flights: on floors, over landings, and carried about.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "buildings.hpp"
#include "pilot.hpp"
#include "sim/building.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver
{
namespace
{

using test::kHalfPi;
using test::perfect;
using test::Pilot;
using test::two_floors;

constexpr double kHalfTurn = 3.14159265358979323846;

SimOptions standing_at(double x_m, double y_m, double yaw_rad = 0.0)
{
  SimOptions options = perfect();
  options.start = SimStart{x_m, y_m, yaw_rad};
  return options;
}

bool closed(const SensorFrame & frame, ContactPlace place) { return frame.contact(place).closed; }

TEST(SimFloors, TruthNamesTheSegment)
{
  struct
  {
    double x_m;
    const char * segment;
    bool on_floor;
  } const cases[] = {{-2.0, "ground", true}, {-0.3, "ground", true}, {0.235, "lower", false},
                     {5.0, "lower", false},  {5.2, "landing", true}, {6.5, "landing", true}};
  for (const auto & c : cases) {
    const GroundTruth truth = SimRobot{two_floors(), {}, standing_at(c.x_m, 1.0)}.truth();
    EXPECT_EQ(truth.segment, c.segment) << c.x_m;
    EXPECT_EQ(truth.on_floor, c.on_floor) << c.x_m;
    EXPECT_NEAR(truth.in_map.x_m, 5.0 + c.x_m, 1e-12);
    EXPECT_NEAR(truth.x_m, c.on_floor ? 5.0 + c.x_m : c.x_m, 1e-12) << "floors lie on map";
    EXPECT_NEAR(truth.z_m, c.on_floor ? 0.0 : truth.in_map.z_m, 1e-12);
    EXPECT_EQ(std::isnan(truth.tread_width_m), c.on_floor);
  }
}

TEST(SimFloors, WithoutDrawingsItIsAlwaysTheFlight)
{
  SimRobot robot{test::paper_stairs(), {}, standing_at(-0.5, 1.0)};
  EXPECT_FALSE(robot.truth().on_floor);
  EXPECT_EQ(robot.truth().step, 0);
  EXPECT_EQ(robot.truth().x_m, -0.5);
}

TEST(SimFloors, AWallStopsTheSideAndClosesItsBumpers)
{
  SimRobot robot{two_floors(), {}, standing_at(-4.0, 1.0)};
  Pilot pilot{robot};
  pilot.steer(kHalfPi);
  pilot.during(Pilot::twist(0.0, -0.1, 0.0), 8.8);
  EXPECT_NEAR(robot.truth().y_m, 0.12, 1e-9) << "5 mm to go";
  EXPECT_FALSE(closed(pilot.frame(), ContactPlace::kRightMiddle));
  pilot.during(Pilot::twist(0.0, -0.1, 0.0), 1.0);
  EXPECT_NEAR(robot.truth().y_m, 0.113, 1e-6) << "half its 23 cm, bumpers pressed in by 2 mm";
  for (const ContactPlace place :
       {ContactPlace::kRightFront, ContactPlace::kRightMiddle, ContactPlace::kRightRear}) {
    EXPECT_TRUE(closed(pilot.frame(), place));
  }
  EXPECT_FALSE(closed(pilot.frame(), ContactPlace::kLeftMiddle));
  EXPECT_FALSE(robot.truth().fallen);
}

TEST(SimFloors, AWallStopsTheRearAndClosesNoBumper)
{
  SimRobot robot{two_floors(), {}, standing_at(-4.5, 1.0)};
  Pilot pilot{robot};
  pilot.roll(-0.1, 4.0);
  EXPECT_NEAR(robot.truth().x_m, 0.225, 1e-6);
  for (std::size_t i = 0; i < kBumpers; ++i) {
    EXPECT_FALSE(pilot.frame().contacts[i].closed) << kContactNames[i];
  }
}

TEST(SimFloors, AColumnStopsTheFront)
{
  SimRobot robot{two_floors(), {}, standing_at(-3.5, 2.0)};
  Pilot pilot{robot};
  pilot.roll(0.1, 8.0);
  EXPECT_NEAR(robot.truth().x_m, 2.3 - 0.225, 1e-6);
}

TEST(SimFloors, ASlantedRobotIsTurnedFlushByAWall)
{
  SimOptions options = standing_at(-4.0, 0.5, 0.1);
  options.errors.squaring = 0.5;
  SimRobot robot{two_floors(), {}, options};
  Pilot pilot{robot};
  pilot.steer(kHalfPi);
  pilot.during(Pilot::twist(0.0, -0.1, 0.0), 8.0);
  EXPECT_NEAR(robot.truth().yaw_rad, 0.0, 0.01);
  EXPECT_TRUE(closed(pilot.frame(), ContactPlace::kRightFront));
  EXPECT_TRUE(closed(pilot.frame(), ContactPlace::kRightRear));
}

TEST(SimFloors, RangeSensorsSeeTheWallsOfAFloor)
{
  SimRobot robot{two_floors(), {}, standing_at(-4.0, 0.5)};
  Pilot pilot{robot};
  pilot.during({}, 0.2);
  // 0.45 m from the sensor, and 1.2 % more over its cone.
  EXPECT_NEAR(pilot.frame().range(RangePlace::kSideRight).range_m, 0.455, 0.002);
  EXPECT_NEAR(pilot.frame().range(RangePlace::kBlock2Down).range_m, 0.035, 0.0011);
}

/// From the end of `lower` over the landing to riser 1 of `upper`, watching each tick.
class OverTheLanding : public ::testing::Test
{
protected:
  void start(const SimOptions & options)
  {
    robot_.emplace(two_floors(), BodyShape{}, options);
    pilot_.emplace(*robot_);
    last_ = robot_->truth();
  }

  /// Moves for some seconds; the pose in map may not jump by more than the motion told.
  void go(const JointCommand & command, double seconds, double most_m_per_tick)
  {
    pilot_->until(command, seconds, [&](const SensorFrame &) {
      const GroundTruth now = robot_->truth();
      EXPECT_LE(
        std::hypot(now.in_map.x_m - last_.in_map.x_m, now.in_map.y_m - last_.in_map.y_m),
        most_m_per_tick + 1e-9);
      EXPECT_NEAR(now.in_map.z_m, last_.in_map.z_m, 1e-9);
      last_ = now;
      return false;
    });
  }

  void cross()
  {
    go(Pilot::twist(0.1, 0.0, 0.0), 10.0, 0.0015);
    pilot_->steer(kHalfPi);
    go(Pilot::twist(0.0, 0.1, 0.0), 25.0, 0.0015);
    go(Pilot::twist(0.0, 0.0, 0.1), kHalfTurn / 0.1, 0.0);
    pilot_->steer(0.0);
  }

  std::optional<SimRobot> robot_;
  std::optional<Pilot> pilot_;
  GroundTruth last_{};
};

TEST_F(OverTheLanding, ThePoseInMapNeverJumps)
{
  start(standing_at(5.0, 1.0));
  EXPECT_EQ(robot_->truth().segment, "lower");
  go(Pilot::twist(0.1, 0.0, 0.0), 10.0, 0.001);
  EXPECT_NEAR(robot_->truth().in_map.x_m, 11.0, 1e-9);
  EXPECT_EQ(robot_->truth().segment, "landing");
  pilot_->steer(kHalfPi);
  go(Pilot::twist(0.0, 0.1, 0.0), 25.0, 0.001);
  EXPECT_NEAR(robot_->truth().in_map.y_m, 3.5, 1e-9);
  go(Pilot::twist(0.0, 0.0, 0.1), kHalfTurn / 0.1, 0.0);
  pilot_->steer(0.0);
  go(Pilot::twist(0.1, 0.0, 0.0), 4.0, 0.001);  // 0.4 m on: at the stairs of `upper`
  EXPECT_EQ(robot_->truth().segment, "landing");
  EXPECT_NEAR(robot_->truth().z_m, 0.0, 1e-12);
  ASSERT_TRUE(pilot_->lift(1));
  ASSERT_TRUE(pilot_->until(Pilot::twist(0.05, 0.0, 0.0), 15.0, [](const SensorFrame & frame) {
    return closed(frame, ContactPlace::kRiserLeft) && closed(frame, ContactPlace::kRiserRight);
  }));
  EXPECT_NEAR(robot_->truth().in_map.x_m, 10.12 + 0.075, 1e-3) << "block 2's edge at riser 1";
  ASSERT_TRUE(pilot_->lower(1));
  EXPECT_NEAR(robot_->truth().block_heights_m[0], 0.14, 1e-9);
  EXPECT_FALSE(robot_->truth().fallen);
  EXPECT_NEAR(pilot_->frame().odometry.yaw_rad, kHalfTurn, 2e-3) << "the wheels felt no frame";
}

TEST_F(OverTheLanding, StaysOnTheHeightThatWasBuilt)
{
  SimOptions options;
  options.seed = 5;
  options.start = SimStart{5.3, 1.0, 0.0};
  start(options);
  const sim::StairWorld lower{two_floors().flights[0].shape, options.errors, 5};
  cross();
  EXPECT_EQ(robot_->truth().segment, "landing");
  EXPECT_EQ(robot_->truth().z_m, 0.0);
  EXPECT_NEAR(robot_->truth().in_map.z_m, lower.height_m(16), 1e-12);
}

TEST_F(OverTheLanding, NoSensorFeelsAChangeOfFrame)
{
  start(standing_at(5.4, 1.0));
  pilot_->steer(kHalfPi);
  pilot_->during(Pilot::twist(0.0, 0.1, 0.0), 25.0);  // from the stairs of one to the other's
  EXPECT_EQ(pilot_->frame().gyro.rate_rad_s[2], 0.0);
  EXPECT_NEAR(pilot_->frame().odometry.y_m, 2.5, 1e-9);
  EXPECT_NEAR(robot_->truth().in_map.y_m, 3.5, 1e-9);
  EXPECT_NEAR(robot_->truth().in_map.yaw_rad, 0.0, 1e-12);
}

TEST(SimFloors, TheSameSeedGivesTheSameBits)
{
  SimOptions options;
  options.seed = 7;
  options.lidar = true;
  options.people = 2;
  options.unmapped_boxes = 2;
  options.start = SimStart{-2.0, 1.0, 0.3};
  const auto run = [](const SimOptions & o) {
    SimRobot robot{two_floors(), {}, o};
    Pilot pilot{robot};
    pilot.roll(0.1, 5.0);
    return std::pair{robot.state(), pilot.frame().scan->ranges_m};
  };
  const auto first = run(options);
  EXPECT_EQ(first, run(options));
  options.seed = 8;
  EXPECT_NE(first.first, run(options).first);
}

TEST(SimFloors, ASnapshotGoesOnInTheFrameItWasIn)
{
  const std::string path = ::testing::TempDir() + "sim_floors.snapshot";
  std::filesystem::remove(path);
  SimOptions options;
  options.lidar = true;
  options.start = SimStart{5.6, 0.6, kHalfPi};
  const auto legs = [](Pilot & pilot, int from, int to) {
    for (int leg = from; leg < to; ++leg) {
      pilot.roll(0.1, 15.0);
    }
  };
  SimRobot whole{two_floors(), {}, options};
  Pilot whole_pilot{whole};
  legs(whole_pilot, 0, 2);
  options.snapshot_path = path;
  {
    SimRobot first{two_floors(), {}, options};
    Pilot pilot{first};
    legs(pilot, 0, 1);
  }
  SimRobot second{two_floors(), {}, options};
  Pilot pilot{second};
  EXPECT_EQ(second.resume_outcome(), ResumeOutcome::kResumed);
  legs(pilot, 1, 2);
  EXPECT_EQ(second.state(), whole.state());
  EXPECT_EQ(second.truth().in_map.y_m, whole.truth().in_map.y_m);
  std::filesystem::remove(path);
}

TEST(SimFloors, AKidnapStaysOnTheFloorAndClearOfEverything)
{
  struct
  {
    const char * flight;
    double x_m;
    std::size_t floor;
  } const floors[] = {{"lower", -0.5, 0}, {"lower", 5.6, 1}, {"upper", 3.6, 2}};
  const sim::Building building{two_floors(), nullptr, 1};
  for (const auto & floor : floors) {
    const sim::Storey & storey = building.floor(floor.floor);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      SimOptions options = standing_at(floor.x_m, 1.0);
      options.seed = seed;
      options.faults = parse_sim_faults("kidnap@0.5");
      SimRobot robot{two_floors(floor.flight), {}, options};
      Pilot pilot{robot};
      const GroundTruth before = robot.truth();
      pilot.during({}, 1.0);
      const GroundTruth after = robot.truth();
      EXPECT_EQ(after.segment, storey.id);
      EXPECT_GE(std::hypot(after.x_m - before.x_m, after.y_m - before.y_m), 1.0);
      EXPECT_GE(std::abs(stetro_site::wrap_angle(after.yaw_rad - before.yaw_rad)), 0.5);
      EXPECT_TRUE(storey.plan.inside(after.x_m, after.y_m));
      EXPECT_GE(storey.plan.wall_distance_m(after.x_m, after.y_m), 0.25);
      const Eigen::Vector3d at{after.in_map.x_m, after.in_map.y_m, 0.0};
      EXPECT_GE(building.stairs_distance_m(floor.floor, at), 1.25);
      EXPECT_NEAR(after.in_map.z_m, before.in_map.z_m, 1e-12);
      EXPECT_EQ(pilot.frame().odometry.x_m, 0.0);
      EXPECT_EQ(pilot.frame().gyro.rate_rad_s[2], 0.0);
      EXPECT_FALSE(after.fallen);
    }
  }
}

// Standing does not count, nor does what is driven on other floors.
TEST(SimFloors, AKidnapOfAFloorAwaitsTheDrivingThere)
{
  SimOptions options = standing_at(-2.0, 1.0);
  options.faults = parse_sim_faults("kidnap:ground@1,kidnap:landing@0.5");
  SimRobot robot{two_floors(), {}, options};
  Pilot pilot{robot};
  pilot.during({}, 5.0);
  pilot.roll(0.2, 0.9);
  EXPECT_NEAR(robot.truth().in_map.x_m, 3.18, 1e-6) << "5 m - 2 m and what it rolled";
  pilot.roll(0.2, 0.2);
  const GroundTruth carried = robot.truth();
  EXPECT_GE(std::hypot(carried.in_map.x_m - 3.2, carried.in_map.y_m - 1.0), 0.9);
  EXPECT_EQ(carried.segment, "ground");
  pilot.during({}, 2.0);
  EXPECT_EQ(robot.truth().in_map.x_m, carried.in_map.x_m) << "once";
}

TEST(SimFloors, AKidnapOnTheStairsIsAlongTheTread)
{
  SimOptions options = standing_at(0.235, 1.0);
  options.faults = parse_sim_faults("kidnap@0.5=0.4");
  SimRobot robot{two_floors(), {}, options};
  Pilot pilot{robot};
  pilot.during({}, 1.0);
  EXPECT_NEAR(robot.truth().y_m, 1.4, 1e-9);
  EXPECT_NEAR(robot.truth().x_m, 0.235, 1e-9);
}

// The walls of floors are beside its flights, not on them: the first step is climbed as ever.
TEST(SimFloors, StairsAreEnteredAsWithoutDrawings)
{
  const auto enter = [](SimRobot && robot) {
    Pilot pilot{robot};
    EXPECT_TRUE(pilot.lift(1));
    EXPECT_TRUE(pilot.until(Pilot::twist(0.05, 0.0, 0.0), 20.0, [](const SensorFrame & frame) {
      return closed(frame, ContactPlace::kRiserLeft) && closed(frame, ContactPlace::kRiserRight);
    }));
    EXPECT_TRUE(pilot.lower(1));
    EXPECT_TRUE(pilot.lift(2));
    pilot.roll(0.05, 4.0);
    EXPECT_TRUE(pilot.lower(2));
    return robot.truth();
  };
  const GroundTruth drawn = enter(SimRobot{two_floors(), {}, standing_at(-0.5, 1.0)});
  const GroundTruth bare = enter(SimRobot{test::paper_stairs(), {}, standing_at(-0.5, 1.0)});
  EXPECT_EQ(drawn.segment, "lower");
  EXPECT_EQ(drawn.step, 1);
  EXPECT_EQ(drawn.x_m, bare.x_m);
  EXPECT_EQ(drawn.y_m, bare.y_m);
  EXPECT_EQ(drawn.block_heights_m, bare.block_heights_m);
}

}  // namespace
}  // namespace stetro_driver
