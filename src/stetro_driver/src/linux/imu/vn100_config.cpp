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

#include "linux/imu/vn100_config.hpp"

#include <algorithm>

#include "linux/imu/vn100_binary.hpp"
#include "linux/imu/vn100_codes.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::size_t kYmrBytes = 122;  // a line with its CR LF
constexpr double kFullestLine = 0.9;    // room for answers

bool is_binary(const Vn100Config & config) { return config.output == "binary"; }

}  // namespace

void check(const Vn100Config & config, stetro_config::Faults & faults)
{
  const std::int64_t rate_hz = config.rate_hz;
  if (is_binary(config) && kVn100ImuRate % rate_hz != 0) {
    faults.refuse("rate_hz", std::to_string(rate_hz), "with output binary: what divides 800");
  }
  if (
    !is_binary(config) && std::find(kVn100AsciiRates.begin(), kVn100AsciiRates.end(), rate_hz) ==
                            kVn100AsciiRates.end()) {
    faults.refuse(
      "rate_hz", std::to_string(rate_hz),
      "with output ascii: 1, 2, 4, 5, 10, 20, 25, 40, 50, 100, 200");
  }
  const double fullest = kFullestLine * static_cast<double>(config.serial.baud) / 10.0 /
                         static_cast<double>(vn100_frame_size(config));
  if (static_cast<double>(rate_hz) > fullest) {
    faults.refuse(
      "rate_hz", std::to_string(rate_hz),
      "at " + std::to_string(config.serial.baud) + " bit/s and output " + config.output +
        ": at most " + std::to_string(static_cast<int>(fullest)));
  }
}

Time vn100_period(const Vn100Config & config) { return Time{1'000'000'000 / config.rate_hz}; }

Time vn100_wire_time(const Vn100Config & config, std::size_t bytes)
{
  return Time{static_cast<Time::rep>(bytes) * 10'000'000'000 / config.serial.baud};
}

std::size_t vn100_frame_size(const Vn100Config & config)
{
  return is_binary(config) ? binary_size(kVn100Fields) : kYmrBytes;
}

}  // namespace stetro_driver::linux_io
