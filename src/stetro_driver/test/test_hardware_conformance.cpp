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

// What every hardware promises, in the order of hardware_interface.hpp. Faults come from the
// world's list, so that the simulated robot and one behind emulated devices suffer the same. They
// strike four seconds after the world began: devices need some of that to be opened.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "hardware_bench.hpp"

namespace stetro_driver
{
namespace
{

using test::HardwareBench;
using test::kHalfPi;
using test::Pilot;

struct Candidate
{
  const char * name;
  test::MakeHardware make;
  double slack;  ///< share of a way that starting, stopping and a busy computer may take
};

void PrintTo(const Candidate & candidate, std::ostream * out) { *out << candidate.name; }

std::string name_of(const ::testing::TestParamInfo<Candidate> & info) { return info.param.name; }

class HardwareConformance : public ::testing::TestWithParam<Candidate>
{
protected:
  /// A perfect robot: what it senses is what the test can work out.
  HardwareBench & bench(const SimOptions & options = test::perfect())
  {
    bench_.emplace(GetParam().make(options));
    return *bench_;
  }

  /// What a way may differ by.
  static double error(double way) { return 1e-9 + way * GetParam().slack; }

  static SimOptions with(const std::string & faults)
  {
    SimOptions options = test::perfect();
    options.faults = parse_sim_faults(faults);
    return options;
  }

private:
  std::optional<HardwareBench> bench_;
};

TEST_P(HardwareConformance, SaysNothingBeforeItIsConfigured)
{
  HardwareBench & b = bench();
  const auto read = b.robot().read(b.now());
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.fault().kind, IoFaultKind::kNotConfigured);
  EXPECT_THROW(b.robot().activate(), HardwareError);
}

TEST_P(HardwareConformance, IsReadOnlyWhileInactive)
{
  HardwareBench & b = bench();
  b.robot().configure();
  b.robot().configure();  // twice is as good as once
  b.rest(0.2);
  const auto fault = b.robot().write(Pilot::twist(0.05, 0.0, 0.0));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kNotActive);
  b.rest(0.2);
  EXPECT_EQ(b.truth().x_m, -0.5);
}

TEST_P(HardwareConformance, StampsWhatItMeasuresOnTheCallersClock)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.rest(0.5);
  const SensorFrame frame = b.read();
  for (const RangeReading & range : frame.ranges) {
    EXPECT_LE(range.stamp, frame.time);
    EXPECT_GT(range.stamp, frame.time - std::chrono::milliseconds{150});
  }
  EXPECT_LE(frame.gyro.stamp, frame.time);
  EXPECT_GT(frame.gyro.stamp, frame.time - std::chrono::milliseconds{60});
  EXPECT_EQ(b.robot().read(frame.time - std::chrono::seconds{1}).fault().kind, IoFaultKind::kTime);
}

TEST_P(HardwareConformance, CompletesACycleOfRangesAboutThirtyTimesASecond)
{
  HardwareBench & b = bench();
  b.switch_on();
  int cycles = 0;
  b.wait(2.0, [&](const SensorFrame & frame) {
    cycles += frame.ranges_complete ? 1 : 0;
    return false;
  });
  EXPECT_GE(cycles, 30);
  EXPECT_LE(cycles, 62);
}

TEST_P(HardwareConformance, MeasuresInMetres)
{
  SimOptions options = test::perfect();
  options.start = SimStart{0.235, 0.925, 0.0};  // sweeping tread 1, 10 cm right of the middle
  HardwareBench & b = bench(options);
  b.switch_on();
  b.rest(0.3);
  const SensorFrame frame = b.read();
  // 2.05 - 0.925 - 0.05 and 0.925 - 0.05, longer by the cone, shorter by the riser beside.
  EXPECT_NEAR(frame.range(RangePlace::kSideLeft).range_m, 1.075, 0.03);
  EXPECT_NEAR(frame.range(RangePlace::kSideRight).range_m, 0.875, 0.03);
  EXPECT_NEAR(frame.range(RangePlace::kFrontLeft).range_m, 0.2175, 0.008);
  EXPECT_NEAR(frame.range(RangePlace::kBlock2Down).range_m, 0.035, 0.007);
  EXPECT_EQ(frame.range(RangePlace::kFrontLeft).status, RangeStatus::kValid);
  EXPECT_NEAR(frame.block(1).height_m, 0.14, 0.003);
  EXPECT_NEAR(frame.block(2).height_m, 0.0, 1e-3);
  EXPECT_TRUE(frame.block(2).at_lower_lock);
  for (const ContactReading & contact : frame.contacts) {
    EXPECT_FALSE(contact.closed);
    EXPECT_FALSE(contact.fault);
  }
  EXPECT_FALSE(frame.emergency_stop_latched);
  EXPECT_NEAR(frame.steering.angle_rad, 0.0, 0.01);
}

