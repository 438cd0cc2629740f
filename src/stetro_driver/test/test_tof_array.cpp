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

#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>

#include "linux/tof/tof_array.hpp"
#include "stetro_config/field.hpp"
#include "tof_bench.hpp"

namespace
{

thread_local std::uint64_t allocations = 0;  // of this thread

}  // namespace

// Not inlined: beside gtest's own `new` the compiler would see a mismatch that is none.
[[gnu::noinline]] void * operator new(std::size_t size)
{
  ++allocations;
  if (void * const memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc{};
}
[[gnu::noinline]] void operator delete(void * memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void * memory, std::size_t) noexcept { std::free(memory); }

namespace stetro_driver::linux_io
{
namespace
{

using emulator::TofTrouble;
using std::chrono::milliseconds;

constexpr RangePlace kLeft = RangePlace::kSideLeft;
constexpr RangePlace kRight = RangePlace::kSideRight;

class TofArrayTest : public ::testing::Test
{
protected:
  /// Why it does not start; empty: it did.
  static std::string refusal(TofArray & array)
  {
    try {
      array.start();
    } catch (const HardwareError & error) {
      return error.what();
    }
    return "";
  }
  TofLatest latest(TofArray & array, RangePlace place)
  {
    return array.latest(place, bench_.clock().now());
  }
  bool well(TofArray & array, RangePlace place)
  {
    return eventually([&] { return !latest(array, place).fault; });
  }
  /// Waits for measurements that began after this call.
  bool measured_anew(TofArray & array, RangePlace place)
  {
    const std::uint64_t number = latest(array, place).number;
    return eventually([&] { return latest(array, place).number >= number + 2; });
  }

  TofBench bench_;
};

TEST_F(TofArrayTest, ReadsAllSensorsEachAtItsPlace)
{
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    bench_.tof(static_cast<RangePlace>(i)).see(100 + static_cast<int>(i));
  }
  auto array = bench_.array();
  EXPECT_EQ(latest(array, kLeft).fault, IoFaultKind::kNotConfigured);
  array.start();
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto place = static_cast<RangePlace>(i);
    EXPECT_TRUE(array.fitted(place));
    EXPECT_TRUE(well(array, place)) << kRangeNames[i];
    const TofLatest newest = latest(array, place);
    EXPECT_EQ(newest.reading.status, RangeStatus::kValid) << kRangeNames[i];
    EXPECT_DOUBLE_EQ(newest.reading.range_m, 0.100 + 0.001 * static_cast<double>(i));
    EXPECT_GE(newest.reading.stamp, std::chrono::seconds{1000});
  }
}

TEST_F(TofArrayTest, SensorsDoNotWaitForEachOtherAndNoneIsReadTwiceAtOnce)
{
  bench_.tof(kLeft).set_trouble(TofTrouble::kSlow);
  bench_.config().longest_s = 0.5;
  auto array = bench_.array();
  array.start();
  const std::uint64_t slow = bench_.tof(kLeft).reads();
  const std::uint64_t fast = bench_.tof(kRight).reads();
  ASSERT_TRUE(eventually([&] { return bench_.tof(kLeft).reads() >= slow + 10; }));
  EXPECT_GE(bench_.tof(kRight).reads() - fast, 20u) << "27 by hand: 900 ms / 33 ms";
  array.stop();
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    EXPECT_EQ(bench_.tof(static_cast<RangePlace>(i)).overlaps(), 0u) << kRangeNames[i];
  }
}

TEST_F(TofArrayTest, CountsHowOftenAMillimetreRepeats)
{
  auto array = bench_.array();
  array.start();
  ASSERT_TRUE(eventually([&] { return latest(array, kLeft).repeats >= 5; }));
  const std::uint64_t before = latest(array, kLeft).number;
  bench_.tof(kLeft).see(301);
  ASSERT_TRUE(eventually([&] { return latest(array, kLeft).reading.range_m > 0.3005; }));
  const TofLatest newest = latest(array, kLeft);
  EXPECT_LE(newest.repeats, newest.number - before) << "counted anew";
  bench_.tof(kLeft).see(8190);
  ASSERT_TRUE(measured_anew(array, kLeft) && measured_anew(array, kLeft));
  EXPECT_LE(latest(array, kLeft).repeats, 1u) << "nothing within reach may last";
  EXPECT_GE(array.report(kLeft).statistics.longest_repeats, 5u);
}

