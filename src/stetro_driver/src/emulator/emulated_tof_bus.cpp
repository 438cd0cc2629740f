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

#include "emulator/emulated_tof_bus.hpp"

#include "stetro_driver/result.hpp"

namespace stetro_driver::emulator
{
namespace
{

constexpr int kFirstAddress = 0x29;
constexpr std::uint8_t kAddressRegister = 0x8A;
constexpr std::uint8_t kModelRegister = 0xC0;
constexpr Time kBoot = std::chrono::microseconds{1200};  // DS11555 section 3.9
constexpr Time kShutDown{-1};

}  // namespace

void EmulatedTofBus::add(const std::optional<linux_io::XshutLine> & xshut, std::uint8_t model)
{
  sensors_.push_back({xshut ? to_string(*xshut) : "", model, kFirstAddress, kBoot});
}

void EmulatedTofBus::hold_low(const linux_io::XshutLine & line)
{
  for (Sensor & sensor : sensors_) {
    if (sensor.xshut == to_string(line)) {
      sensor.address = kFirstAddress;
      sensor.awake_for = kShutDown;
    }
  }
}

void EmulatedTofBus::let_go(const linux_io::XshutLine & line)
{
  for (Sensor & sensor : sensors_) {
    if (sensor.xshut == to_string(line)) {
      sensor.awake_for = Time::zero();
    }
  }
}

void EmulatedTofBus::wait(Time duration)
{
  for (Sensor & sensor : sensors_) {
    sensor.awake_for += sensor.awake_for < Time::zero() ? Time::zero() : duration;
  }
}

std::vector<EmulatedTofBus::Sensor *> EmulatedTofBus::who_answers(int address)
{
  std::vector<Sensor *> found;
  for (Sensor & sensor : sensors_) {
    if (sensor.awake_for >= kBoot && sensor.address == address) {
      found.push_back(&sensor);
    }
  }
  return found;
}

std::optional<std::uint8_t> EmulatedTofBus::read_register(int address, std::uint8_t index)
{
  const auto sensors = who_answers(address);
  if (sensors.empty()) {
    return std::nullopt;
  }
  std::uint8_t value = 0xFF;
  for (const Sensor * sensor : sensors) {
    value &= index == kModelRegister ? sensor->model : std::uint8_t{0};
  }
  return value;
}

void EmulatedTofBus::write_register(int address, std::uint8_t index, std::uint8_t value)
{
  const auto sensors = who_answers(address);
  if (sensors.empty()) {
    throw HardwareError("nobody takes a register");
  }
  for (Sensor * sensor : sensors) {
    if (index == kAddressRegister) {
      sensor->address = value;
    }
  }
}

void EmulatedTofBus::forget(int address) { bound_.erase(address); }

void EmulatedTofBus::bind(int address)
{
  if (!bound_.insert(address).second || who_answers(address).size() != 1) {
    throw HardwareError("the kernel takes no sensor there");
  }
}

std::vector<int> EmulatedTofBus::addresses() const
{
  std::vector<int> all;
  for (const Sensor & sensor : sensors_) {
    if (sensor.awake_for >= kBoot) {
      all.push_back(sensor.address);
    }
  }
  return all;
}

}  // namespace stetro_driver::emulator