TEST_P(HardwareConformance, RollsForwardAlongX)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.during(Pilot::twist(0.10, 0.0, 0.0), 1.0);
  const double rolled_m = b.truth().x_m + 0.5;
  EXPECT_NEAR(rolled_m, 0.10, error(0.10));
  EXPECT_NEAR(b.truth().y_m, 1.025, 1e-3);
  b.during({}, 0.2);
  const OdometryReading odometry = b.read().odometry;
  EXPECT_NEAR(odometry.x_m, b.truth().x_m + 0.5, 0.01);
  EXPECT_NEAR(odometry.y_m, 0.0, 1e-3);
}

TEST_P(HardwareConformance, RollsLeftAlongYAndTurnsCounterClockwise)
{
  HardwareBench & b = bench();
  b.switch_on();
  ASSERT_TRUE(b.steer(kHalfPi));
  b.during(Pilot::twist(0.0, 0.10, 0.0), 1.0);
  EXPECT_NEAR(b.truth().y_m, 1.125, error(0.10));
  EXPECT_NEAR(b.truth().x_m, -0.5, 1e-3);
  double fastest_rad_s = 0.0;
  b.until(Pilot::twist(0.0, 0.0, 0.2), 1.0, [&](const SensorFrame & frame) {
    fastest_rad_s = std::max(fastest_rad_s, frame.gyro.rate_rad_s[2]);
    return false;
  });
  b.during({}, 0.2);
  EXPECT_NEAR(b.truth().yaw_rad, 0.2, error(0.2));
  EXPECT_NEAR(fastest_rad_s, 0.2, error(0.2));
  const OdometryReading odometry = b.read().odometry;
  EXPECT_NEAR(odometry.yaw_rad, b.truth().yaw_rad, 0.02);
  EXPECT_GT(odometry.y_m, 0.06);
}

TEST_P(HardwareConformance, RatesOfTurnAddUpToTheTurn)
{
  HardwareBench & b = bench();
  b.switch_on();
  ASSERT_TRUE(b.steer(kHalfPi));
  Time last = b.read().gyro.stamp;
  double turned_rad = 0.0;
  const auto add = [&](const SensorFrame & frame) {
    turned_rad += frame.gyro.rate_rad_s[2] * time_to_seconds(frame.gyro.stamp - last);
    last = frame.gyro.stamp;
    return false;
  };
  b.until(Pilot::twist(0.0, 0.0, 0.25), 0.7, add);
  b.until(Pilot::twist(0.0, 0.0, -0.15), 0.4, add);
  b.until({}, 0.4, add);
  EXPECT_GT(b.truth().yaw_rad, 0.05);
  EXPECT_NEAR(turned_rad, b.truth().yaw_rad, 0.001);
}

TEST_P(HardwareConformance, RefusesToRollAcrossItsWheels)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.rest(0.1);
  EXPECT_EQ(b.robot().write(Pilot::twist(0.0, 0.1, 0.0))->kind, IoFaultKind::kWrongSteering);
  EXPECT_EQ(b.robot().write(Pilot::twist(0.0, 0.0, 0.1))->kind, IoFaultKind::kWrongSteering);
  ASSERT_TRUE(b.steer(kHalfPi));
  EXPECT_EQ(b.robot().write(Pilot::twist(0.1, 0.0, 0.0))->kind, IoFaultKind::kWrongSteering);
}

TEST_P(HardwareConformance, RefusesNonsense)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.rest(0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(b.robot().write(Pilot::twist(nan, 0.0, 0.0))->kind, IoFaultKind::kBadCommand);
  EXPECT_EQ(b.robot().write(Pilot::vertical(MotionKind::kLift, 7))->kind, IoFaultKind::kBadCommand);
  JointCommand unknown;
  unknown.kind = MotionKind::kUnknown;
  EXPECT_EQ(b.robot().write(unknown)->kind, IoFaultKind::kBadCommand);
}

