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

#ifndef SUPPORT__STEP_ROBOT_HPP_
#define SUPPORT__STEP_ROBOT_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "stetro_localizer/step_filter.hpp"

namespace stetro_localizer
{

/// What goes wrong with the sensors of a StepRobot until it is taken back.
struct StepFaults
{
  std::array<bool, 3> no_load{};      ///< the block stands and shows no load
  std::array<bool, 3> full_load{};    ///< the block shows load wherever it is
  bool load_unknown = false;          ///< of block 2
  bool moving_stuck = false;          ///< block 2's lift says that it moves
  bool moving_dead = false;           ///< no lift ever says so
  std::array<bool, 4> range_dead{};   ///< block1_down, block2_down, block3_front, front
  std::array<bool, 4> range_stuck{};  ///< the same
  double spike_share = 0.0;           ///< of all ranges
  double block_loss = 0.0;            ///< share of block samples that never arrive
  double height_spike = 0.0;          ///< share of samples with one height far off
  bool odometry_silent = false;
  bool switches_stuck = false;  ///< closed
  bool switches_dead = false;
  std::optional<double> made_up_block3_front_m;
};

/// A body of three blocks on stairs, driven by hand, with sensors of the stated errors at 30 Hz.
/**
 * Geometry is worked out from where things are; it shares no formula with the filter, and nothing
 * with the simulated driver. It cannot fall: whoever drives it must not make it.
 */
class StepRobot
{
public:
  static constexpr int kSteps = 16;
  static constexpr double kRiser = 0.14;
  static constexpr double kTread = 0.32;

  explicit StepRobot(StepFilter & to, unsigned seed, double errors = 1.0)
  : filter(&to), random(seed), errors_(errors)
  {
    for (int i = 1; i <= kSteps; ++i) {
      z_m_.push_back(z_m_.back() + kRiser + 0.0015 * errors * normal());
      x_m_.push_back(x_m_.back() + kTread + 0.0025 * errors * normal());
    }
    for (std::size_t i = 0; i < 4; ++i) {
      offset_m_[i] = 0.010 * errors * normal();
      gain_[i] = 1.0 + 0.03 * errors * normal();
    }
    for (double & bias : height_bias_m_) {
      bias = 0.001 * errors * normal();
    }
    wheel_scale_ = 1.0 + 0.02 * errors * normal();
  }

  StepFilter * filter;
  std::mt19937 random;
  StepFaults faults;
  Nanoseconds now = std::chrono::seconds(1000);
  double x_m = -0.085;
  std::array<double, 3> underside_m{0.14, 0.0, 0.0};
  std::array<bool, 3> stands{true, true, true};
  int step = 0;       ///< the truth
  int samples = 0;    ///< that were sent
  int uncertain = 0;  ///< samples after which the step was not published
  int wrong = 0;      ///< samples after which another step than the true one was published
  StepEvent event = StepEvent::kNone;  ///< the last one

  double normal() { return normal_(random); }
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }

  /// Puts it on a tread as for sweeping, block 1 one higher.
  void place(int on)
  {
    step = on;
    x_m = riser_x(on + 1) - 0.085;
    for (int block = 1; block <= 3; ++block) {
      underside(block) = ground_under(block);
    }
    stands = {true, true, true};
  }

  void hold(double duration_s)
  {
    for (int i = 0; i < static_cast<int>(duration_s * 30.0); ++i) {
      tick(0);
    }
  }
  void lift(int block, double by_m)
  {
    stands[static_cast<std::size_t>(block - 1)] = false;
    move_to(block, underside(block) + by_m);
    hold(0.3);
  }
  /// Down to whatever is below.
  void lower(int block)
  {
    move_to(block, ground_under(block));
    stands[static_cast<std::size_t>(block - 1)] = true;
    step = block == 2 ? step_at(x_m) : step;
    hold(0.7);
  }
  /// Rolls until something stops it; `slip` is the share the wheels only believe in.
  void roll(double way_m, double slip = 0.0)
  {
    const int parts = static_cast<int>(std::ceil(std::abs(way_m) / 0.00167));
    for (int i = 0; i < parts; ++i) {
      const double part_m = way_m / parts;
      travel_m_ += part_m * wheel_scale_;
      x_m = std::min(x_m + part_m * (1.0 - slip), stop_x());
      tick(0);
    }
    hold(0.2);
  }
  /// A slip that the wheels do not feel.
  void slide(double by_m) { x_m = std::min(x_m + by_m, stop_x()); }

