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

#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "vn100_bench.hpp"

namespace stetro_driver
{
namespace
{

using emulator::Vn100Emulator;
using emulator::Vn100Trouble;
using linux_io::Vn100;

/// One way to break an emulated VN-100, and what the driver says then.
struct Breakdown
{
  const char * name;
  void (*begin)(Vn100Emulator &);
  void (*end)(Vn100Emulator &);
  IoFaultKind kind;       ///< of the fault in the middle, once it is known what it is
  const char * words;     ///< in it
  const char * at_start;  ///< in what is thrown
};

void PrintTo(const Breakdown & breakdown, std::ostream * out) { *out << breakdown.name; }

void heal(Vn100Emulator & emulator) { emulator.set_trouble({}); }
void plug_in(Vn100Emulator & emulator) { emulator.plug(); }
void put_the_first_back(Vn100Emulator & emulator)
{
  emulator.replace("VN-100T-CR", "0100012345");
  emulator.plug();
}

const Breakdown kBreakdowns[] = {
  {"Unplugged", [](Vn100Emulator & e) { e.unplug(); }, plug_in, IoFaultKind::kSilent, "cannot open",
   "cannot open"},
  {"Silent", [](Vn100Emulator & e) { e.set_trouble(Vn100Trouble{true}); }, heal,
   IoFaultKind::kSilent, "no measurement for", "no answer to VNRRG,01"},
  {"Slow",
   [](Vn100Emulator & e) {
     e.set_trouble(Vn100Trouble{false, 8.0});
   },
   heal, IoFaultKind::kSilent, "no measurement for", "no measurement for"},
  {"Garbled",
   [](Vn100Emulator & e) {
     e.set_trouble(Vn100Trouble{false, 1.0, 0.3, 0.05});
   },
   heal, IoFaultKind::kBadAnswer, "garbled", "garbled"},
  {"ReplacedByAnotherUnit",
   [](Vn100Emulator & e) {
     e.replace("VN-100T-CR", "0100099999");
     e.plug();
   },
   put_the_first_back, IoFaultKind::kBadAnswer, "replaced by serial number 0100099999",
   "replaced by serial number 0100099999"},
  {"ReplacedByAnotherModel",
   [](Vn100Emulator & e) {
     e.replace("VN-300T-CR", "0300012345");
     e.plug();
   },
   put_the_first_back, IoFaultKind::kBadAnswer, "model 'VN-300T-CR'", "model 'VN-300T-CR'"},
};

class Vn100Faults : public Vn100Bench, public testing::WithParamInterface<Breakdown>
{
protected:
  [[nodiscard]] bool is_well(Vn100 & imu) const
  {
    const Time now = clock_.now();
    return !imu.fault(now) && !imu.reading(now).fault;
  }
  [[nodiscard]] std::optional<Time> age(Vn100 & imu) const
  {
    const Time now = clock_.now();
    const GyroReading newest = imu.reading(now);
    return newest.fault ? std::nullopt : std::optional<Time>{now - newest.stamp};
  }
};

TEST_P(Vn100Faults, InTheMiddleTwiceInARow)
{
  const Breakdown & breakdown = GetParam();
  const Time limit = 3 * linux_io::vn100_period(config_) + std::chrono::milliseconds{5};
  Vn100Emulator emulator(options_, clock_);
  Vn100 imu(config_, clock_);
  ASSERT_TRUE(is_well(imu));
  const OpenResources before;
  for (int time = 1; time <= 2; ++time) {
    breakdown.begin(emulator);
    const auto believed = believed_for([&] { return age(imu); });
    ASSERT_TRUE(believed);
    EXPECT_LE(*believed, limit);
    std::string last;
    EXPECT_TRUE(eventually([&] {
      const auto fault = imu.fault(clock_.now());
      last = fault ? fault->detail : "no fault";
      return fault && fault->kind == breakdown.kind &&
             fault->detail.find(breakdown.words) != std::string::npos;
    }))
      << last;
    EXPECT_TRUE(imu.reading(clock_.now()).fault);
    breakdown.end(emulator);
    EXPECT_TRUE(eventually([&] { return is_well(imu); })) << "it comes back without a restart";
  }
  EXPECT_TRUE(OpenResources{} == before);
}

TEST_P(Vn100Faults, AtTheStartTwiceInARow)
{
  const Breakdown & breakdown = GetParam();
  config_.serial_number = "0100012345";
  Vn100Emulator emulator(options_, clock_);
  const OpenResources before;
  for (int time = 1; time <= 2; ++time) {
    breakdown.begin(emulator);
    try {
      const Vn100 imu(config_, clock_);
      ADD_FAILURE() << "it started";
    } catch (const HardwareError & error) {
      EXPECT_NE(std::string(error.what()).find("VN-100"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(breakdown.at_start), std::string::npos)
        << error.what();
    }
    breakdown.end(emulator);
    Vn100 imu(config_, clock_);
    EXPECT_TRUE(is_well(imu)) << "the next start is a good one";
  }
  EXPECT_TRUE(OpenResources{} == before);
}

INSTANTIATE_TEST_SUITE_P(
  Matrix, Vn100Faults, testing::ValuesIn(kBreakdowns),
  [](const testing::TestParamInfo<Breakdown> & tested) { return std::string(tested.param.name); });

TEST_F(Vn100Bench, AtAnotherBaudItIsGarbage)
{
  options_.baud = 57'600;
  Vn100Emulator emulator(options_, clock_);
  try {
    Vn100 imu(config_, clock_);
    ADD_FAILURE() << "it started";
  } catch (const HardwareError & error) {
    EXPECT_NE(std::string(error.what()).find("wrong baud"), std::string::npos) << error.what();
  }
}

// A few hurt frames among good ones are what a checksum is for: no fault, and they are counted.
TEST_F(Vn100Bench, AFrameLostNowAndThenIsNoFault)
{
  config_.silent_periods = 10;
  Vn100Emulator emulator(options_, clock_);
  const Vn100 imu(config_, clock_);
  emulator.set_trouble(Vn100Trouble{false, 1.0, 0.002, 0.0});  // one frame in ten
  ASSERT_TRUE(eventually([&] { return imu.statistics().bad_checksums >= 3; }));
  EXPECT_EQ(imu.statistics().counts.bad_answers, 0u);
  EXPECT_FALSE(imu.fault(clock_.now()));
}

TEST_F(Vn100Bench, EndsAtOnceWhileItWaitsForTheSensorToComeBack)
{
  Vn100Emulator emulator(options_, clock_);
  auto imu = std::make_unique<Vn100>(config_, clock_);
  emulator.unplug();
  ASSERT_TRUE(eventually([&] { return imu->statistics().counts.timeouts >= 5; })) << "backed off";
  const Time begin = clock_.now();
  imu.reset();
  EXPECT_LT(clock_.now() - begin, std::chrono::milliseconds{700}) << "it would have waited 0.8 s";
}

}  // namespace
}  // namespace stetro_driver
