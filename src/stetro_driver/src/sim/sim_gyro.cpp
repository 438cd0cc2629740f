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

#include "sim/sim_gyro.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr std::string_view kName = "gyro";
constexpr double kFullScale = 4.36;  // 250 deg/s [rad/s]

}  // namespace

SimGyro::SimGyro(const SimErrors & errors, std::uint64_t seed)
: noise_rad_s_(errors.gyro_noise_std_rad_s), random_(seed, "gyro")
{
  for (double & bias_rad_s : bias_rad_s_) {
    bias_rad_s = random_.normal(errors.gyro_bias_std_rad_s);
  }
}

void SimGyro::measure(double yaw_rate_rad_s, Time now, const FaultInjector & faults)
{
  GyroReading reading;
  reading.stamp = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reading.rate_rad_s[axis] = bias_rad_s_[axis] + random_.normal(noise_rad_s_);
  }
  reading.rate_rad_s[2] += yaw_rate_rad_s;
  if (const SimFault * jump = faults.acting(SimFaultKind::kBiasJump, kName)) {
    reading.rate_rad_s[2] += jump->value;
  }
  reading.std_dev_rad_s = noise_rad_s_;
  if (faults.acting(SimFaultKind::kDead, kName)) {
    reading_.fault = true;  // and stays as old as it is
    return;
  }
  if (faults.acting(SimFaultKind::kStuck, kName)) {
    reading.rate_rad_s = reading_.rate_rad_s;
  }
  if (const SimFault * spike = faults.acting(SimFaultKind::kSpike, kName)) {
    if (random_.uniform() < spike->value) {
      reading.rate_rad_s[2] = random_.uniform(-kFullScale, kFullScale);
    }
  }
  reading_ = reading;
}

}  // namespace stetro_driver::sim