TEST_P(HardwareConformance, HoldsWhenToldTo)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.during(Pilot::twist(0.10, 0.0, 0.0), 0.5);
  b.during({}, 0.15);
  const double stopped_m = b.truth().x_m;
  b.during({}, 0.3);
  EXPECT_NEAR(b.truth().x_m, stopped_m, 1e-6);
}

TEST_P(HardwareConformance, MakeSafeHoldsUntilItIsActivatedAgain)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.during(Pilot::twist(0.05, 0.0, 0.0), 0.3);
  b.robot().make_safe();
  b.robot().make_safe();
  b.rest(0.15);
  const double stopped_m = b.truth().x_m;
  b.during(Pilot::twist(0.05, 0.0, 0.0), 0.3);
  EXPECT_TRUE(b.refused());
  EXPECT_NEAR(b.truth().x_m, stopped_m, 1e-6);
  b.robot().activate();
  b.during(Pilot::twist(0.05, 0.0, 0.0), 0.5);
  EXPECT_FALSE(b.refused());
  EXPECT_GT(b.truth().x_m, stopped_m + 0.01);
}

TEST_P(HardwareConformance, LiftsABlockToItsLockAndLowersItAgain)
{
  HardwareBench & b = bench();
  b.switch_on();
  ASSERT_TRUE(b.until(Pilot::vertical(MotionKind::kLift, 1), 6.0, [](const SensorFrame & frame) {
    return frame.block(1).at_upper_lock;
  }));
  EXPECT_NEAR(b.read().block(1).height_m, 0.18, 0.004);
  EXPECT_FALSE(b.read().block(1).at_lower_lock);
  EXPECT_EQ(b.read().block(1).load, 0.0);
  ASSERT_TRUE(b.until(Pilot::vertical(MotionKind::kLower, 1), 6.0, [](const SensorFrame & frame) {
    return frame.block(1).at_lower_lock;
  }));
  b.during({}, 0.2);
  EXPECT_NEAR(b.read().block(1).height_m, 0.0, 0.004);
  EXPECT_FALSE(b.read().block(1).load < 0.05) << "NaN: a hardware that cannot tell";
  EXPECT_FALSE(b.truth().fallen);
}

TEST_P(HardwareConformance, KeepsALiftedBlockWhereItIsWithoutPower)
{
  HardwareBench & b = bench();
  b.switch_on();
  b.during(Pilot::vertical(MotionKind::kLift, 1), 1.0);
  b.robot().deactivate();
  b.rest(0.2);
  const double height_m = b.truth().block_heights_m[0];
  EXPECT_GT(height_m, 0.03);
  b.rest(0.5);
  EXPECT_NEAR(b.truth().block_heights_m[0], height_m, 1e-4);
  EXPECT_EQ(b.robot().write({})->kind, IoFaultKind::kNotActive);
  b.robot().activate();
  b.during({}, 0.3);
  EXPECT_NEAR(b.truth().block_heights_m[0], height_m, 2e-3);
}

TEST_P(HardwareConformance, FeelsAWallOnTheSideItIsOn)
{
  SimOptions options = test::perfect();
  options.start = SimStart{-0.5, 1.90, 0.0};  // 3.5 cm from the left wall
  HardwareBench & b = bench(options);
  b.switch_on();
  ASSERT_TRUE(b.steer(kHalfPi));
  ASSERT_TRUE(b.until(Pilot::twist(0.0, 0.05, 0.0), 3.0, [](const SensorFrame & frame) {
    return frame.contact(ContactPlace::kLeftMiddle).closed;
  }));
  const SensorFrame frame = b.read();
  EXPECT_GT(frame.contact(ContactPlace::kLeftMiddle).last_change, Time::zero());
  EXPECT_FALSE(frame.contact(ContactPlace::kRightMiddle).closed);
  EXPECT_NEAR(b.truth().y_m, 2.05 - 0.115, 0.01);
}

