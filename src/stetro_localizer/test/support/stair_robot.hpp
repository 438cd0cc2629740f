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

#ifndef SUPPORT__STAIR_ROBOT_HPP_
#define SUPPORT__STAIR_ROBOT_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "stetro_localizer/estimator.hpp"

namespace stetro_localizer
{

/// The papers' stairs: 16 steps of 0.14 m by 0.32 m, 2.05 m wide.
inline stetro_site::Flight papers_flight()
{
  stetro_site::FlightSpec spec;
  spec.id = "papers";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.05;
  return stetro_site::Flight(spec);
}

/// How the sensors of a StairRobot err. All zero: exactly.
struct SensorErrors
{
  std::array<double, 8> offset_m{};  ///< by place
  std::array<double, 8> gain{};      ///< by place, about 1
  double white_m = 0.0;
  double white_per_m = 0.0;
  double gyro_bias_radps = 0.0;
  double gyro_white_radps = 0.0;
  double wheel_scale = 0.0;
};

/// A robot on the papers' stairs, reduced to geometry: what an estimator is tested with.
/**
 * It is driven by hand and feeds the estimator as the driver would: gyroscope and wheels at 100 Hz,
 * ranges and blocks at 30 Hz, contacts at 10 Hz and on change. Nothing here knows the estimator's
 * formulas. Not a simulation: it cannot fall, slip or collide, only the walls stop it.
 */
class StairRobot
{
public:
  explicit StairRobot(Estimator & estimator, SensorErrors errors = {}, unsigned seed = 1)
  : estimator_(&estimator), errors_(errors), random_(seed)
  {
  }

  double x_m = -0.5;
  double y_m = 1.0;
  double yaw_rad = 0.0;
  std::array<double, 3> block_z_m{};              ///< undersides in the flight frame
  std::array<bool, 3> bearing{true, true, true};  ///< blocks that stand
  bool sides_dead = false;                        ///< the side sensors see nothing
  bool front_dead = false;                        ///< the front pair sees nothing
  bool switches_closed = false;                   ///< both riser switches
  std::optional<Place> dead;                      ///< a sensor that has stopped to answer
  double person_m = 0.0;                          ///< if not 0: front pair reads this [m]
  double cone_rad = 0.0;   ///< full angle in which a front beam takes a side wall in [rad]
  double made_up_m = 0.0;  ///< if not 0: a side sensor beyond its reach reads this [m]
  Nanoseconds now = std::chrono::seconds(1000);

  /// Puts it on a tread as for sweeping (1..15), or on the floor (0).
  void stand_on(int step)
  {
    x_m = step == 0 ? -0.5 : step * 0.32 - 0.085;
    const double z_m = step * 0.14;
    block_z_m = {step == 0 ? z_m : z_m + 0.14, z_m, z_m};
    bearing = {true, true, true};
  }

  /// Drives with a velocity of `base_link` for a time.
  void drive(double vx, double vy, double wz, double duration_s)
  {
    for (int i = 0; i < static_cast<int>(std::lround(duration_s * 100.0)); ++i) {
      tick(vx, vy, wz);
    }
  }
  void rest(double duration_s) { drive(0.0, 0.0, 0.0, duration_s); }

  /// Moves along y until it touches a wall, and on for a moment.
  void sweep_left()
  {
    drive_until([this] { return touches(true); }, 0.15);
  }
  void sweep_right()
  {
    drive_until([this] { return touches(false); }, -0.15);
  }

  /// From the floor: block 1 onto tread 1, square to riser 1, 1 cm back.
  void approach()
  {
    drive(0.05, 0.0, 0.0, (-0.24 - x_m) / 0.05);
    lift(0, 0.18);
    drive(0.05, 0.0, 0.0, (-0.075 - x_m) / 0.05);
    switches_closed = true;
    lower(0, 0.14);
    switches_closed = false;
    drive(-0.02, 0.0, 0.0, 0.5);
    rest(0.3);
  }

