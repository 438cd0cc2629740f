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

#ifndef LINUX__IMU__VN100_CONFIG_HPP_
#define LINUX__IMU__VN100_CONFIG_HPP_

#include <cstddef>
#include <cstdint>
#include <string>

#include "linux/serial_port.hpp"
#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// The robot's VN-100: where it is, which one it is, how it is screwed on, what it should send.
struct Vn100Config
{
  SerialPortConfig serial{};
  std::string model = "VN-100";  ///< its model number must begin so
  std::string serial_number;  ///< empty: whichever is there at the start, and from then on only it
  std::string output = "binary";
  std::int64_t rate_hz = 100;
  std::int64_t silent_periods = 3;
  double latency_s = 0.0;  ///< from a measurement to its first bit on the wire
  double mounting_roll_rad = 0.0;
  double mounting_pitch_rad = 0.0;
  double mounting_yaw_rad = 0.0;
  double rate_std_dev_rad_s = 5e-4;
  double acceleration_std_dev_m_s2 = 0.01;
  double tilt_std_dev_rad = 0.0175;  // 1 degree
  double yaw_std_dev_rad = 0.035;    // 2 degrees, as the papers quote of it (S-A, S-B)
};

template <class Visitor>
void visit(Vn100Config & p, Visitor && each)
{
  using stetro_config::Any;
  using stetro_config::OneOf;
  using stetro_config::Within;
  visit(p.serial, each);
  each("model", p.model, stetro_config::NonEmpty{}, "its model number must begin so");
  each(
    "serial_number", p.serial_number, Any{},
    "it must be this one; empty: whichever is there at the start");
  each("output", p.output, OneOf{"binary", "ascii"}, "what it is configured to send");
  each("rate_hz", p.rate_hz, Within{1, 200}, "measurements a second [Hz]");
  each(
    "silent_periods", p.silent_periods, Within{2, 100},
    "without a measurement for so many of its periods it is faulty");
  each("latency_s", p.latency_s, Within{0.0, 0.1}, "from measuring to sending [s]");
  const char * mounting = "of its axes in base_link, x as printed, y and z opposed [rad]";
  each("mounting_roll_rad", p.mounting_roll_rad, Within{-3.15, 3.15}, mounting);
  each("mounting_pitch_rad", p.mounting_pitch_rad, Within{-3.15, 3.15}, mounting);
  each("mounting_yaw_rad", p.mounting_yaw_rad, Within{-3.15, 3.15}, mounting);
  const char * noise = "one standard deviation of a sample, rates of turn [rad/s]";
  each("rate_std_dev_rad_s", p.rate_std_dev_rad_s, Within{1e-6, 1.0}, noise);
  each(
    "acceleration_std_dev_m_s2", p.acceleration_std_dev_m_s2, Within{1e-6, 10.0},
    "the same of an acceleration [m/s^2]");
  each(
    "tilt_std_dev_rad", p.tilt_std_dev_rad, Within{1e-6, 1.0}, "the same of roll and pitch [rad]");
  each("yaw_std_dev_rad", p.yaw_std_dev_rad, Within{1e-6, 4.0}, "the same of the heading [rad]");
}

/// Whether the sensor has this rate and the wire carries it.
void check(const Vn100Config & config, stetro_config::Faults & faults);

/// From measurement to measurement.
[[nodiscard]] Time vn100_period(const Vn100Config & config);

/// What bytes take on the wire: ten bits each.
[[nodiscard]] Time vn100_wire_time(const Vn100Config & config, std::size_t bytes);

/// Length of a measurement on the wire [bytes].
[[nodiscard]] std::size_t vn100_frame_size(const Vn100Config & config);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_CONFIG_HPP_
