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

// The fault matrix in mid-climb: every device of the real robot unplugged, silent, slow, garbled
// and replaced by another, twice in a row: while it sweeps a tread, and while it lifts a block.
// Patience is what is shipped. The same faults at the start are in the tests of each device.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "device_bench.hpp"
#include "hardware_bench.hpp"

namespace stetro_driver
{
namespace
{

using emulator::EmulatedDevices;
using emulator::TofTrouble;
using test::HardwareBench;
using test::Pilot;

// All times are of the devices, which run at this share of their speed: a computer that tests share
// wakes no thread within the 5 ms of a servo's reply.
constexpr double kDeviceSpeed = 0.5;
constexpr double kMachine_s = 0.05;  // by which that computer may be late all the same
constexpr double kRangePeriod_s = 0.035;
constexpr double kImuPeriod_s = 0.01;
constexpr double kServoPeriod_s = 0.02;
constexpr double kLinePeriod_s = 0.02;
constexpr double kRelay_s = 0.2;  // opens when the servo line is dead
constexpr double kNamedWithin_s = 4.0;
constexpr double kWellAgainWithin_s = 8.0;  // back-off, opening, and trust

constexpr RangePlace kPlace = RangePlace::kFrontLeft;
constexpr std::uint8_t kWheel = 3;
constexpr std::uint8_t kLift = 7;
constexpr const char * kChip = "gpiochip0";

using Act = std::function<void(EmulatedDevices &)>;

/// What is wrong with a device.
struct Trouble
{
  std::string name;
  double period_s;  ///< three of them may pass until it is known
  Act strike;
  Act end;
  IoFaultKind kind;      ///< of its fault once it is known what it is
  std::string words;     ///< in that fault
  bool latches = false;  ///< a person has to reset the emergency stop
};

void PrintTo(const Trouble & trouble, std::ostream * out) { *out << trouble.name; }

constexpr auto kSilent = IoFaultKind::kSilent;
constexpr auto kBadAnswer = IoFaultKind::kBadAnswer;

void plug_range(EmulatedDevices & d) { d.tree().plug(*d.sensor(kPlace)); }
void unplug_range(EmulatedDevices & d) { d.tree().unplug(d.sensor(kPlace)->i2c_name); }

Trouble range(TofTrouble what, const char * name, IoFaultKind kind, const char * words)
{
  return {
    name,
    kRangePeriod_s,
    [what](EmulatedDevices & d) { d.tof(kPlace)->set_trouble(what); },
    [](EmulatedDevices & d) { d.tof(kPlace)->set_trouble(TofTrouble::kNone); },
    kind,
    words};
}

Trouble another_kind_of_sensor()
{
  return {
    "range_replaced",
    kRangePeriod_s,
    [](EmulatedDevices & d) {
      unplug_range(d);
      emulator::IioDevice other = *d.sensor(kPlace);
      other.name = "bno055";
      other.tof = std::make_shared<emulator::EmulatedTof>(linux_io::DeviceClock{});
      d.tree().plug(other);
    },
    [](EmulatedDevices & d) {
      unplug_range(d);
      plug_range(d);
    },
    kBadAnswer,
    "'bno055'"};
}

Trouble imu(
  const char * name, const emulator::Vn100Trouble & what, IoFaultKind kind, const char * words)
{
  return {
    name,
    kImuPeriod_s,
    [what](EmulatedDevices & d) { d.imu().set_trouble(what); },
    [](EmulatedDevices & d) { d.imu().set_trouble({}); },
    kind,
    words};
}

Trouble other_imu(const char * name, const char * model, const char * serial, const char * words)
{
  return {
    name,
    kImuPeriod_s,
    [=](EmulatedDevices & d) {
      d.imu().replace(model, serial);
      d.imu().plug();
    },
    [](EmulatedDevices & d) {
      d.imu().replace("VN-100T-CR", d.devices().imu.serial_number);
      d.imu().plug();
    },
    kBadAnswer,
    words};
}

Trouble servos(const char * name, const emulator::HerkulexFaults & what, const char * words)
{
  return {
    name,
    kServoPeriod_s,
    [what](EmulatedDevices & d) { d.servos().set_faults(what); },
    [](EmulatedDevices & d) { d.servos().set_faults({}); },
    kSilent,
    words};
}

Trouble another_servo()
{
  const auto number = [](EmulatedDevices & d, std::uint8_t from, std::uint8_t to) {
    d.servos().with(from, [to](emulator::EmulatedServo & servo) { servo.set_id(to); });
  };
  return {
    "servo_replaced",
    kServoPeriod_s,
    [number](EmulatedDevices & d) { number(d, kWheel, 9); },
    [number](EmulatedDevices & d) { number(d, 9, kWheel); },
    kSilent,
    "(servo 3): no answer"};
}

Trouble lines(const char * name, const Act & strike, const Act & end)
{
  return {name, kLinePeriod_s, strike, end, IoFaultKind::kEmergencyStop, "emergency stop", true};
}

std::vector<Trouble> troubles()
{
  emulator::Vn100Trouble silent_imu;
  silent_imu.silent = true;
  emulator::Vn100Trouble slow_imu;
  slow_imu.slow = 8.0;
  emulator::Vn100Trouble garbled_imu;
  garbled_imu.flip_per_byte = 0.3;
  garbled_imu.lose_per_byte = 0.05;
  emulator::HerkulexFaults silent_servo;
  silent_servo.silent = {kLift};
  emulator::HerkulexFaults slow_servos;
  slow_servos.delay = std::chrono::milliseconds{30};
  emulator::HerkulexFaults garbled_servos;
  garbled_servos.garbled = 1.0;
  return {
    {"range_unplugged", kRangePeriod_s, unplug_range, plug_range, kSilent, "0 devices"},
    range(TofTrouble::kNoReply, "range_wires_off", kSilent, "EREMOTEIO"),
    range(TofTrouble::kSilent, "range_silent", kSilent, "ETIMEDOUT"),
    range(TofTrouble::kSlow, "range_slow", kSilent, "accepted: at most 70 ms"),
    range(TofTrouble::kGarbled, "range_garbled", kBadAnswer, "accepted: 0 to 8191"),
    another_kind_of_sensor(),
    {"imu_unplugged", kImuPeriod_s, [](EmulatedDevices & d) { d.imu().unplug(); },
     [](EmulatedDevices & d) { d.imu().plug(); }, kSilent, "cannot open"},
    imu("imu_silent", silent_imu, kSilent, "no measurement for"),
    imu("imu_slow", slow_imu, kSilent, "no measurement for"),
    imu("imu_garbled", garbled_imu, kBadAnswer, "garbled"),
    other_imu("imu_replaced", "VN-100T-CR", "0100099999", "replaced by serial number 0100099999"),
    other_imu("imu_of_another_model", "VN-300T-CR", "0300012345", "model 'VN-300T-CR'"),
    {"servos_unplugged", kServoPeriod_s, [](EmulatedDevices & d) { d.servos().unplug(); },
     [](EmulatedDevices & d) { d.servos().plug(); }, kSilent, "servo bus: cannot open"},
    servos("servo_silent", silent_servo, "(servo 7): no answer"),
    servos("servos_slow", slow_servos, "servo bus: no servo answers"),
    servos("servos_garbled", garbled_servos, "servo bus: no servo answers"),
    another_servo(),
    lines(
      "lines_unplugged", [](EmulatedDevices & d) { d.lines().set_plugged(kChip, false); },
      [](EmulatedDevices & d) { d.lines().set_plugged(kChip, true); }),
    lines(
      "lines_replaced", [](EmulatedDevices & d) { d.lines().replace(kChip, 8); },
      [](EmulatedDevices & d) { d.lines().replace(kChip, 54); }),
    {"lines_silent", kLinePeriod_s, [](EmulatedDevices & d) { d.lines().set_hanging(true); },
     [](EmulatedDevices & d) { d.lines().set_hanging(false); }, kSilent,
     "contacts: does not answer in time"},
  };
}

/// What the robot is doing when a device fails.
struct Motion
{
  const char * name;
  JointCommand command;
  double speed_m_s;
  double (*way_m)(const GroundTruth & truth);
  double still_m;  ///< a robot that moves by less holds
};

std::vector<Motion> motions()
{
  constexpr double kSweep_m_s = 0.05;
  constexpr double kLift_m_s = 0.06;
  return {
    {"sweeping", Pilot::twist(0.0, kSweep_m_s, 0.0), kSweep_m_s,
     [](const GroundTruth & truth) { return truth.y_m; }, 1e-6},
    {"lifting", Pilot::vertical(MotionKind::kLift, 2), kLift_m_s,
     [](const GroundTruth & truth) { return truth.block_heights_m[1]; }, 0.002},
  };
}

class FaultMatrix : public ::testing::TestWithParam<Trouble>
{
protected:
  FaultMatrix()
  {
    SimOptions options = test::perfect();
    options.start = SimStart{0.235, 1.025, 0.0};  // blocks 2 and 3 on tread 1, block 1 on tread 2
    linux_io::Devices devices = test::shipped_devices();
    devices.imu.serial_number = "0100012345";
    auto robot = test::emulated_robot(options, devices, kDeviceSpeed);
    devices_ = &robot->emulated();
    SimulatedWorld & world = *robot;
    bench_.emplace(DriverHardware{std::move(robot), &world, nullptr});
    EXPECT_TRUE(eventually([this] { return switched_on(); }));
  }

