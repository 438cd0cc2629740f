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

#include "stetro_driver/sim_errors.hpp"

#include <stdexcept>
#include <string>

namespace stetro_driver
{

SimErrors no_errors()
{
  SimErrors errors;
  errors.riser_max_m = 0.0;
  errors.tread_max_m = 0.0;
  errors.width_max_m = 0.0;
  errors.riser_direction_max_rad = 0.0;
  errors.tof_offset_std_m = 0.0;
  errors.tof_offset_uncalibrated_std_m = 0.0;
  errors.tof_gain_std = 0.0;
  errors.tof_white_std_m = 0.0;
  errors.tof_white_std_per_m = 0.0;
  errors.tof_slow_std_m = 0.0;
  errors.tof_flicker_std_m = 0.0;
  errors.tof_spurious_share = 0.0;
  errors.odometry_scale_std = 0.0;
  errors.speed_variation_std = 0.0;
  errors.slip_rate_hz = 0.0;
  errors.heading_disturbance_rms_rad_s = 0.0;
  errors.gyro_bias_std_rad_s = 0.0;
  errors.gyro_noise_std_rad_s = 0.0;
  errors.bumper_max_m = 0.0;
  errors.switch_max_m = 0.0;
  errors.lift_height_max_m = 0.0;
  errors.lidar_std_m = 0.0;
  errors.lidar_dropout_share = 0.0;
  return errors;
}

void check(const SimErrors & errors, stetro_config::Faults & faults)
{
  if (errors.slip_min_m > errors.slip_max_m) {
    faults.refuse(
      "slip_min_m", std::to_string(errors.slip_min_m),
      "at most slip_max_m, which is " + std::to_string(errors.slip_max_m));
  }
}

double tof_offset_std_m(const SimErrors & errors)
{
  if (errors.calibration == "factory") {
    return errors.tof_offset_std_m;
  }
  if (errors.calibration == "none") {
    return errors.tof_offset_uncalibrated_std_m;
  }
  throw std::invalid_argument(
    "calibration is '" + errors.calibration + "', accepted: factory, none");
}

}  // namespace stetro_driver
