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

#include "stetro_localizer/heading.hpp"

#include <cmath>

#include "stetro_localizer/measurement/front_pair.hpp"

namespace stetro_localizer
{
namespace
{

double squared(double value) { return value * value; }

}  // namespace

Heading::Heading(
  const HeadingParams & params, const GyroParams & gyro, const stetro_site::RobotGeometry & robot)
: params_(params),
  noise_{robot.range_sensor.sigma_m, robot.range_sensor.sigma_per_m, params.systematic},
  baseline_m_(robot.front_baseline_m()),
  range_limit_m_(robot.range_sensor.reliable_range_m),
  gyro_(gyro),
  difference_(window_of(params.average)),
  distance_(window_of(params.average)),
  offset_{
    {robot.at(Place::kFrontLeft).bias_m - robot.at(Place::kFrontRight).bias_m,
     2.0 * squared(params.systematic.offset_sigma)},
    0.0},
  fix_variance_(squared(params.initial_sigma_rad)),
  reference_variance_(fix_variance_)
{
}

bool Heading::add_gyro(const GyroSample & sample, bool standing)
{
  return gyro_.add(sample, standing);
}

double Heading::yaw_rad() const { return fix_yaw_rad_ + gyro_.angle_rad() - fix_angle_rad_; }

void Heading::fix(double yaw_rad, double variance)
{
  fix_yaw_rad_ = yaw_rad;
  fix_variance_ = variance;
  fix_angle_rad_ = gyro_.angle_rad();
  gyro_.mark();
  restarts_ += restarting_ ? 1 : 0;
  restarting_ = false;
  seen_ = true;
  reference_variance_ = 0.0;
}

void Heading::reset(double yaw_rad, double variance)
{
  clear_window();
  fix(yaw_rad, variance);
}

void Heading::set_calibration(const RangeOffset & difference, const ScalarEstimate & gyro_bias)
{
  offset_ = difference;
  gyro_.set_bias(gyro_bias);
}

void Heading::clear_window()
{
  difference_.clear();
  distance_.clear();
}

Verdict Heading::add_pair(
  const RangeReading & left, const RangeReading & right, std::optional<int> riser, double travel_m,
  SourceReport & report)
{
  if (riser != riser_) {
    clear_window();  // ranges to another riser do not mix
    riser_ = riser;
  }
  const double difference_m = left.range_m - right.range_m;
  const double range_m = (left.range_m + right.range_m) / 2.0;
  if (!riser || !usable(left, right)) {
    return {Outcome::kNotVisible, Refusal::kNone};
  }
  if (left.stamp <= last_stamp_) {
    return {Outcome::kStale, Refusal::kNone};  // the same measurement again
  }
  last_stamp_ = left.stamp;
  if (!in_gate(difference_m, range_m, report)) {
    if (report.reject_streak + 1 >= static_cast<std::uint32_t>(params_.reject_limit)) {
      clear_window();
      seen_ = false;  // the next pairs are taken as they are
      restarting_ = true;
    }
    return {Outcome::kGated, Refusal::kNone};
  }
  if (pressed_) {
    calibrate_difference(difference_m, range_m);
    return {Outcome::kFused, Refusal::kNone};
  }
  difference_.add(left.stamp, difference_m, baseline_m_ * gyro_.angle_rad());
  distance_.add(left.stamp, range_m, -travel_m);
  follow_window(left.stamp, travel_m);
  return {Outcome::kFused, Refusal::kNone};
}

bool Heading::usable(const RangeReading & left, const RangeReading & right) const
{
  const auto sees = [this](const RangeReading & reading) {
    return reading.status == RangeStatus::kValid && std::isfinite(reading.range_m) &&
           reading.range_m >= 0.0 && reading.range_m < range_limit_m_;
  };
  return sees(left) && sees(right);
}

// The pair's constant error is the same in the window and in the reading, so that only the white
// noise of both and the drift of the gyroscope since the window's fix can part them.
bool Heading::in_gate(double difference_m, double range_m, SourceReport & report) const
{
  const double measured = heading_from_pair(difference_m - offset_.offset.value, baseline_m_);
  if (std::abs(measured) > params_.max_incidence_rad) {
    report.innovation = measured - yaw_rad();
    report.test_ratio = squared(measured / params_.max_incidence_rad);
    return false;
  }
  const double white =
    heading_variance(difference_m, baseline_m_, 2.0 * white_variance_m2(noise_, range_m));
  const double doubt = 2.0 * white + gyro_.variance_since_mark() + squared(params_.gate_floor_rad);
  report.innovation = measured - yaw_rad();
  report.innovation_variance = seen_ ? doubt : doubt + fix_variance_;
  report.test_ratio =
    squared(report.innovation) / (squared(params_.gate_sigma) * report.innovation_variance);
  return !seen_ || report.test_ratio <= 1.0;
}

void Heading::follow_window(Nanoseconds now, double travel_m)
{
  const auto difference = difference_.at(now, baseline_m_ * gyro_.angle_rad());
  const auto distance = distance_.at(now, -travel_m);
  if (!difference || !distance) {
    return;
  }
  const double corrected_m = difference->value - offset_.offset.value;
  fix(
    heading_from_pair(corrected_m, baseline_m_), mean_variance(distance->value, difference->count));
}

double Heading::mean_variance(double range_m, std::size_t count) const
{
  const double each = mean_variance_m2(noise_, range_m, count, 0.0, offset_.calibrated_at_m);
  return heading_variance(0.0, baseline_m_, 2.0 * each + offset_.offset.variance);
}

// While both switches are closed they know the heading, and the pair is only calibrated: from all
// the pairs of this press, starting from what was known before it.
void Heading::calibrate_difference(double difference_m, double range_m)
{
  const double expected_m = baseline_m_ * std::tan(yaw_rad());
  press_difference_m_ += difference_m - expected_m;
  press_range_m_ += range_m;
  ++press_count_;
  if (press_count_ < static_cast<std::size_t>(params_.average.window)) {
    return;
  }
  const double count = static_cast<double>(press_count_);
  const double mean_range_m = press_range_m_ / count;
  const double ranges =
    2.0 * mean_variance_m2(noise_, mean_range_m, press_count_, 0.0, mean_range_m);
  offset_ = before_press_;
  offset_.offset.grow(2.0 * squared(noise_.systematic.slow_m));
  offset_.offset.update(
    press_difference_m_ / count, ranges + squared(baseline_m_ * params_.switch_sigma_rad));
  offset_.calibrated_at_m = mean_range_m;
  calibrations_ += press_count_ == static_cast<std::size_t>(params_.average.window) ? 1 : 0;
}

Verdict Heading::add_switches(bool both_closed, SourceReport & report)
{
  if (!both_closed) {
    calibrations_ += pressed_ && press_count_ > 0 ? 1 : 0;
    pressed_ = false;
    return {Outcome::kNotVisible, Refusal::kNone};
  }
  if (pressed_) {
    return {Outcome::kFused, Refusal::kNone};
  }
  report.innovation = -yaw_rad();
  report.innovation_variance = variance() + squared(params_.switch_sigma_rad);
  report.test_ratio = squared(report.innovation / params_.switch_gate_rad);
  if (report.test_ratio > 1.0) {
    return {Outcome::kGated, Refusal::kNone};
  }
  pressed_ = true;
  before_press_ = offset_;
  press_difference_m_ = press_range_m_ = 0.0;
  press_count_ = 0;
  clear_window();
  fix(0.0, squared(params_.switch_sigma_rad));
  return {Outcome::kFused, Refusal::kNone};
}

std::optional<double> Heading::riser_distance_m(Nanoseconds now, double travel_m) const
{
  const auto mean = distance_.at(now, -travel_m);
  return riser_ && mean ? std::optional<double>(mean->value) : std::nullopt;
}

}  // namespace stetro_localizer
