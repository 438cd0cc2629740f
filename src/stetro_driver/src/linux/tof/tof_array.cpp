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

#include "linux/tof/tof_array.hpp"

#include <map>
#include <optional>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

// Of the machine's time, for all together: three measurements that fail take 0.3 s.
constexpr Time kStartPatience = std::chrono::seconds{1};

[[noreturn]] void refuse(const std::string & faults)
{
  throw HardwareError("range sensors:" + faults);
}

std::string line(const std::string & text) { return "\n  " + text; }

}  // namespace

TofArray::TofArray(
  const TofArrayConfig & config, const TofLimits & limits, const AttributeSource & files,
  const DeviceClock & clock)
{
  TofTiming timing;
  timing.period = seconds_to_time(config.period_s);
  timing.longest = seconds_to_time(config.longest_s);
  std::string faults;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const std::string place{kRangeNames[i]};
    auto address = parse_tof_address(config.sensors[i]);
    if (!address) {
      faults += line(place + " is '" + config.sensors[i] + "', accepted: " + IsTofAddress::words());
    } else if (address->by != TofAddress::By::kNone) {
      readers_[i] = std::make_unique<TofReader>(
        place, Vl53l0xChannel{place, std::move(*address), config.sysfs_root, files, clock}, limits,
        timing, clock);
    }
  }
  if (!faults.empty()) {
    refuse(faults);
  }
}

void TofArray::start()
{
  stop();
  std::string faults = open_all();
  if (faults.empty()) {
    faults = sensors_given_twice();
  }
  if (faults.empty()) {
    for (const auto & reader : readers_) {
      if (reader) {
        reader->start();
      }
    }
    faults = await_all();
  }
  if (!faults.empty()) {
    stop();
    refuse(faults);
  }
}

std::string TofArray::open_all()
{
  std::string faults;
  for (const auto & reader : readers_) {
    if (const auto fault = reader ? reader->open() : std::nullopt) {
      faults += line(fault->detail);
    }
  }
  return faults;
}

std::string TofArray::sensors_given_twice() const
{
  std::string faults;
  std::map<std::string, std::string_view> places;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    if (readers_[i]) {
      const auto [first, fresh] = places.emplace(readers_[i]->directory(), kRangeNames[i]);
      if (!fresh) {
        faults += line(
          std::string(kRangeNames[i]) + ": is the same sensor as " + std::string(first->second) +
          ", " + first->first);
      }
    }
  }
  return faults;
}

std::string TofArray::await_all()
{
  std::string faults;
  const DeviceClock machine;
  for (const auto & reader : readers_) {
    if (!reader) {
      continue;
    }
    if (const auto fault = reader->wait_for_answer(kStartPatience - machine.now())) {
      faults += line(fault->detail);
    }
  }
  return faults;
}

void TofArray::stop() noexcept
{
  for (const auto & reader : readers_) {
    if (reader) {
      reader->request_stop();
    }
  }
  for (const auto & reader : readers_) {
    if (reader) {
      reader->stop();
    }
  }
}

TofLatest TofArray::latest(RangePlace place, Time now)
{
  TofReader * const sensor = reader(place);
  if (sensor) {
    return sensor->latest(now);
  }
  TofLatest none;
  none.fault.reset();
  return none;
}

}  // namespace stetro_driver::linux_io