  /// The house's climb from sweeping tread `step` (0: the floor, block 1 on tread 1) to the next.
  void climb(int step)
  {
    const double z_m = step * 0.14;
    const double up_m = std::min(step + 2, 16) * 0.14;  // where block 1 will stand
    lift(1, z_m + 0.18);
    drive(0.05, 0.0, 0.0, 3.2);
    lower(1, z_m + 0.14);
    lift(2, z_m + 0.18);
    lift(0, block_z_m[0] + 0.18);
    if (step + 1 < 16) {
      drive(0.05, 0.0, 0.0, ((step + 1) * 0.32 - 0.075 - x_m) / 0.05);
      switches_closed = true;
    } else {
      drive(0.05, 0.0, 0.0, 3.4);
    }
    lower(0, up_m);
    lower(2, z_m + 0.14);
    rest(0.5);
    switches_closed = false;
    drive(-0.02, 0.0, 0.0, 0.5);
  }

  /// One step of 10 ms.
  void tick(double vx, double vy, double wz)
  {
    now += std::chrono::milliseconds(10);
    ++ticks_;
    x_m += (vx * std::cos(yaw_rad) - vy * std::sin(yaw_rad)) * 0.01;
    y_m += (vx * std::sin(yaw_rad) + vy * std::cos(yaw_rad)) * 0.01;
    yaw_rad += wz * 0.01;
    const double gap_m = 0.115 * std::cos(yaw_rad) + 0.225 * std::sin(std::abs(yaw_rad));
    y_m = std::clamp(y_m, gap_m, 2.05 - gap_m);
    const double scale = 1.0 + errors_.wheel_scale;
    estimator_->add_odometry({now, vx * scale, vy * scale, wz * scale}, now);
    estimator_->add_gyro(
      {now, wz + errors_.gyro_bias_radps + errors_.gyro_white_radps * normal_(random_)}, now);
    const bool change = touches(true) != sent_left_ || touches(false) != sent_right_ ||
                        switches_closed != sent_switches_;
    if (change || ticks_ % 10 == 0) {
      estimator_->add_contacts(contacts(), now);
    }
    if (ticks_ % 3 == 0) {  // 33 Hz
      estimator_->add_blocks(blocks(), now);
      estimator_->add_ranges(ranges(), now);
    }
  }

  [[nodiscard]] bool touches(bool left) const
  {
    const double gap_m = 0.115 * std::cos(yaw_rad) + 0.225 * std::sin(std::abs(yaw_rad));
    return left ? y_m >= 2.05 - gap_m - 1e-9 : y_m <= gap_m + 1e-9;
  }

  [[nodiscard]] RangeSample ranges()
  {
    RangeSample sample;
    sample.stamp = now;
    for (const Place place : stetro_site::kPlaces) {
      sample[place] = reading(place);
    }
    return sample;
  }

