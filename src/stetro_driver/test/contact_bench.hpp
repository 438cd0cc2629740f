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

#ifndef CONTACT_BENCH_HPP_
#define CONTACT_BENCH_HPP_

#include <string>

#include "device_bench.hpp"
#include "emulator/emulated_lines.hpp"
#include "linux/lines/contact_lines.hpp"

namespace stetro_driver
{

/// The robot's switches on emulated lines, wired as the defaults say: nobody touches anything.
class ContactBench
{
public:
  ContactBench()
  {
    config_.poll_s = 0.05;  // silent after 0.15 s: these tests share their machine
    press(ContactPlace::kEmergencyStop, false);
  }

  [[nodiscard]] linux_io::ContactLinesConfig & config() { return config_; }
  [[nodiscard]] emulator::EmulatedLines & lines() { return lines_; }
  [[nodiscard]] const linux_io::DeviceClock & clock() const { return clock_; }

  [[nodiscard]] emulator::LineName line(ContactPlace place) const
  {
    const auto & wired = config_.lines[static_cast<std::size_t>(place)];
    return {wired.chip, static_cast<unsigned int>(wired.line)};
  }
  /// Bumpers and switches close to ground, the emergency stop opens from it.
  void press(ContactPlace place, bool pressed)
  {
    if (pressed == (place != ContactPlace::kEmergencyStop)) {
      lines_.drive(line(place), false);
    } else {
      lines_.release(line(place));
    }
  }

private:
  linux_io::DeviceClock clock_{std::chrono::seconds{1000}};
  linux_io::ContactLinesConfig config_{};
  emulator::EmulatedLines lines_{clock_};
};

}  // namespace stetro_driver

#endif  // CONTACT_BENCH_HPP_
