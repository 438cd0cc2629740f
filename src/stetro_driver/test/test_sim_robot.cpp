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
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "pilot.hpp"
#include "sim/archive.hpp"
#include "sim/sim_world.hpp"
#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver
{
namespace
{

using std::chrono::milliseconds;
using test::kHalfPi;
using test::paper_stairs;
using test::perfect;
using test::Pilot;

TEST(SimRobot, IsReadOnlyWhileInactive)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  EXPECT_EQ(robot.read(robot.time()).fault().kind, IoFaultKind::kNotConfigured);
  robot.configure();
  EXPECT_TRUE(robot.read(robot.time()).ok());
  EXPECT_EQ(robot.write(Pilot::twist(0.05, 0.0, 0.0))->kind, IoFaultKind::kNotActive);
  robot.step();
  EXPECT_EQ(robot.truth().x_m, -0.5);
}

TEST(SimRobot, TimeStartsWellAboveZeroAndGoesByTicks)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  robot.configure();
  EXPECT_EQ(robot.time(), std::chrono::seconds{1000});
  robot.step();
  EXPECT_EQ(robot.time(), milliseconds{1'000'010});
  EXPECT_EQ(robot.read(milliseconds{1'000'000}).fault().kind, IoFaultKind::kTime);
}

TEST(SimRobot, ReadsWhatItExpectsAtRest)
{
  SimOptions options = perfect();
  options.start = SimStart{0.235, 1.025, 0.0};
  SimRobot robot{paper_stairs(), {}, options};
  Pilot pilot{robot};
  pilot.during({}, 0.2);
  const SensorFrame frame = pilot.frame();
  // 1.025 - 0.05 to either wall, times 1.012 for the cone, less what the riser beside returns.
  EXPECT_NEAR(frame.range(RangePlace::kSideLeft).range_m, 0.98, 0.015);
  EXPECT_EQ(
    frame.range(RangePlace::kSideLeft).range_m, frame.range(RangePlace::kSideRight).range_m);
  EXPECT_NEAR(frame.range(RangePlace::kFrontLeft).range_m, 0.2175, 0.0011);
  EXPECT_NEAR(frame.range(RangePlace::kBlock2Down).range_m, 0.035, 0.0011);
  EXPECT_NEAR(frame.block(1).height_m, 0.14, 1e-9);
  EXPECT_NEAR(frame.block(2).height_m, 0.0, 1e-9);
  EXPECT_TRUE(frame.block(2).at_lower_lock);
  for (const ContactReading & contact : frame.contacts) {
    EXPECT_FALSE(contact.closed);
  }
  EXPECT_EQ(frame.gyro.stamp, frame.time);
  EXPECT_LE(frame.time - frame.range(RangePlace::kSideLeft).stamp, milliseconds{60});
  EXPECT_GE(frame.time - frame.range(RangePlace::kSideLeft).stamp, milliseconds{20});
}

TEST(SimRobot, RangesComeThirtyTimesASecond)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  Pilot pilot{robot};
  int cycles = 0;
  pilot.until({}, 10.0, [&](const SensorFrame & frame) {
    cycles += frame.ranges_complete ? 1 : 0;
    return false;
  });
  EXPECT_NEAR(cycles, 300, 1);
}

TEST(SimRobot, RollsOnlyWhereTheWheelsPoint)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  Pilot pilot{robot};
  EXPECT_EQ(robot.write(Pilot::twist(0.0, 0.1, 0.0))->kind, IoFaultKind::kWrongSteering);
  pilot.steer(kHalfPi);
  EXPECT_FALSE(robot.write(Pilot::twist(0.0, 0.1, 0.1)));
  EXPECT_EQ(robot.write(Pilot::twist(0.1, 0.0, 0.0))->kind, IoFaultKind::kWrongSteering);
  const double y_m = robot.truth().y_m;
  pilot.during(Pilot::twist(0.0, 0.1, 0.0), 1.0);
  EXPECT_NEAR(robot.truth().y_m, y_m + 0.1, 1e-9);
}

TEST(SimRobot, MakeSafeHoldsUntilActivatedAgain)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  Pilot pilot{robot};
  ASSERT_FALSE(robot.write(Pilot::twist(0.05, 0.0, 0.0)));
  robot.make_safe();
  robot.make_safe();
  robot.step();
  EXPECT_EQ(robot.truth().x_m, -0.5);
  EXPECT_TRUE(robot.write(Pilot::twist(0.05, 0.0, 0.0)));
  robot.activate();
  EXPECT_FALSE(robot.write(Pilot::twist(0.05, 0.0, 0.0)));
}

TEST(SimRobot, AFallIsAFaultThatStays)
{
  SimRobot robot{paper_stairs(), {}, perfect()};
  Pilot pilot{robot};
  ASSERT_TRUE(pilot.lift(1));
  pilot.during(Pilot::vertical(MotionKind::kLift, 2), 0.02);
  EXPECT_TRUE(robot.truth().fallen);
  EXPECT_EQ(robot.write({})->kind, IoFaultKind::kFallen);
  EXPECT_TRUE(pilot.frame().block(1).fault);
  EXPECT_THROW(robot.activate(), HardwareError);
}

TEST(SimRobot, StartsInTheMiddleOfTheFloor)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SimOptions options;
    options.seed = seed;
    const GroundTruth truth = SimRobot{paper_stairs(), {}, options}.truth();
    EXPECT_NEAR(truth.x_m, -0.5, 0.05);
    EXPECT_NEAR(truth.y_m, 1.025, 0.05);
    EXPECT_EQ(truth.step, 0);
  }
}