  /// That it starts is not what this is about: on a busy computer it may take more than one try.
  bool switched_on()
  {
    try {
      bench_->switch_on();
      return true;
    } catch (const HardwareError &) {
      return false;
    }
  }

  [[nodiscard]] double way_m() const { return motion_.way_m(bench_->truth()); }

  /// Moves, or tries to, until something is so. \return whether it came true
  template <class Done>
  bool move(double limit_s, Done && done)
  {
    return bench_->until(motion_.command, limit_s, [&](const SensorFrame &) { return done(); });
  }
  void move(double seconds) { bench_->during(motion_.command, seconds); }

  bool moves_on()
  {
    const double from_m = way_m();
    return move(kWellAgainWithin_s, [&] { return !bench_->refused() && way_m() > from_m + 0.01; });
  }

  void expect_fault_in_time(Time struck)
  {
    const Trouble & trouble = GetParam();
    EXPECT_LT(time_to_seconds(bench_->now() - struck), 3.0 * trouble.period_s + kMachine_s);
    EXPECT_TRUE(move(kNamedWithin_s, [&] { return is_named(trouble); })) << answer();
  }

  void expect_hold(double struck_at_m)
  {
    move(kRelay_s);
    const double held_m = way_m();
    const double known_within_s = 3.0 * GetParam().period_s + kMachine_s;
    EXPECT_LT(held_m - struck_at_m, motion_.speed_m_s * (known_within_s + kRelay_s));
    move(0.3);
    EXPECT_NEAR(way_m(), held_m, motion_.still_m) << "it holds";
    EXPECT_TRUE(bench_->refused());
  }

