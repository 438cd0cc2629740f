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

#include "linux/device_status.hpp"

#include <cstdio>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kLimitTemperatureRaw = 0xDF;  // the factory's limit, near 85 degrees

std::string number(double value, const char * unit)
{
  char text[48];
  std::snprintf(text, sizeof(text), "%.3g %s", value, unit);
  return text;
}

void add_counts(DeviceStatus & status, const DeviceCounts & counts)
{
  status.figures.emplace_back("good", std::to_string(counts.good));
  status.figures.emplace_back("timeouts", std::to_string(counts.timeouts));
  status.figures.emplace_back("bad_answers", std::to_string(counts.bad_answers));
  status.figures.emplace_back("reopens", std::to_string(counts.reopens));
}

DeviceStatus begin(const std::string & name, const DeviceHealth & health)
{
  DeviceStatus status;
  status.name = name;
  if (health.faulty()) {
    status.fault = health.last_fault();
  }
  add_counts(status, health.counts());
  return status;
}

}  // namespace

IoFault words_of(const DeviceHealth & health, IoFaultKind kind)
{
  if (health.last_fault() && health.last_fault()->kind == kind) {
    return *health.last_fault();
  }
  return {kind, health.device() + ": does not answer in time"};
}

DeviceStatus status_of(const std::string & place, const TofReport & report)
{
  DeviceStatus status = begin(place, report.health);
  const TofStatistics & s = report.statistics;
  status.figures.emplace_back("valid", std::to_string(s.valid));
  status.figures.emplace_back("no_target", std::to_string(s.no_target));
  status.figures.emplace_back("slow", std::to_string(s.slow));
  status.figures.emplace_back("longest_measurement", number(time_to_seconds(s.longest), "s"));
  return status;
}

DeviceStatus status_of(const ContactReport & report)
{
  DeviceStatus status = begin("contacts", report.health);
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    const std::string name{kContactNames[i]};
    status.figures.emplace_back(name + ".presses", std::to_string(report.statistics[i].presses));
    switch (report.troubles[i]) {
      case ContactTrouble::kStuckClosed:
        status.figures.emplace_back(name, "closed since the start");
        break;
      case ContactTrouble::kChatters:
        status.figures.emplace_back(name, "chatters, a loose wire");
        break;
      default:
        break;
    }
  }
  return status;
}

DeviceStatus status_of(const Vn100 & imu, Time now)
{
  const Vn100Statistics statistics = imu.statistics();
  DeviceStatus status;
  status.name = "imu";
  status.fault = imu.fault(now);
  add_counts(status, statistics.counts);
  status.figures.emplace_back("bad_checksums", std::to_string(statistics.bad_checksums));
  status.figures.emplace_back("lost_bytes", std::to_string(statistics.lost_bytes));
  return status;
}

DeviceStatus status_of(const ServoDiagnostics & servo)
{
  DeviceStatus status;
  status.name = servo.name;
  if (servo.faulty) {
    status.fault = servo.last_fault;
  }
  add_counts(status, servo.counts);
  status.figures.emplace_back("voltage", number(servo.state.voltage_v, "V"));
  status.figures.emplace_back(
    "temperature",
    number(100.0 * servo.state.temperature_raw / kLimitTemperatureRaw, "% of its limit's reading"));
  status.figures.emplace_back("errors", std::to_string(servo.state.errors));
  return status;
}

}  // namespace stetro_driver::linux_io
