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

#include <filesystem>
#include <memory>

#include "device_bench.hpp"
#include "emulator/iio_tree.hpp"
#include "linux/tof/tof_address.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using By = TofAddress::By;

TEST(TofAddress, IsALabelAnI2cNameAPathOrNone)
{
  EXPECT_EQ(parse_tof_address("none")->by, By::kNone);
  EXPECT_EQ(parse_tof_address("label:side left")->key, "side left");
  EXPECT_EQ(parse_tof_address("i2c:1-0030")->by, By::kI2cName);
  EXPECT_EQ(parse_tof_address("i2c:11-003f")->key, "11-003f");
  EXPECT_EQ(parse_tof_address("path:/sys/x")->by, By::kPath);
}

TEST(TofAddress, AnythingElseIsNone)
{
  for (const char * text :
       {"", "None", "label:", "i2c:", "path:", "1-0030", "i2c:1-30", "i2c:1-003F", "i2c:-0030",
        "i2c:1-00300", "i2c:x-0030", "usb:1"}) {
    EXPECT_FALSE(parse_tof_address(text)) << text;
    EXPECT_FALSE(IsTofAddress{}.accepts(text)) << text;
  }
}

class FindIioDevice : public ::testing::Test
{
protected:
  void plug(const std::string & i2c_name, const std::string & label)
  {
    emulator::IioDevice device;
    device.i2c_name = i2c_name;
    device.label = label;
    device.tof = std::make_shared<emulator::EmulatedTof>(DeviceClock{});
    tree_.plug(device);
  }
  Result<std::string> find(const std::string & address)
  {
    return find_iio_device(tree_, tree_.root().string(), parse_tof_address(address).value());
  }
  /// As the kernel names it: the end of the real path.
  static std::string end_of(const Result<std::string> & found)
  {
    const std::filesystem::path path{found.value()};
    return (path.parent_path().filename() / path.filename()).string();
  }

  TempDirectory directory_;
  emulator::IioTree tree_{directory_.path()};
};

TEST_F(FindIioDevice, FindsEachByLabelByI2cNameAndByPath)
{
  plug("1-0030", "side_left");
  plug("1-0031", "side_right");
  plug("11-0030", "");
  EXPECT_EQ(end_of(find("label:side_right")), "1-0031/iio:device1");
  EXPECT_EQ(end_of(find("i2c:1-0030")), "1-0030/iio:device0");
  EXPECT_EQ(end_of(find("i2c:11-0030")), "11-0030/iio:device2");
  const std::string link = (tree_.root() / "bus/iio/devices/iio:device1").string();
  EXPECT_EQ(end_of(find("path:" + link)), "1-0031/iio:device1") << "links are followed";
}

TEST_F(FindIioDevice, KeepsASensorsNameWhenItsNumberChanges)
{
  plug("1-0030", "");
  plug("1-0031", "");
  tree_.unplug("1-0030");
  tree_.unplug("1-0031");
  plug("1-0031", "");
  EXPECT_EQ(end_of(find("i2c:1-0031")), "1-0031/iio:device0");
}

TEST_F(FindIioDevice, SaysWhatIsMissingOrThereTwice)
{
  plug("1-0030", "left");
  plug("1-0031", "left");
  for (const char * address : {"label:right", "i2c:1-0032", "path:/nowhere"}) {
    const auto found = find(address);
    ASSERT_FALSE(found.ok()) << address;
    EXPECT_EQ(found.fault().kind, IoFaultKind::kSilent) << address;
  }
  const auto twice = find("label:left");
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.fault().kind, IoFaultKind::kBadAnswer);
  EXPECT_NE(twice.fault().detail.find("2 devices"), std::string::npos) << twice.fault().detail;
}

TEST_F(FindIioDevice, ATreeWithoutAnyDeviceIsNoCrash)
{
  EXPECT_FALSE(find("i2c:1-0030").ok());
  EXPECT_FALSE(find_iio_device(tree_, "/nowhere", {By::kI2cName, "1-0030"}).ok());
}

}  // namespace
}  // namespace stetro_driver::linux_io