  [[nodiscard]] bool is_named(const Trouble & trouble) const
  {
    const auto & fault = bench_->refused();
    return fault && fault->kind == trouble.kind &&
           fault->detail.find(trouble.words) != std::string::npos;
  }

  [[nodiscard]] std::string answer() const
  {
    return bench_->refused() ? bench_->refused()->detail : "no fault";
  }

  bool reset_emergency_stop()
  {
    return bench_->wait(kWellAgainWithin_s, [this](const SensorFrame &) {
      try {
        bench_->robot().reset_emergency_stop();
        return true;
      } catch (const HardwareError &) {
        return false;  // nobody can see the button yet
      }
    });
  }

  EmulatedDevices * devices_ = nullptr;
  std::optional<HardwareBench> bench_;
  Motion motion_ = motions()[0];
};

TEST_P(FaultMatrix, HoldsSaysWhyAndGoesOn)
{
  const Trouble & trouble = GetParam();
  ASSERT_TRUE(eventually([this] { return bench_->steer(test::kHalfPi); })) << answer();
  ASSERT_TRUE(moves_on()) << answer();
  const OpenResources well;
  for (const Motion & motion : motions()) {
    SCOPED_TRACE(motion.name);
    motion_ = motion;
    ASSERT_TRUE(moves_on()) << answer();
    const double struck_at_m = way_m();
    const Time struck = bench_->now();
    trouble.strike(*devices_);
    ASSERT_TRUE(move(2.0, [&] { return bench_->refused().has_value(); }));
    expect_fault_in_time(struck);
    expect_hold(struck_at_m);
    trouble.end(*devices_);
    ASSERT_TRUE(!trouble.latches || reset_emergency_stop());
    ASSERT_TRUE(move(kWellAgainWithin_s, [&] { return !bench_->refused(); })) << answer();
    ASSERT_TRUE(moves_on()) << answer();
    EXPECT_TRUE(OpenResources{} == well) << "nothing leaks";
  }
  EXPECT_FALSE(bench_->truth().fallen);
}

INSTANTIATE_TEST_SUITE_P(
  InMidClimb, FaultMatrix, ::testing::ValuesIn(troubles()),
  [](const ::testing::TestParamInfo<Trouble> & tested) { return tested.param.name; });

}  // namespace
}  // namespace stetro_driver