TEST_F(TofArrayTest, KeepsStatisticsOfWhatItRead)
{
  auto array = bench_.array();
  array.start();
  const std::pair<int, std::uint64_t TofStatistics::*> seen[] = {
    {15, &TofStatistics::too_near},
    {1900, &TofStatistics::weak},
    {8191, &TofStatistics::no_target},
    {300, &TofStatistics::valid}};
  for (const auto & [millimetres, counter] : seen) {
    const std::uint64_t before = array.report(kLeft).statistics.*counter;
    bench_.tof(kLeft).see(millimetres);
    EXPECT_TRUE(
      eventually([&, count = counter] { return array.report(kLeft).statistics.*count > before; }))
      << millimetres;
  }
  const TofReport report = array.report(kLeft);
  EXPECT_EQ(report.health.device(), "side_left");
  EXPECT_EQ(report.health.counts().bad_answers, 0u);
  EXPECT_GE(report.statistics.longest, milliseconds{32});
}

TEST_F(TofArrayTest, TheControlLoopNeitherAllocatesNorWaits)
{
  auto array = bench_.array();
  array.start();
  bench_.tof(kRight).set_trouble(TofTrouble::kNoReply);
  ASSERT_TRUE(eventually([&] { return latest(array, kRight).fault.has_value(); }));
  const std::uint64_t before = allocations;
  for (int i = 0; i < 1000; ++i) {
    static_cast<void>(latest(array, kLeft));
    static_cast<void>(latest(array, kRight));
  }
  EXPECT_EQ(allocations, before);
}

TEST_F(TofArrayTest, ASensorThatIsNotFittedIsNoFault)
{
  bench_.config().sensors[0] = "none";
  bench_.tree().unplug("1-0030");
  auto array = bench_.array();
  array.start();
  EXPECT_FALSE(array.fitted(kLeft));
  EXPECT_EQ(latest(array, kLeft).fault, std::nullopt);
  EXPECT_EQ(latest(array, kLeft).reading.status, RangeStatus::kFault);
}

TEST_F(TofArrayTest, RefusesAddressesThatAreNoneAndSensorsGivenTwice)
{
  bench_.config().sensors[0] = "0x30";
  try {
    static_cast<void>(bench_.array());
    ADD_FAILURE() << "taken";
  } catch (const HardwareError & error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("side_left is '0x30', accepted: label:NAME"), std::string::npos) << text;
  }
  bench_.config().sensors[0] = "label:side_right";
  auto array = bench_.array();
  const std::string text = refusal(array);
  EXPECT_NE(text.find("side_right: is the same sensor as side_left"), std::string::npos) << text;
}

TEST_F(TofArrayTest, NamesEverySensorThatIsMissingAtTheStart)
{
  const OpenResources at_first;
  bench_.tree().unplug("1-0030");
  bench_.tree().unplug("1-0031");
  auto array = bench_.array();
  const std::string text = refusal(array);
  EXPECT_NE(text.find("side_left: 0 devices"), std::string::npos) << text;
  EXPECT_NE(text.find("side_right: 0 devices"), std::string::npos) << text;
  EXPECT_EQ(text.find("front_left"), std::string::npos) << text;
  EXPECT_TRUE(OpenResources{} == at_first);

  bench_.tree().plug(bench_.device(kLeft));
  bench_.tree().plug(bench_.device(kRight));
  EXPECT_EQ(refusal(array), "") << "starts when they are back";
}

TEST_F(TofArrayTest, StopsCleanlyWhileReadsBlockAndStartsAgain)
{
  const OpenResources at_first;
  auto array = bench_.array();
  for (int i = 0; i < 3; ++i) {
    array.start();
    bench_.tof(kLeft).set_trouble(TofTrouble::kSilent);
    const std::uint64_t reads = bench_.tof(kLeft).reads();
    ASSERT_TRUE(eventually([&] { return bench_.tof(kLeft).reads() > reads; }));
    array.stop();
    EXPECT_TRUE(OpenResources{} == at_first) << i;
    array.stop();
    bench_.tof(kLeft).set_trouble(TofTrouble::kNone);
  }
}

TEST(TofArrayConfig, ListsEverySensorByItsPlace)
{
  TofArrayConfig config;
  const auto fields = stetro_config::fields_of(config);
  ASSERT_EQ(fields.size(), 3 + kRangePlaces);
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    EXPECT_EQ(fields[3 + i].name, kRangeNames[i]);
    EXPECT_TRUE(fields[3 + i].assign(std::string{"label:x"}));
    EXPECT_FALSE(fields[3 + i].assign(std::string{"x"}));
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
