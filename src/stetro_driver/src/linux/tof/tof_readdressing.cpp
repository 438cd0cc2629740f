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

#include "linux/tof/tof_readdressing.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <regex>
#include <set>
#include <utility>

#include "stetro_driver/result.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

constexpr int kFirstAddress = 0x29;  // of every sensor that boots
constexpr int kLowest = 0x08;        // below and above are addresses the bus keeps for itself
constexpr int kHighest = 0x77;
constexpr std::uint8_t kAddressRegister = 0x8A;
constexpr std::uint8_t kModelRegister = 0xC0;
constexpr std::uint8_t kModel = 0xEE;
constexpr Time kShutDown = milliseconds{10};
constexpr Time kBoot = milliseconds{2};  // at most 1.2 ms, DS11555 section 3.9

std::string hex(int number)
{
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "0x%02x", static_cast<unsigned int>(number));
  return text.data();
}

void check(const std::vector<SharedSensor> & sensors)
{
  std::set<int> addresses;
  std::set<std::string> lines;
  for (const SharedSensor & sensor : sensors) {
    const std::string line = to_string(sensor.xshut);
    const int address = sensor.address;
    if (address < kLowest || address > kHighest || address == kFirstAddress) {
      throw HardwareError(
        line + ": its address is " + hex(address) + ", accepted: 0x08 to 0x77 but 0x29");
    }
    if (!addresses.insert(address).second || !lines.insert(line).second) {
      throw HardwareError(
        line + "=" + hex(address) + " is given twice, accepted: a line and an address of its own");
    }
  }
}

void expect_model(TofBus & bus, const XshutLine & line, int address)
{
  const auto model = bus.read_register(address, kModelRegister);
  if (!model) {
    throw HardwareError(
      to_string(line) + ": no answer at " + hex(address) + ", accepted: a VL53L0X");
  }
  if (*model != kModel) {
    throw HardwareError(
      to_string(line) + ": the model at " + hex(address) + " is " + hex(*model) +
      ", accepted: 0xee, a VL53L0X");
  }
}

void move(TofBus & bus, const SharedSensor & sensor)
{
  bus.let_go(sensor.xshut);
  bus.wait(kBoot);
  expect_model(bus, sensor.xshut, kFirstAddress);
  bus.write_register(kFirstAddress, kAddressRegister, static_cast<std::uint8_t>(sensor.address));
  expect_model(bus, sensor.xshut, sensor.address);
}

}  // namespace

SharedSensor parse_shared_sensor(const std::string & text)
{
  static const std::regex kForm{"([^:=]+):([0-9]{1,3})=0x([0-9a-fA-F]{2})"};
  std::smatch part;
  if (!std::regex_match(text, part, kForm)) {
    throw HardwareError(
      "sensor is '" + text + "', accepted: CHIP:LINE=ADDRESS such as gpiochip0:17=0x30");
  }
  return {
    {part[1], static_cast<unsigned int>(std::stoul(part[2]))}, std::stoi(part[3], nullptr, 16)};
}

void give_addresses(const std::vector<SharedSensor> & sensors, TofBus & bus)
{
  check(sensors);
  for (const SharedSensor & sensor : sensors) {
    bus.forget(sensor.address);
  }
  for (const SharedSensor & sensor : sensors) {
    bus.hold_low(sensor.xshut);
  }
  bus.wait(kShutDown);
  if (bus.read_register(kFirstAddress, kModelRegister)) {
    throw HardwareError(
      "a device answers at 0x29 although all sensors are shut down, accepted: none; is a sensor's "
      "XSHUT not wired, or not named?");
  }
  for (const SharedSensor & sensor : sensors) {
    move(bus, sensor);
  }
  for (const SharedSensor & sensor : sensors) {
    bus.bind(sensor.address);
  }
}

}  // namespace stetro_driver::linux_io