/// The states that a robot with all errors goes through.
std::vector<std::uint8_t> state_after(SimRobot & robot, double seconds)
{
  Pilot pilot{robot};
  pilot.roll(0.05, seconds);
  return robot.state();
}

TEST(SimRobot, TheSameSeedGivesTheSameBits)
{
  SimOptions options;
  options.seed = 7;
  SimRobot a{paper_stairs(), {}, options};
  SimRobot b{paper_stairs(), {}, options};
  options.seed = 8;
  SimRobot c{paper_stairs(), {}, options};
  const auto state = state_after(a, 5.0);
  EXPECT_EQ(state, state_after(b, 5.0));
  EXPECT_NE(state, state_after(c, 5.0));
}

class SimRobotSnapshot : public ::testing::Test
{
protected:
  SimRobotSnapshot() : path_(::testing::TempDir() + "sim_robot.snapshot")
  {
    std::filesystem::remove(path_);
    std::filesystem::remove(path_ + ".refused");
    options_.snapshot_path = path_;
  }
  ~SimRobotSnapshot() override
  {
    std::filesystem::remove(path_);
    std::filesystem::remove(path_ + ".refused");
  }

  std::string path_;
  SimOptions options_;
};

TEST_F(SimRobotSnapshot, GoesOnBitForBit)
{
  SimOptions alone = options_;
  alone.snapshot_path.clear();
  SimRobot whole{paper_stairs(), {}, alone};
  Pilot whole_pilot{whole};
  whole_pilot.roll(0.05, 2.0);
  whole_pilot.roll(0.05, 3.0);
  {
    SimRobot first{paper_stairs(), {}, options_};
    Pilot pilot{first};
    EXPECT_EQ(first.resume_outcome(), ResumeOutcome::kFresh);
    pilot.roll(0.05, 2.0);
  }
  SimRobot second{paper_stairs(), {}, options_};
  Pilot pilot{second};
  EXPECT_EQ(second.resume_outcome(), ResumeOutcome::kResumed);
  EXPECT_EQ(second.time(), std::chrono::seconds{1002}) << "time does not run backwards";
  pilot.roll(0.05, 3.0);
  EXPECT_EQ(second.state(), whole.state());
}

TEST_F(SimRobotSnapshot, ComesBackStandingAndHolding)
{
  {
    SimRobot robot{paper_stairs(), {}, options_};
    Pilot pilot{robot};
    pilot.during(Pilot::vertical(MotionKind::kLift, 1), 1.0);  // killed in mid-lift
  }
  SimRobot robot{paper_stairs(), {}, options_};
  robot.configure();
  const double height_m = robot.truth().block_heights_m[0];
  EXPECT_NEAR(height_m, 0.06, 1e-9);
  EXPECT_EQ(robot.read(robot.time()).value().contacts.size(), kContactPlaces);
  robot.activate();
  for (int tick = 0; tick < 100; ++tick) {
    robot.step();
  }
  EXPECT_EQ(robot.truth().block_heights_m[0], height_m);
}

TEST_F(SimRobotSnapshot, OfAnotherWorldIsReportedAndNotUsed)
{
  {
    SimRobot robot{paper_stairs(), {}, options_};
    Pilot pilot{robot};
    pilot.roll(0.05, 1.0);
  }
  options_.seed = 99;
  SimRobot robot{paper_stairs(), {}, options_};
  robot.configure();
  EXPECT_EQ(robot.resume_outcome(), ResumeOutcome::kForeign);
  EXPECT_EQ(robot.time(), std::chrono::seconds{1000});
  EXPECT_TRUE(std::filesystem::exists(path_ + ".refused")) << robot.resume_detail();
}

TEST_F(SimRobotSnapshot, KeepsALatchedEmergencyStop)
{
  options_.faults = parse_sim_faults("estop@0.5-0.6");
  {
    SimRobot robot{paper_stairs(), {}, options_};
    Pilot pilot{robot};
    for (int tick = 0; tick < 100; ++tick) {
      robot.step();
    }
  }
  SimRobot robot{paper_stairs(), {}, options_};
  robot.configure();
  EXPECT_TRUE(robot.read(robot.time()).value().emergency_stop_latched);
  EXPECT_THROW(robot.activate(), HardwareError);
  robot.reset_emergency_stop();
  robot.activate();
  EXPECT_FALSE(robot.write({}));
}

TEST_F(SimRobotSnapshot, OfAnotherLayoutIsOfAnotherWorld)
{
  EXPECT_NE(
    identity_of(building_of(paper_stairs()), {}, options_),
    identity_of(building_of(paper_stairs()), {}, options_, kStateLayout + 1));
  // Whoever changes what a world stores changes this number, and kStateLayout with it.
  EXPECT_EQ(kStateLayout, 6u);
  EXPECT_EQ((SimRobot{paper_stairs(), {}, options_}.state().size()), 5468u);
}

TEST(StateReader, IsExhaustedByExactlyWhatIsThere)
{
  const std::vector<std::uint8_t> bytes(8);
  std::uint32_t half = 0;
  sim::StateReader reader{bytes};
  reader(half);
  EXPECT_FALSE(reader.exhausted());
  reader(half);
  EXPECT_TRUE(reader.exhausted());
  reader(half);
  EXPECT_FALSE(reader.exhausted()) << "asked for more than there was";
}

TEST_F(SimRobotSnapshot, ThatIsDamagedIsReportedAndNotUsed)
{
  std::ofstream(path_) << "a shopping list";
  SimRobot robot{paper_stairs(), {}, options_};
  robot.configure();
  EXPECT_EQ(robot.resume_outcome(), ResumeOutcome::kDamaged);
  robot.step();
  EXPECT_EQ(robot.time(), milliseconds{1'000'010});
}

}  // namespace
}  // namespace stetro_driver