TEST_P(HardwareConformance, AnEmergencyStopLatches)
{
  HardwareBench & b = bench(with("estop@4-5.5"));
  b.switch_on();
  ASSERT_TRUE(b.until(Pilot::twist(0.02, 0.0, 0.0), 5.0, [](const SensorFrame & frame) {
    return frame.emergency_stop_latched;
  }));
  EXPECT_TRUE(b.read().contact(ContactPlace::kEmergencyStop).closed);
  b.rest(0.1);
  const double stopped_m = b.truth().x_m;
  EXPECT_EQ(b.robot().write(Pilot::twist(0.05, 0.0, 0.0))->kind, IoFaultKind::kEmergencyStop);
  EXPECT_THROW(b.robot().reset_emergency_stop(), HardwareError) << "it is pressed";
  EXPECT_THROW(b.robot().activate(), HardwareError);
  ASSERT_TRUE(b.wait(3.0, [](const SensorFrame & frame) {
    return !frame.contact(ContactPlace::kEmergencyStop).closed;
  }));
  EXPECT_TRUE(b.read().emergency_stop_latched) << "released is not reset";
  EXPECT_EQ(b.robot().write({})->kind, IoFaultKind::kEmergencyStop);
  b.robot().reset_emergency_stop();
  b.rest(0.1);
  EXPECT_FALSE(b.read().emergency_stop_latched);
  EXPECT_EQ(b.truth().x_m, stopped_m);
  b.robot().activate();
  b.during(Pilot::twist(0.05, 0.0, 0.0), 0.5);
  EXPECT_GT(b.truth().x_m, stopped_m + 0.01);
}

TEST_P(HardwareConformance, NamesARangeSensorThatDoesNotAnswer)
{
  HardwareBench & b = bench(with("dead:front_left@4-5"));
  b.switch_on();
  b.rest(0.5);
  EXPECT_EQ(b.read().range(RangePlace::kFrontLeft).status, RangeStatus::kValid);
  ASSERT_TRUE(b.wait(5.0, [](const SensorFrame & frame) {
    return frame.range(RangePlace::kFrontLeft).status == RangeStatus::kFault;
  }));
  EXPECT_LT(b.now(), test::perfect().origin + std::chrono::milliseconds{4250});
  EXPECT_EQ(b.read().range(RangePlace::kFrontRight).status, RangeStatus::kValid);
  EXPECT_TRUE(b.wait(
    4.0,
    [](const SensorFrame & frame) {
      return frame.range(RangePlace::kFrontLeft).status == RangeStatus::kValid;
    }))
    << "it comes back by itself";
}

TEST_P(HardwareConformance, NamesAGyroscopeThatDoesNotAnswer)
{
  HardwareBench & b = bench(with("dead:gyro@4-5"));
  b.switch_on();
  b.rest(0.5);
  EXPECT_FALSE(b.read().gyro.fault);
  ASSERT_TRUE(b.wait(5.0, [](const SensorFrame & frame) { return frame.gyro.fault; }));
  EXPECT_LT(b.now(), test::perfect().origin + std::chrono::milliseconds{4250});
  EXPECT_TRUE(b.wait(4.0, [](const SensorFrame & frame) { return !frame.gyro.fault; }));
}

TEST_P(HardwareConformance, NamesASwitchThatIsBroken)
{
  HardwareBench & b = bench(with("dead:left_middle@4-5"));
  b.switch_on();
  b.rest(0.5);
  EXPECT_FALSE(b.read().contact(ContactPlace::kLeftMiddle).fault);
  ASSERT_TRUE(b.wait(
    5.0, [](const SensorFrame & frame) { return frame.contact(ContactPlace::kLeftMiddle).fault; }));
  EXPECT_LT(b.now(), test::perfect().origin + std::chrono::milliseconds{4500});
  EXPECT_FALSE(b.read().contact(ContactPlace::kRightMiddle).fault);
  EXPECT_TRUE(b.wait(4.0, [](const SensorFrame & frame) {
    const ContactReading & contact = frame.contact(ContactPlace::kLeftMiddle);
    return !contact.fault && !contact.closed;
  }));
}

INSTANTIATE_TEST_SUITE_P(
  Robots, HardwareConformance,
  ::testing::Values(
    Candidate{"simulated", test::make_sim_robot, 0.0},
    Candidate{"emulated", test::make_emulated_robot, 0.3}),
  name_of);

}  // namespace
}  // namespace stetro_driver
