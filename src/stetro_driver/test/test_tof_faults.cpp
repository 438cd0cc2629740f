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

// Every way a range sensor fails, at the start and in the middle, twice in a row: the fault has its
// type within three sample periods, the others go on, and it recovers without a restart.

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tof_bench.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::TofTrouble;

constexpr RangePlace kSick = RangePlace::kFrontLeft;
constexpr RangePlace kWell = RangePlace::kFrontRight;
constexpr Time kThreePeriods = std::chrono::milliseconds{105};

/// One way to fail, and what comes of it.
struct Failure
{
  std::string name;
  std::function<void(TofBench &)> begin;
  std::function<void(TofBench &)> end;
  IoFaultKind kind;
  std::string words;  ///< that its fault must have
  RangeStatus status = RangeStatus::kFault;
};

std::ostream & operator<<(std::ostream & out, const Failure & failure)
{
  return out << failure.name;
}

Failure trouble(
  const std::string & name, TofTrouble what, IoFaultKind kind, const std::string & words,
  RangeStatus status = RangeStatus::kFault)
{
  return {
    name,
    [what](TofBench & bench) { bench.tof(kSick).set_trouble(what); },
    [](TofBench & bench) { bench.tof(kSick).set_trouble(TofTrouble::kNone); },
    kind,
    words,
    status};
}

void unplug(TofBench & bench) { bench.tree().unplug(bench.device(kSick).i2c_name); }
void plug(TofBench & bench) { bench.tree().plug(bench.device(kSick)); }

Failure replaced(
  const std::string & name, const std::function<void(emulator::IioDevice &)> & by, IoFaultKind kind,
  const std::string & words)
{
  return {
    name,
    [by](TofBench & bench) {
      unplug(bench);
      emulator::IioDevice other = bench.device(kSick);
      other.tof = std::make_shared<emulator::EmulatedTof>(bench.clock());
      by(other);
      bench.tree().plug(other);
    },
    [](TofBench & bench) {
      unplug(bench);
      plug(bench);
    },
    kind, words};
}

const std::vector<Failure> & failures()
{
  constexpr auto kSilent = IoFaultKind::kSilent;
  constexpr auto kBad = IoFaultKind::kBadAnswer;
  static const std::vector<Failure> all{
    trouble("WiresOff", TofTrouble::kNoReply, kSilent, "EREMOTEIO"),
    trouble("BadBus", TofTrouble::kBadBus, kSilent, "EIO"),
    trouble("Silent", TofTrouble::kSilent, kSilent, "ETIMEDOUT"),
    trouble("Slow", TofTrouble::kSlow, kSilent, "accepted: at most 70 ms", RangeStatus::kStale),
    trouble("Garbled", TofTrouble::kGarbled, kBad, "accepted: 0 to 8191"),
    {"Unplugged", unplug, plug, kSilent, "0 devices"},
    replaced(
      "AnotherKind", [](emulator::IioDevice & d) { d.name = "bno055"; }, kBad, "'bno055'"),
    replaced(
      "AnotherLabel", [](emulator::IioDevice & d) { d.label = "somebody"; }, kSilent, "0 devices"),
  };
  return all;
}

class TofFaults : public ::testing::TestWithParam<Failure>
{
protected:
  TofFaults()
  {
    bench_.config().period_s = 0.035;
    bench_.config().longest_s = 0.070;
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      bench_.config().sensors[i] = "label:" + std::string(kRangeNames[i]);
    }
  }
  TofLatest latest(RangePlace place) { return array_->latest(place, bench_.clock().now()); }

  std::optional<Time> age_of_the_sick()
  {
    const Time now = bench_.clock().now();
    const TofLatest newest = array_->latest(kSick, now);
    return newest.fault ? std::nullopt : std::optional<Time>{now - newest.answered};
  }
  bool well()
  {
    return eventually([&] {
      const TofLatest newest = latest(kSick);
      return !newest.fault && newest.reading.status == RangeStatus::kValid &&
             !array_->report(kSick).health.faulty();
    });
  }
  void expect_its_fault()
  {
    EXPECT_TRUE(eventually([&] {
      const TofLatest newest = latest(kSick);
      const auto fault = array_->report(kSick).health.last_fault();
      return newest.fault == GetParam().kind && newest.reading.status == GetParam().status &&
             fault && fault->kind == GetParam().kind && fault->detail.find("front_left: ") == 0 &&
             fault->detail.find(GetParam().words) != std::string::npos;
    }))
      << array_->report(kSick).health.last_fault()->detail;
  }

  TofBench bench_;
  std::optional<TofArray> array_;
};

TEST_P(TofFaults, InTheMiddleTwiceInARow)
{
  array_.emplace(
    bench_.config(), TofLimits{}, static_cast<const AttributeSource &>(bench_.tree()),
    bench_.clock());
  array_->start();
  const OpenResources running;
  for (int time = 0; time < 2; ++time) {
    GetParam().begin(bench_);
    const auto believed = believed_for([this] { return age_of_the_sick(); });
    ASSERT_TRUE(believed);
    EXPECT_LE(*believed, kThreePeriods);
    expect_its_fault();
    const std::uint64_t others = latest(kWell).number;
    EXPECT_TRUE(eventually([&] { return latest(kWell).number > others + 2; })) << "others go on";
    GetParam().end(bench_);
    EXPECT_TRUE(well()) << "recovers, time " << time;
    EXPECT_TRUE(OpenResources{} == running) << "nothing leaks";
  }
}

TEST_P(TofFaults, AtTheStartTwiceInARow)
{
  const OpenResources before;
  array_.emplace(
    bench_.config(), TofLimits{}, static_cast<const AttributeSource &>(bench_.tree()),
    bench_.clock());
  GetParam().begin(bench_);
  for (int time = 0; time < 2; ++time) {
    try {
      array_->start();
      ADD_FAILURE() << "started";
    } catch (const HardwareError & error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("front_left: "), std::string::npos) << text;
      EXPECT_NE(text.find(GetParam().words), std::string::npos) << text;
      EXPECT_EQ(text.find("front_right"), std::string::npos) << text;
    }
    EXPECT_TRUE(OpenResources{} == before) << "nothing leaks";
  }
  GetParam().end(bench_);
  EXPECT_NO_THROW(array_->start());
  EXPECT_TRUE(well());
}

INSTANTIATE_TEST_SUITE_P(
  Every, TofFaults, ::testing::ValuesIn(failures()),
  [](const ::testing::TestParamInfo<Failure> & failure) { return failure.param.name; });

}  // namespace
}  // namespace stetro_driver::linux_io