  void tick(int moving)
  {
    now += std::chrono::microseconds(33'333);
    if (chance(faults.block_loss)) {
      return;
    }
    const StepEvent last = filter->add(blocks(moving), evidence());
    event = last == StepEvent::kNone ? event : last;
    ++samples;
    const auto published = filter->step();
    uncertain += published ? 0 : 1;
    wrong += published && *published != step ? 1 : 0;
  }

  double riser_x(int k) const { return x_m_[static_cast<std::size_t>(k - 1)]; }

private:
  double & underside(int block) { return underside_m[static_cast<std::size_t>(block - 1)]; }
  double centre(int block) const { return x_m + 0.15 * (2 - block); }
  int step_at(double at_m) const
  {
    int on = 0;
    while (on < kSteps && riser_x(on + 1) <= at_m) {
      ++on;
    }
    return on;
  }
  double ground_under(int block) const
  {
    return z_m_[static_cast<std::size_t>(step_at(centre(block)))];
  }
  int riser_before(double z) const
  {
    int k = 1;
    while (k <= kSteps && z_m_[static_cast<std::size_t>(k)] <= z + 1e-9) {
      ++k;
    }
    return k;
  }
  double stop_x() const
  {
    double stop = std::numeric_limits<double>::infinity();
    for (int block = 1; block <= 3; ++block) {
      const int k = riser_before(underside_m[static_cast<std::size_t>(block - 1)]);
      if (k <= kSteps) {
        stop = std::min(stop, riser_x(k) - 0.075 - 0.15 * (2 - block));
      }
    }
    return stop;
  }
  void move_to(int block, double z)
  {
    while (std::abs(underside(block) - z) > 1e-9) {
      underside(block) += std::clamp(z - underside(block), -0.002, 0.002);
      tick(block);
    }
  }

  BlockSample blocks(int moving)
  {
    BlockSample sample;
    sample.stamp = now;
    const double feet = static_cast<double>(std::count(stands.begin(), stands.end(), true));
    std::array<double, 3> seen_m{};
    for (std::size_t i = 0; i < 3; ++i) {
      seen_m[i] = underside_m[i] + height_bias_m_[i] + 0.0004 * errors_ * normal();
    }
    if (chance(faults.height_spike)) {
      seen_m[static_cast<std::size_t>(random() % 3)] += uniform(-0.2, 0.2);
    }
    const double lowest_m = *std::min_element(seen_m.begin(), seen_m.end());
    for (std::size_t i = 0; i < 3; ++i) {
      const bool bears = (stands[i] && !faults.no_load[i]) || faults.full_load[i];
      const bool moves = static_cast<int>(i) + 1 == moving && !faults.moving_dead;
      sample.blocks[i] = {
        seen_m[i] - lowest_m, bears ? 1.0 / feet : 0.0, !(i == 1 && faults.load_unknown),
        moves || (i == 1 && faults.moving_stuck), false};
    }
    return sample;
  }

  StepEvidence evidence()
  {
    StepEvidence out;
    out.block1_down_m = range(0, underside_m[0] - ground_under(1) + 0.035);
    out.block2_down_m = range(1, underside_m[1] - ground_under(2) + 0.035);
    out.block3_front_m =
      faults.made_up_block3_front_m ? faults.made_up_block3_front_m : range(2, below_block2_m());
    const int k = riser_before(underside_m[0] + 0.07);
    const double ahead_m = k <= kSteps ? riser_x(k) - x_m - 0.19 : 9.0;
    out.front_m = range(3, ahead_m);
    if (out.front_m) {
      *out.front_m += 0.19;
    } else if (!faults.range_dead[3] && ahead_m > 1.2) {
      out.front_m = std::numeric_limits<double>::infinity();
    }
    if (!faults.odometry_silent) {
      out.travel_m = travel_m_;
    }
    const int ahead = riser_before(underside_m[1]);
    const bool closed =
      faults.switches_stuck || (ahead <= kSteps && riser_x(ahead) - x_m - 0.075 < 5e-4);
    out.riser_left = out.riser_right = {!faults.switches_dead, closed};
    return out;
  }

  double below_block2_m() const
  {
    if (underside_m[1] < underside_m[2] + 0.08) {
      return 0.035;  // block 2's rear face
    }
    const int k = riser_before(underside_m[2] + 0.07);
    return k <= kSteps ? riser_x(k) - (x_m - 0.11) : 9.0;
  }

  std::optional<double> range(std::size_t which, double true_m)
  {
    if (faults.range_dead[which]) {
      return std::nullopt;
    }
    if (faults.range_stuck[which] && last_m_[which]) {
      return last_m_[which];
    }
    if (chance(faults.spike_share)) {
      return uniform(0.03, 1.2);
    }
    const double white_m = errors_ * std::hypot(0.0021, 0.015 * true_m) * normal();
    const double seen_m = true_m * gain_[which] + offset_m_[which] + white_m;
    const bool valid = seen_m > 0.03 && seen_m < 1.2;
    last_m_[which] = valid ? std::optional<double>(seen_m) : std::nullopt;
    return last_m_[which];
  }

  double errors_;
  std::vector<double> z_m_{0.0};
  std::vector<double> x_m_{0.0};
  std::array<double, 4> offset_m_{};
  std::array<double, 4> gain_{};
  std::array<double, 3> height_bias_m_{};
  std::array<std::optional<double>, 4> last_m_{};
  double wheel_scale_ = 1.0;
  double travel_m_ = 0.0;
  std::normal_distribution<double> normal_;
};

/// Block 2 onto the next tread, from sweeping (stages 1 to 3 of the climb).
inline void step_up(StepRobot & robot, double slip = 0.0)
{
  robot.lift(2, 0.18);
  robot.roll(0.18, slip);
  robot.lower(2);
}

/// The rest of the climb (stages 4 to 7), to sweeping.
inline void follow_up(StepRobot & robot)
{
  robot.lift(3, 0.18);
  if (robot.step < StepRobot::kSteps) {
    robot.lift(1, 0.18);
  }
  robot.roll(robot.step < StepRobot::kSteps ? 0.25 : 0.17);
  if (!robot.stands[0]) {
    robot.lower(1);
  }
  robot.lower(3);
  robot.roll(-0.01);
}

/// From sweeping, the climb backwards: block 2 one tread lower.
inline void go_down(StepRobot & robot)
{
  robot.lift(3, 0.04);
  robot.lift(1, 0.04);
  robot.roll(robot.riser_x(robot.step) + 0.070 - robot.x_m);
  robot.lower(1);
  robot.lower(3);
  robot.lift(2, 0.04);
  robot.roll(robot.riser_x(robot.step) - 0.085 - robot.x_m);
  robot.lower(2);
}

}  // namespace stetro_localizer

#endif  // SUPPORT__STEP_ROBOT_HPP_
