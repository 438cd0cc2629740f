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

#ifndef TOF_BENCH_HPP_
#define TOF_BENCH_HPP_

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "device_bench.hpp"
#include "emulator/iio_tree.hpp"
#include "linux/tof/tof_array.hpp"

namespace stetro_driver
{

/// The robot's eight range sensors, emulated: at 1-0030 to 1-0037, each seeing 300 mm.
class TofBench
{
public:
  TofBench()
  {
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      devices_[i].i2c_name = "1-003" + std::to_string(i);
      devices_[i].label = kRangeNames[i];
      devices_[i].tof = std::make_shared<emulator::EmulatedTof>(clock_);
      devices_[i].tof->see(300);
      tree_.plug(devices_[i]);
    }
    config_.sysfs_root = tree_.root().string();
    // Silent and late after 0.3 s: these tests share their machine.
    config_.period_s = 0.1;
    config_.longest_s = 0.3;
  }

  [[nodiscard]] linux_io::TofArray array() const
  {
    return linux_io::TofArray{config_, linux_io::TofLimits{}, tree_, clock_};
  }
  [[nodiscard]] linux_io::TofArrayConfig & config() { return config_; }
  [[nodiscard]] emulator::IioTree & tree() { return tree_; }
  [[nodiscard]] emulator::IioDevice & device(RangePlace place)
  {
    return devices_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] emulator::EmulatedTof & tof(RangePlace place) { return *device(place).tof; }
  [[nodiscard]] const linux_io::DeviceClock & clock() const { return clock_; }

private:
  linux_io::DeviceClock clock_{std::chrono::seconds{1000}};
  TempDirectory directory_{};
  emulator::IioTree tree_{directory_.path()};
  std::array<emulator::IioDevice, kRangePlaces> devices_{};
  linux_io::TofArrayConfig config_{};
};

}  // namespace stetro_driver

#endif  // TOF_BENCH_HPP_
