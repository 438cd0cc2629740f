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
#include <string>

#include "device_bench.hpp"
#include "emulator/iio_tree.hpp"
#include "linux/tof/vl53l0x_channel.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::TofTrouble;

class Vl53l0xChannelTest : public ::testing::Test
{
protected:
  Vl53l0xChannelTest()
  {
    device_.i2c_name = "1-0030";
    device_.label = "left";
    device_.tof = std::make_shared<emulator::EmulatedTof>(clock_);
    device_.tof->see(300);
    tree_.plug(device_);
  }
  Vl53l0xChannel channel(const std::string & address = "label:left")
  {
    return {"side_left", *parse_tof_address(address), tree_.root().string(), tree_, clock_};
  }
  /// The fault of one measurement; none: it went well.
  static std::optional<IoFault> fault_of(Vl53l0xChannel & channel)
  {
    const auto measured = channel.measure();
    return measured ? std::nullopt : std::optional<IoFault>{measured.fault()};
  }

  DeviceClock clock_{std::chrono::seconds{1000}};
  TempDirectory directory_;
  emulator::IioTree tree_{directory_.path()};
  emulator::IioDevice device_;
};

TEST_F(Vl53l0xChannelTest, MeasuresAndStampsTheMiddle)
{
  auto left = channel();
  ASSERT_FALSE(left.open());
  const Time before = clock_.now();
  const auto measured = left.measure();
  const Time after = clock_.now();
  ASSERT_TRUE(measured.ok());
  EXPECT_EQ(measured.value().millimetres, 300);
  EXPECT_GE(measured.value().took(), std::chrono::milliseconds{32});
  EXPECT_GE(measured.value().stamp(), before + std::chrono::milliseconds{16});
  EXPECT_LE(measured.value().stamp(), after - std::chrono::milliseconds{16});
}

TEST_F(Vl53l0xChannelTest, NamesTheSensorAndWhatHappened)
{
  auto left = channel();
  ASSERT_FALSE(left.open());
  const std::pair<TofTrouble, const char *> troubles[] = {
    {TofTrouble::kSilent, "ETIMEDOUT"},
    {TofTrouble::kNoReply, "EREMOTEIO"},
    {TofTrouble::kBadBus, "EIO"}};
  for (const auto & [trouble, word] : troubles) {
    device_.tof->set_trouble(trouble);
    const auto fault = fault_of(left);
    ASSERT_TRUE(fault) << word;
    EXPECT_EQ(fault->kind, IoFaultKind::kSilent) << word;
    EXPECT_EQ(fault->detail.find("side_left: "), 0u) << fault->detail;
    EXPECT_NE(fault->detail.find(word), std::string::npos) << fault->detail;
    EXPECT_TRUE(left.is_open()) << "the driver is there still";
  }
  device_.tof->set_trouble(TofTrouble::kNone);
  EXPECT_FALSE(fault_of(left)) << "well again, without being opened again";
}

TEST_F(Vl53l0xChannelTest, NoGarbageIsADistance)
{
  auto left = channel();
  ASSERT_FALSE(left.open());
  device_.tof->set_trouble(TofTrouble::kGarbled);
  for (int i = 0; i < 7; ++i) {
    const auto fault = fault_of(left);
    ASSERT_TRUE(fault) << i;
    EXPECT_EQ(fault->kind, IoFaultKind::kBadAnswer) << fault->detail;
  }
}

TEST_F(Vl53l0xChannelTest, ClosesWhenTheKernelLosesItAndFindsItAgain)
{
  const OpenResources at_first;
  auto left = channel();
  ASSERT_FALSE(left.open());
  tree_.unplug("1-0030");
  const auto fault = fault_of(left);
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->detail.find("ENODEV"), std::string::npos) << fault->detail;
  EXPECT_FALSE(left.is_open());
  EXPECT_TRUE(OpenResources{} == at_first) << "the descriptor is closed";
  EXPECT_TRUE(left.open()) << "still gone";

  tree_.plug(device_);
  ASSERT_FALSE(left.open());
  EXPECT_FALSE(fault_of(left));
}

TEST_F(Vl53l0xChannelTest, RefusesAnotherDeviceInItsPlace)
{
  auto left = channel("i2c:1-0030");
  tree_.unplug("1-0030");
  auto other = device_;
  other.name = "bno055";
  tree_.plug(other);
  auto fault = left.open();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, IoFaultKind::kBadAnswer);
  EXPECT_NE(fault->detail.find("'bno055', accepted: 'vl53l0x'"), std::string::npos)
    << fault->detail;

  tree_.unplug("1-0030");
  other = device_;
  other.scale = "0.000100";
  tree_.plug(other);
  fault = left.open();
  ASSERT_TRUE(fault) << "another scale";
  EXPECT_EQ(fault->kind, IoFaultKind::kBadAnswer);
}

TEST(SysfsFiles, ReadsAnAttributeOfTheFileSystemFromItsStartEachTime)
{
  std::error_code error;
  const SysfsFiles files;
  EXPECT_EQ(files.open("/proc/self/no_such_file", error), nullptr);
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  const auto comm = files.open("/proc/self/comm", error);
  ASSERT_NE(comm, nullptr);
  char first[32] = {};
  char second[32] = {};
  const ssize_t size = comm->read(first, sizeof(first));
  EXPECT_GT(size, 1);
  EXPECT_EQ(comm->read(second, sizeof(second)), size);
  EXPECT_STREQ(first, second);
  EXPECT_FALSE(read_line(files, "/proc/self/no_such_file"));
}

}  // namespace
}  // namespace stetro_driver::linux_io
