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

#ifndef LINUX__IMU__NED_HPP_
#define LINUX__IMU__NED_HPP_

#include <array>
#include <cmath>

#include "stetro_driver/sensor_frame.hpp"

/// \file
/// From the VN-100's axes to those of REP 103: the only place that knows both.
/**
 * The VN-100 measures in its body frame x forward, y right, z down, and gives its attitude in
 * North-East-Down (UM001 rev 2.22, page 42): seen from above its yaw grows clockwise from north.
 * REP 103 has x forward, y left, z up, and a world of East-North-Up with the yaw growing
 * counter-clockwise from east.
 *
 * Body: half a turn about x, v_flu = (x, -y, -z).                                          (1)
 * World: half a turn about the line between north and east, v_enu = (y, x, -z).            (2)
 * Both at once turn the attitude (x, y, z, w) into
 *
 *   k (x + y, x - y, w - z, w + z),  k = sqrt(1/2)                                         (3)
 *
 * which in Euler angles is yaw' = 90 deg - yaw, pitch' = -pitch, roll' = roll. (1), (2) and so
 * (3) are their own inverses, up to the sign that means nothing of a quaternion.
 */

namespace stetro_driver::linux_io
{

using Axes = std::array<double, 3>;

/// (1), both ways: body axes forward-right-down to forward-left-up.
[[nodiscard]] constexpr Axes flip_body(const Axes & v) { return {v[0], -v[1], -v[2]}; }

/// (3), both ways: attitude in north-east-down to attitude in east-north-up.
[[nodiscard]] inline Quaternion flip_attitude(const Quaternion & q)
{
  const double k = std::sqrt(0.5);
  return {k * (q.x + q.y), k * (q.x - q.y), k * (q.w - q.z), k * (q.w + q.z)};
}

[[nodiscard]] constexpr Quaternion inverse(const Quaternion & q) { return {-q.x, -q.y, -q.z, q.w}; }

/// First b, then a.
[[nodiscard]] constexpr Quaternion operator*(const Quaternion & a, const Quaternion & b)
{
  return {
    a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
    a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// The vector, turned by a unit quaternion.
[[nodiscard]] constexpr Axes rotated(const Quaternion & q, const Axes & v)
{
  const Quaternion turned = q * Quaternion{v[0], v[1], v[2], 0.0} * inverse(q);
  return {turned.x, turned.y, turned.z};
}

/// Yaw about z, then pitch about the new y, then roll about the new x. In any right-handed frame.
[[nodiscard]] inline Quaternion from_euler(double roll_rad, double pitch_rad, double yaw_rad)
{
  return Quaternion{0.0, 0.0, std::sin(yaw_rad / 2), std::cos(yaw_rad / 2)} *
         Quaternion{0.0, std::sin(pitch_rad / 2), 0.0, std::cos(pitch_rad / 2)} *
         Quaternion{std::sin(roll_rad / 2), 0.0, 0.0, std::cos(roll_rad / 2)};
}

/// Roll, pitch, yaw as from_euler() takes them; pitch from -90 to 90 degrees.
[[nodiscard]] inline Axes to_euler(const Quaternion & q)
{
  const double up = 2.0 * (q.w * q.y - q.x * q.z);
  return {
    std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)),
    std::asin(std::fmax(-1.0, std::fmin(1.0, up))),
    std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

/// How the VN-100 is screwed to the robot.
/**
 * The rotation of its flipped axes (x as printed on it, y and z against what is printed) in
 * base_link; the identity when its printed x points forward and its printed z down.
 */
class ImuMounting
{
public:
  ImuMounting(double roll_rad, double pitch_rad, double yaw_rad)
  : sensor_in_base_(from_euler(roll_rad, pitch_rad, yaw_rad))
  {
  }

  /// Rates or accelerations in the sensor's printed axes, to base_link.
  [[nodiscard]] Axes to_base(const Axes & printed) const
  {
    return rotated(sensor_in_base_, flip_body(printed));
  }
  /// The way back, for the emulator.
  [[nodiscard]] Axes to_sensor(const Axes & in_base) const
  {
    return flip_body(rotated(inverse(sensor_in_base_), in_base));
  }

  /// Attitude of the sensor's printed axes in north-east-down, to that of base_link in REP 103.
  [[nodiscard]] Quaternion to_base(const Quaternion & sensor_in_ned) const
  {
    return flip_attitude(sensor_in_ned) * inverse(sensor_in_base_);
  }
  /// The way back, for the emulator.
  [[nodiscard]] Quaternion to_sensor(const Quaternion & base_in_world) const
  {
    return flip_attitude(base_in_world * sensor_in_base_);
  }

private:
  Quaternion sensor_in_base_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__NED_HPP_
