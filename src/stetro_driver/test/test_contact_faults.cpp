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

// Every way the GPIO lines fail, at the start and in the middle, twice in a row: the fault has its
// type within three polls, the emergency stop latches, and they recover without a restart.

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "contact_bench.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr ContactPlace kBumper = ContactPlace::kRightRear;
constexpr const char * kChip = "gpiochip0";

struct Failure
{
  std::string name;
  std::function<void(ContactBench &)> begin;
  std::function<void(ContactBench &)> end;
  IoFaultKind kind;
  std::string words;
};

std::ostream & operator<<(std::ostream & out, const Failure & failure)
{
  return out << failure.name;
}

Failure unplugged()
{
  return {
    "Unplugged", [](ContactBench & bench) { bench.lines().set_plugged(kChip, false); },
    [](ContactBench & bench) { bench.lines().set_plugged(kChip, true); }, IoFaultKind::kSilent,
    "ENOENT"};
}

Failure replaced()
{
  return {
    "ReplacedByASmallerChip", [](ContactBench & bench) { bench.lines().replace(kChip, 8); },
    [](ContactBench & bench) { bench.lines().replace(kChip, 54); }, IoFaultKind::kBadAnswer,
    "there are 8"};
}

Failure replugged_and_taken()
{
  return {
    "TakenByAnother",
    [](ContactBench & bench) {
      bench.lines().set_taken(bench.line(kBumper), true);
      bench.lines().set_plugged(kChip, false);
      bench.lines().set_plugged(kChip, true);
    },
    [](ContactBench & bench) { bench.lines().set_taken(bench.line(kBumper), false); },
    IoFaultKind::kSilent, "EBUSY"};
}

class ContactLinesOnABench : public ::testing::Test
{
protected:
  ContactLatest latest() { return contacts_.latest(bench_.clock().now()); }
  bool bumper_closed()
  {
    const auto now = latest().contacts[static_cast<std::size_t>(kBumper)];
    return now.closed && !now.fault;
  }
  std::optional<Time> age()
  {
    const Time now = bench_.clock().now();
    const ContactLatest newest = contacts_.latest(now);
    return newest.fault ? std::nullopt : std::optional<Time>{now - newest.read};
  }

  ContactBench bench_;
  ContactLines contacts_{bench_.config(), bench_.lines(), bench_.clock()};
};

class ContactFaults : public ContactLinesOnABench, public ::testing::WithParamInterface<Failure>
{
protected:
  bool has_its_fault() const
  {
    const auto fault = contacts_.report().health.last_fault();
    return fault && fault->kind == GetParam().kind && fault->detail.find("contacts: ") == 0 &&
           fault->detail.find(GetParam().words) != std::string::npos;
  }
  void expect_recovered()
  {
    EXPECT_TRUE(eventually([&] { return !latest().fault; }));
    EXPECT_TRUE(latest().emergency_stop_latched) << "only a person ends that";
    EXPECT_TRUE(eventually([&] { return !contacts_.reset_emergency_stop(); }));
    EXPECT_FALSE(latest().emergency_stop_latched);
    bench_.press(kBumper, true);
    EXPECT_TRUE(eventually([&] { return bumper_closed(); }));
    bench_.press(kBumper, false);
    EXPECT_TRUE(eventually([&] { return !bumper_closed(); }));
  }
};

TEST_P(ContactFaults, InTheMiddleTwiceInARow)
{
  contacts_.start();
  const OpenResources running;
  for (int time = 0; time < 2; ++time) {
    GetParam().begin(bench_);
    const auto believed = believed_for([this] { return age(); });
    ASSERT_TRUE(believed);
    EXPECT_LE(*believed, std::chrono::milliseconds{150});  // three polls of 50 ms
    for (const ContactReading & contact : latest().contacts) {
      EXPECT_TRUE(contact.fault);
    }
    EXPECT_TRUE(latest().emergency_stop_latched);
    EXPECT_TRUE(contacts_.reset_emergency_stop()) << "nobody can see the button";
    EXPECT_TRUE(eventually([&] { return has_its_fault(); }));
    GetParam().end(bench_);
    expect_recovered();
    EXPECT_TRUE(OpenResources{} == running) << "nothing leaks";
  }
}

TEST_P(ContactFaults, AtTheStartTwiceInARow)
{
  const OpenResources before;
  GetParam().begin(bench_);
  for (int time = 0; time < 2; ++time) {
    try {
      contacts_.start();
      ADD_FAILURE() << "started";
    } catch (const HardwareError & error) {
      const std::string text = error.what();
      EXPECT_NE(text.find(GetParam().words), std::string::npos) << text;
    }
    EXPECT_TRUE(OpenResources{} == before) << "nothing leaks";
  }
  GetParam().end(bench_);
  EXPECT_NO_THROW(contacts_.start());
  EXPECT_EQ(latest().fault, std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(
  Every, ContactFaults, ::testing::Values(unplugged(), replaced(), replugged_and_taken()),
  [](const ::testing::TestParamInfo<Failure> & failure) { return failure.param.name; });

TEST_F(ContactLinesOnABench, AKernelThatDoesNotAnswerIsSilenceForWhoAsks)
{
  contacts_.start();
  for (int time = 0; time < 2; ++time) {
    bench_.lines().set_hanging(true);
    const auto believed = believed_for([this] { return age(); });
    EXPECT_TRUE(believed);
    EXPECT_EQ(latest().fault, IoFaultKind::kSilent);
    bench_.lines().set_hanging(false);
    EXPECT_TRUE(eventually([&] { return !latest().fault; }));
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
