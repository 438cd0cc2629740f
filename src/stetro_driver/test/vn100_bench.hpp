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

#ifndef VN100_BENCH_HPP_
#define VN100_BENCH_HPP_

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "device_bench.hpp"
#include "emulator/vn100_emulator.hpp"
#include "linux/imu/vn100.hpp"

namespace stetro_driver
{

/// An emulated VN-100, and the configuration that finds it.
class Vn100Bench : public testing::Test
{
protected:
  Vn100Bench()
  {
    config_.serial.path = options_.link;
    config_.rate_hz = 20;  // 150 ms are silence: more than a busy machine lets a thread wait
  }

  TempDirectory directory_;
  linux_io::DeviceClock clock_{std::chrono::seconds{1000}};
  emulator::Vn100EmulatorOptions options_{(directory_.path() / "imu").string()};
  linux_io::Vn100Config config_;
};

}  // namespace stetro_driver

#endif  // VN100_BENCH_HPP_
