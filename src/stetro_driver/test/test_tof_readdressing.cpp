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

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "emulator/emulated_tof_bus.hpp"
#include "linux/tof/tof_readdressing.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::EmulatedTofBus;

const std::vector<SharedSensor> kThree{
  {{"gpiochip0", 4}, 0x30}, {{"gpiochip0", 17}, 0x31}, {{"gpiochip0", 27}, 0x32}};

std::string refusal(const std::function<void()> & attempt)
{
  try {
    attempt();
  } catch (const HardwareError & error) {
    return error.what();
  }
  return "";
}

TEST(TofReaddressing, ReadsASensor)
{
  const SharedSensor sensor = parse_shared_sensor("pinctrl-bcm2711:17=0x3A");
  EXPECT_EQ(sensor.xshut.chip, "pinctrl-bcm2711");
  EXPECT_EQ(sensor.xshut.offset, 17u);
  EXPECT_EQ(sensor.address, 0x3A);
  for (const char * text :
       {"", "17=0x30", "gpiochip0:17", "gpiochip0:17=48", "gpiochip0:x=0x30", "gpiochip0:17=0x130",
        "gpiochip0:17=0x30 "}) {
    EXPECT_NE(refusal([&] { static_cast<void>(parse_shared_sensor(text)); }), "") << text;
  }
}

TEST(TofReaddressing, MovesEachSensorAndGivesItToTheKernelAndAgain)
{
  EmulatedTofBus bus;
  for (const SharedSensor & sensor : kThree) {
    bus.add(sensor.xshut);
  }
  for (int time = 0; time < 2; ++time) {
    give_addresses(kThree, bus);
    EXPECT_EQ(bus.addresses(), (std::vector<int>{0x30, 0x31, 0x32}));
    EXPECT_EQ(bus.bound(), (std::set<int>{0x30, 0x31, 0x32}));
  }
}

TEST(TofReaddressing, NamesTheSensorThatDoesNotAnswerOrIsAnother)
{
  EmulatedTofBus missing;
  missing.add(kThree[0].xshut);
  const std::string silent = refusal([&] { give_addresses(kThree, missing); });
  EXPECT_EQ(silent, "gpiochip0:17: no answer at 0x29, accepted: a VL53L0X");
  EXPECT_TRUE(missing.bound().empty());

  EmulatedTofBus other;
  other.add(kThree[0].xshut, 0xA0);
  const std::string wrong = refusal([&] { give_addresses({kThree[0]}, other); });
  EXPECT_NE(wrong.find("the model at 0x29 is 0xa0"), std::string::npos) << wrong;
}

TEST(TofReaddressing, NoticesASensorThatCannotBeShutDown)
{
  EmulatedTofBus bus;
  bus.add(kThree[0].xshut);
  bus.add(std::nullopt);
  const std::string text = refusal([&] { give_addresses({kThree[0]}, bus); });
  EXPECT_NE(text.find("answers at 0x29 although all sensors are shut down"), std::string::npos);
}

TEST(TofReaddressing, RefusesAddressesAndLinesThatCannotBe)
{
  EmulatedTofBus bus;
  const XshutLine line{"gpiochip0", 4};
  for (const int address : {0x00, 0x07, 0x29, 0x78}) {
    EXPECT_NE(refusal([&] { give_addresses({{line, address}}, bus); }), "") << address;
  }
  EXPECT_NE(refusal([&] { give_addresses({{line, 0x30}, {line, 0x31}}, bus); }), "");
  EXPECT_NE(refusal([&] { give_addresses({{line, 0x30}, {{"gpiochip0", 5}, 0x30}}, bus); }), "");
}

}  // namespace
}  // namespace stetro_driver::linux_io
