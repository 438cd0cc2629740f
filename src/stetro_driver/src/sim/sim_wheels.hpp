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

#ifndef SIM__SIM_WHEELS_HPP_
#define SIM__SIM_WHEELS_HPP_

#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// What the wheels are told, in base_link.
struct WheelSpeeds
{
  double vx_m_s = 0.0;
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;

  [[nodiscard]] bool moving() const { return vx_m_s != 0.0 || vy_m_s != 0.0 || wz_rad_s != 0.0; }
};

/// Wheels and their odometry: what the ground does to them, and what they believe they did.
/**
 * The wheels turn at the told speed times (1 + variation). The body follows, plus slips and a
 * heading disturbance that the wheels do not feel. Odometry reports the wheels times (1 + scale).
 */
class SimWheels
{
public:
  SimWheels(const SimErrors & errors, std::uint64_t seed);

  /// Turns the wheels for dt. \return how the ground lets the body follow, in base_link
  [[nodiscard]] Displacement roll(const WheelSpeeds & told, double dt_s);

  /// Lets the body slip along its next motions without the wheels turning. \param distance_m signed
  void slip(double distance_m) { slip_left_m_ += distance_m; }

  [[nodiscard]] OdometryReading odometry(Time now) const;
  [[nodiscard]] double scale() const { return scale_; }

  template <class Archive>
  void archive(Archive & each)
  {
    random_.archive(each);
    variation_.archive(each);
    disturbance_.archive(each);
    each(
      slip_left_m_, odometry_.vx_m_s, odometry_.vy_m_s, odometry_.wz_rad_s, odometry_.x_m,
      odometry_.y_m, odometry_.yaw_rad, odometry_.rolled_m, odometry_.turned_rad);
  }

private:
  void count(const WheelSpeeds & turned, double dt_s);

  SimErrors errors_;
  RandomStream random_;
  double scale_;
  Wander variation_;
  Wander disturbance_;
  double slip_left_m_ = 0.0;
  OdometryReading odometry_{};
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_WHEELS_HPP_
