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

#ifndef STETRO_DRIVER__SIM_ERRORS_HPP_
#define STETRO_DRIVER__SIM_ERRORS_HPP_

#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_config/rule.hpp"

namespace stetro_driver
{

/// Every error of the simulated robot and of the world it climbs, with their default sizes.
/**
 * Values named `_std` are one standard deviation, `_max` the bound on either side. Zero switches an
 * error off.
 */
struct SimErrors
{
  // The world as built, apart from the site file; the bound is two standard deviations.
  double riser_max_m = 0.003;
  double tread_max_m = 0.005;
  double width_max_m = 0.005;                     ///< at either end of the flight
  double riser_direction_max_rad = 0.0034906585;  ///< 0.2 deg

  // Range sensors: VL53L0X, DS11555 and its characterisation.
  std::string calibration = "factory";  ///< factory: offset_std; none: offset_uncalibrated_std
  double tof_offset_std_m = 0.003;
  double tof_offset_uncalibrated_std_m = 0.010;
  double tof_gain_std = 0.03;
  double tof_gain_max = 0.05;
  double tof_white_std_m = 0.0021;
  double tof_white_std_per_m = 0.015;
  double tof_slow_std_m = 0.0009;  ///< drift over minutes, as the housing warms
  double tof_slow_time_constant_s = 600.0;
  double tof_flicker_std_m = 0.0003;  ///< wandering within seconds; a recorded VL53L0X has it
  double tof_flicker_time_constant_s = 6.0;
  double tof_limit_m = 1.2;  ///< 94 % of readings are valid here
  double tof_minimum_m = 0.03;
  double tof_half_cone_rad = 0.2181661565;  ///< 12.5 deg
  double tof_spurious_share = 0.15;         ///< of the readings that found nothing

  // Wheels.
  double odometry_scale_std = 0.02;
  double speed_variation_std = 0.03;
  double speed_variation_time_constant_s = 5.0;
  double slip_rate_hz = 0.05;  ///< slips per second of motion
  double slip_min_m = 0.005;
  double slip_max_m = 0.020;
  double heading_disturbance_rms_rad_s = 0.0087266463;  ///< 0.5 deg/s, while moving
  double heading_disturbance_time_constant_s = 5.0;
  double squaring = 0.5;  ///< share of a push against a wall that turns the body flush with it

  // Gyro.
  double gyro_bias_std_rad_s = 0.0052359878;   ///< 0.3 deg/s
  double gyro_noise_std_rad_s = 0.0017453293;  ///< 0.1 deg/s at 100 Hz

  // Contacts and lifts.
  double bumper_max_m = 0.001;
  double switch_max_m = 0.0005;
  double lift_height_max_m = 0.002;

