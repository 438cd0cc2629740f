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

#include "linux/devices_file.hpp"

#include <string>

#include "stetro_config/loader.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr char kSection[] = "devices";

/// The section as it stands in its file: faults then name `devices.imu.path`.
struct Section
{
  Devices devices{};
};

template <class Visitor>
void visit(Section & p, Visitor && each)
{
  visit(p.devices, stetro_config::Group{kSection, each});
}

/// Adds what the check of a part finds, under the name of the part.
template <class Part>
void check_part(const std::string & name, const Part & part, stetro_config::Faults & faults)
{
  stetro_config::Faults found;
  check(part, found);
  for (const stetro_config::Fault & fault : found) {
    faults.refuse(name + "." + fault.name, fault.value, fault.accepted);
  }
}

void check(const Section & section, stetro_config::Faults & faults)
{
  check_part(kSection, section.devices, faults);
}

}  // namespace

void check(const Devices & devices, stetro_config::Faults & faults)
{
  check_part("chassis", devices.chassis, faults);
  check_part("imu", devices.imu, faults);
  if (devices.imu.serial.path == devices.chassis.bus.port.path) {
    faults.refuse("imu.path", devices.imu.serial.path, "a port of its own, not that of the servos");
  }
}

std::optional<Devices> read_devices(
  const stetro_site::Robot & robot, stetro_config::Faults & faults)
{
  if (!robot.devices.IsDefined() || robot.devices.IsNull()) {
    faults.add(
      {robot.file, 0, kSection, stetro_config::kMissing,
       "the devices of this robot, as the shipped robot file lists them"});
    return std::nullopt;
  }
  YAML::Node file;
  file[kSection] = robot.devices;
  stetro_config::Loader<Section> loader;
  loader.read_map(file, robot.file);
  loader.require_every_name(robot.file);
  const auto before = faults.size();
  Section section = loader.finish(faults);
  return faults.size() == before ? std::optional{section.devices} : std::nullopt;
}

}  // namespace stetro_driver::linux_io
