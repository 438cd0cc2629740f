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

#ifndef SIM__SIM_GYRO_HPP_
#define SIM__SIM_GYRO_HPP_

#include <array>

#include "sim/fault_injector.hpp"
#include "sim/random_stream.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// A gyroscope with a bias that is drawn once, and white noise.
class SimGyro
{
public:
  SimGyro(const SimErrors & errors, std::uint64_t seed);

  /// \param yaw_rate_rad_s true rate of turn about +z, mean over the last sample
  void measure(double yaw_rate_rad_s, Time now, const FaultInjector & faults);

  /// The last measurement.
  [[nodiscard]] const GyroReading & reading() const { return reading_; }

  [[nodiscard]] double bias_rad_s() const { return bias_rad_s_[2]; }

  template <class Archive>
  void archive(Archive & each)
  {
    random_.archive(each);
    each(reading_.stamp, reading_.rate_rad_s, reading_.std_dev_rad_s, reading_.fault);
  }

private:
  double noise_rad_s_;
  RandomStream random_;
  std::array<double, 3> bias_rad_s_{};
  GyroReading reading_{};
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_GYRO_HPP_