  // Lidar.
  double lidar_std_m = 0.01;
  double lidar_dropout_share = 0.03;
};

/// The list of SimErrors, see stetro_config/field.hpp.
template <class Visitor>
void visit(SimErrors & p, Visitor && each)
{
  using stetro_config::OneOf;
  using stetro_config::Within;
  each("riser_max_m", p.riser_max_m, Within{0.0, 0.01}, "risers as built, bound, 2 sigma [m]");
  each("tread_max_m", p.tread_max_m, Within{0.0, 0.02}, "treads as built, bound, 2 sigma [m]");
  each("width_max_m", p.width_max_m, Within{0.0, 0.02}, "width at either end, bound [m]");
  each(
    "riser_direction_max_rad", p.riser_direction_max_rad, Within{0.0, 0.0175},
    "direction of a riser, bound, 2 sigma [rad]");
  each(
    "calibration", p.calibration, OneOf{"factory", "none"},
    "range sensors leave the factory calibrated, or not");
  each("tof_offset_std_m", p.tof_offset_std_m, Within{0.0, 0.03}, "offset, calibrated [m]");
  each(
    "tof_offset_uncalibrated_std_m", p.tof_offset_uncalibrated_std_m, Within{0.0, 0.03},
    "offset, not calibrated [m]");
  each("tof_gain_std", p.tof_gain_std, Within{0.0, 0.1}, "gain error [m/m]");
  each("tof_gain_max", p.tof_gain_max, Within{0.0, 0.2}, "bound of the gain error [m/m]");
  each("tof_white_std_m", p.tof_white_std_m, Within{0.0, 0.02}, "white noise at no distance [m]");
  each(
    "tof_white_std_per_m", p.tof_white_std_per_m, Within{0.0, 0.1},
    "white noise per distance, added in squares [m/m]");
  each("tof_slow_std_m", p.tof_slow_std_m, Within{0.0, 0.01}, "slow drift [m]");
  each(
    "tof_slow_time_constant_s", p.tof_slow_time_constant_s, Within{1.0, 3600.0},
    "time constant of the slow drift [s]");
  each("tof_flicker_std_m", p.tof_flicker_std_m, Within{0.0, 0.01}, "wandering within seconds [m]");
  each(
    "tof_flicker_time_constant_s", p.tof_flicker_time_constant_s, Within{0.1, 60.0},
    "time constant of that wandering [s]");
  each("tof_limit_m", p.tof_limit_m, Within{0.3, 2.0}, "94 % of readings are valid here [m]");
  each("tof_minimum_m", p.tof_minimum_m, Within{0.0, 0.1}, "nothing nearer can be measured [m]");
  each(
    "tof_half_cone_rad", p.tof_half_cone_rad, Within{0.001, 0.5}, "half the field of view [rad]");
  each(
    "tof_spurious_share", p.tof_spurious_share, Within{0.0, 1.0},
    "of the readings without a target, those that give a number [1]");
  each("odometry_scale_std", p.odometry_scale_std, Within{0.0, 0.2}, "scale of odometry [m/m]");
  each("speed_variation_std", p.speed_variation_std, Within{0.0, 0.2}, "speed against told [1]");
  each(
    "speed_variation_time_constant_s", p.speed_variation_time_constant_s, Within{0.1, 600.0},
    "time constant of the speed's variation [s]");
  each("slip_rate_hz", p.slip_rate_hz, Within{0.0, 10.0}, "slips in a second of motion [Hz]");
  each("slip_min_m", p.slip_min_m, Within{0.0, 0.1}, "shortest slip [m]");
  each("slip_max_m", p.slip_max_m, Within{0.0, 0.1}, "longest slip [m]");
  each(
    "heading_disturbance_rms_rad_s", p.heading_disturbance_rms_rad_s, Within{0.0, 0.1},
    "turning that nobody asked for, while moving [rad/s]");
  each(
    "heading_disturbance_time_constant_s", p.heading_disturbance_time_constant_s,
    Within{0.1, 600.0}, "time constant of that turning [s]");
  each("squaring", p.squaring, Within{0.0, 1.0}, "share of a push that turns the body flush [1]");
  each("gyro_bias_std_rad_s", p.gyro_bias_std_rad_s, Within{0.0, 0.1}, "gyro bias [rad/s]");
  each("gyro_noise_std_rad_s", p.gyro_noise_std_rad_s, Within{0.0, 0.1}, "gyro noise [rad/s]");
  each("bumper_max_m", p.bumper_max_m, Within{0.0, 0.002}, "where a bumper closes, bound [m]");
  each("switch_max_m", p.switch_max_m, Within{0.0, 0.001}, "where a switch closes, bound [m]");
  each("lift_height_max_m", p.lift_height_max_m, Within{0.0, 0.01}, "heights of lifts, bound [m]");
  each("lidar_std_m", p.lidar_std_m, Within{0.0, 0.2}, "noise of the lidar's ranges [m]");
  each(
    "lidar_dropout_share", p.lidar_dropout_share, Within{0.0, 1.0},
    "of the lidar's beams that are lost [1]");
}

/// Numbers that contradict each other.
void check(const SimErrors & errors, stetro_config::Faults & faults);

/// The same robot and world without any error: what the site file says, seen perfectly.
/** The cone of the range sensors, and their limits, are not errors and stay. */
[[nodiscard]] SimErrors no_errors();

/// Standard deviation of the range sensors' offsets that `calibration` asks for.
/** \throws std::invalid_argument when it is neither "factory" nor "none" */
[[nodiscard]] double tof_offset_std_m(const SimErrors & errors);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SIM_ERRORS_HPP_
