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

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
#include "emulator/emulated_tof_bus.hpp"
#include "linux/tof/linux_tof_bus.hpp"
#include "linux/tof/tof_readdressing.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver
{
namespace
{

using linux_io::SharedSensor;
using linux_io::XshutLine;

/// Says what is done to a bus, and does it.
class NarratedBus : public linux_io::TofBus
{
public:
  explicit NarratedBus(std::unique_ptr<TofBus> bus) : bus_(std::move(bus)) {}

  void hold_low(const XshutLine & line) override
  {
    std::printf("shut down    %s low\n", to_string(line).c_str());
    bus_->hold_low(line);
  }
  void let_go(const XshutLine & line) override
  {
    std::printf("let go       %s\n", to_string(line).c_str());
    bus_->let_go(line);
  }
  void wait(Time duration) override
  {
    std::printf("wait         %.0f ms\n", 1e3 * time_to_seconds(duration));
    bus_->wait(duration);
  }
  std::optional<std::uint8_t> read_register(int address, std::uint8_t index) override
  {
    const auto value = bus_->read_register(address, index);
    std::printf("ask          0x%02x, register 0x%02x: ", address, index);
    if (value) {
      std::printf("0x%02x\n", *value);
    } else {
      std::printf("no answer\n");
    }
    return value;
  }
  void write_register(int address, std::uint8_t index, std::uint8_t value) override
  {
    std::printf("tell         0x%02x, register 0x%02x: 0x%02x\n", address, index, value);
    bus_->write_register(address, index, value);
  }
  void forget(int address) override
  {
    std::printf("forget       0x%02x, if the kernel has it\n", address);
    bus_->forget(address);
  }
  void bind(int address) override
  {
    std::printf("new device   vl53l0x 0x%02x\n", address);
    bus_->bind(address);
  }

private:
  std::unique_ptr<TofBus> bus_;
};

std::unique_ptr<linux_io::TofBus> emulated_bus(const std::vector<SharedSensor> & sensors)
{
  auto bus = std::make_unique<emulator::EmulatedTofBus>();
  for (const SharedSensor & sensor : sensors) {
    bus->add(sensor.xshut);
  }
  return bus;
}

int run(int argc, char ** argv)
{
  CLI::App app{
    "Gives the VL53L0X sensors of one I2C bus addresses of their own, and then to the kernel's "
    "driver.\nRun as root at every boot, before stetro_driver, and again when a sensor lost its "
    "power."};
  int bus_number = 1;
  std::vector<std::string> texts;
  std::string sysfs_root = "/sys";
  bool dry_run = false;
  app.add_option("--bus", bus_number, "N of i2c-N")->capture_default_str();
  app
    .add_option("--sensor", texts, "CHIP:LINE=ADDRESS of the sensor's XSHUT, as gpiochip0:17=0x30")
    ->required();
  app.add_option("--sysfs", sysfs_root, "where the kernel shows its devices")
    ->capture_default_str();
  app.add_flag("--dry-run", dry_run, "on emulated sensors: say what would be done, touch nothing");
  CLI11_PARSE(app, argc, argv);
  try {
    std::vector<SharedSensor> sensors;
    for (const std::string & text : texts) {
      sensors.push_back(linux_io::parse_shared_sensor(text));
    }
    NarratedBus bus{
      dry_run ? emulated_bus(sensors)
              : std::make_unique<linux_io::LinuxTofBus>(bus_number, sysfs_root)};
    give_addresses(sensors, bus);
  } catch (const HardwareError & error) {
    std::fflush(stdout);
    std::fprintf(stderr, "stetro_tof_addresses: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace stetro_driver

int main(int argc, char ** argv) { return stetro_driver::run(argc, argv); }