  [[nodiscard]] BlockSample blocks() const
  {
    BlockSample sample;
    sample.stamp = now;
    const double lowest_m = *std::min_element(block_z_m.begin(), block_z_m.end());
    const double share = 1.0 / (bearing[0] + bearing[1] + bearing[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      sample.blocks[i] = {
        block_z_m[i] - lowest_m, bearing[i] ? share : 0.0, true, static_cast<int>(i) == moving_,
        false};
    }
    return sample;
  }

private:
  template <class Condition>
  void drive_until(Condition && reached, double vy)
  {
    for (int i = 0; i < 3000 && !reached(); ++i) {
      tick(0.0, vy, 0.0);
    }
    drive(0.0, vy, 0.0, 0.1);  // the wheels go on for a moment
  }

  void lift(std::size_t block, double z_m)
  {
    bearing[block] = false;
    move(block, z_m);
  }

  void lower(std::size_t block, double z_m)
  {
    move(block, z_m);
    bearing[block] = true;
    rest(0.3);
  }

  void move(std::size_t block, double z_m)
  {
    moving_ = static_cast<int>(block);
    while (std::abs(block_z_m[block] - z_m) > 1e-9) {
      const double step_m = std::clamp(z_m - block_z_m[block], -0.0006, 0.0006);
      block_z_m[block] += step_m;  // 0.06 m/s
      tick(0.0, 0.0, 0.0);
    }
    moving_ = -1;
    rest(0.3);
  }

  // Distance to the first vertical face in front of the front pair's height.
  [[nodiscard]] double front_m(double mount_y_m) const
  {
    if (person_m > 0.0) {
      return person_m;
    }
    const double beam_z_m = block_z_m[0] + 0.07;
    const int riser = static_cast<int>(std::floor(beam_z_m / 0.14)) + 1;
    if (riser > 16) {
      return 9.0;
    }
    const double start_m = x_m + 0.19 * std::cos(yaw_rad) - mount_y_m * std::sin(yaw_rad);
    const double riser_m = ((riser - 1) * 0.32 - start_m) / std::cos(yaw_rad);
    return std::min(riser_m, wall_in_cone_m(mount_y_m));
  }

  // Block 2's rear face while that is in the way, else the first face behind it.
  [[nodiscard]] double block3_front_m() const
  {
    if (block_z_m[1] - block_z_m[2] < 0.12) {
      return 0.035;
    }
    const int riser = static_cast<int>(std::floor((block_z_m[2] + 0.07) / 0.14)) + 1;
    return riser > 16 ? 9.0 : std::max((riser - 1) * 0.32 - x_m + 0.11, 0.0);
  }

  // Where the edge of a front beam's cone meets the nearer side wall.
  [[nodiscard]] double wall_in_cone_m(double mount_y_m) const
  {
    const double beam_y_m = y_m + 0.19 * std::sin(yaw_rad) + mount_y_m * std::cos(yaw_rad);
    const double left = std::sin(cone_rad / 2.0 + yaw_rad);
    const double right = std::sin(cone_rad / 2.0 - yaw_rad);
    const double left_m = left > 0.0 ? (2.05 - beam_y_m) / left : 9.0;
    const double right_m = right > 0.0 ? beam_y_m / right : 9.0;
    return cone_rad > 0.0 ? std::min(left_m, right_m) : 9.0;
  }

  [[nodiscard]] double true_range_m(Place place) const
  {
    switch (place) {
      case Place::kFrontLeft:
        return front_dead ? 9.0 : front_m(0.10);
      case Place::kFrontRight:
        return front_dead ? 9.0 : front_m(-0.10);
      case Place::kStairFront:
        return front_dead ? 9.0 : front_m(0.0);
      case Place::kSideLeft:
        return sides_dead ? 9.0 : (2.05 - y_m) / std::cos(yaw_rad) - 0.05;
      case Place::kSideRight:
        return sides_dead ? 9.0 : y_m / std::cos(yaw_rad) - 0.05;
      case Place::kBlock1Down:
        return 0.035 + (bearing[0] ? 0.0 : 0.1);
      case Place::kBlock3Front:
        return block3_front_m();
      case Place::kBlock2Down:
        return 0.035 + (bearing[1] ? 0.0 : 0.1);
      default:
        return 9.0;
    }
  }

  [[nodiscard]] RangeReading reading(Place place)
  {
    const std::size_t i = stetro_site::index_of(place);
    if (place == dead) {
      return {answered_[i], 0.0, 0.0, RangeStatus::kFault};
    }
    answered_[i] = now;
    const double true_m = true_range_m(place);
    const double sigma_m = std::hypot(errors_.white_m, errors_.white_per_m * true_m);
    const double range_m =
      true_m * (1.0 + errors_.gain[i]) + errors_.offset_m[i] + sigma_m * normal_(random_);
    const bool side = place == Place::kSideLeft || place == Place::kSideRight;
    if (true_m > 1.3 && side && made_up_m > 0.0) {
      return {now, made_up_m, 0.0, RangeStatus::kValid};
    }
    if (true_m > 1.3) {
      return {now, std::numeric_limits<double>::infinity(), 0.0, RangeStatus::kNoTarget};
    }
    return {now, std::max(range_m, 0.0), 0.0, RangeStatus::kValid};
  }

  [[nodiscard]] ContactSample contacts()
  {
    sent_left_ = touches(true);
    sent_right_ = touches(false);
    sent_switches_ = switches_closed;
    ContactSample sample;
    sample.stamp = now;
    sample.left.fill({true, sent_left_});
    sample.right.fill({true, sent_right_});
    sample.riser_left = sample.riser_right = {true, switches_closed};
    return sample;
  }

  Estimator * estimator_;
  SensorErrors errors_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::array<Nanoseconds, stetro_site::kPlaces.size()> answered_{};
  int ticks_ = 0;
  int moving_ = -1;
  bool sent_left_ = false;
  bool sent_right_ = false;
  bool sent_switches_ = false;
};

}  // namespace stetro_localizer

#endif  // SUPPORT__STAIR_ROBOT_HPP_
