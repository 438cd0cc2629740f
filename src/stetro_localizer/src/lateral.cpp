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

#include "stetro_localizer/lateral.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{
namespace
{

double squared(double value) { return value * value; }

bool is_distance(const RangeReading & reading)
{
  return reading.status == RangeStatus::kValid && std::isfinite(reading.range_m) &&
         reading.range_m >= 0.0;
}

BumperParams bumpers_of(const LateralParams & params, const stetro_site::RobotGeometry & robot)
{
  return {
    robot.contact_width_m,
    {robot.block_x_m(1), robot.block_x_m(2), robot.block_x_m(3)},
    robot.block_length_m,
    params.bumper_sigma_m};
}

}  // namespace

Lateral::Lateral(const LateralParams & params, const stetro_site::RobotGeometry & robot)
: params_(params),
  noise_{robot.range_sensor.sigma_m, robot.range_sensor.sigma_per_m, params.systematic},
  left_(make_beam(Side::kLeft, robot.at(Place::kSideLeft))),
  right_(make_beam(Side::kRight, robot.at(Place::kSideRight))),
  contact_(bumpers_of(params, robot)),
  reliable_range_m_(robot.range_sensor.reliable_range_m),
  selection_(
    {robot.range_sensor.reliable_range_m,
     robot.range_sensor.reliable_range_m - params.hysteresis_m})
{
}

Lateral::Beam Lateral::make_beam(Side side, const stetro_site::Mounting & mounting) const
{
  return {
    SideRange(side, {mounting.x_m, mounting.y_m}), window_of(params_.average),
    RangeOffset{{mounting.bias_m, squared(params_.systematic.offset_sigma)}, 0.0}};
}

void Lateral::travel(double dy_m)
{
  const bool stopped = (dy_m < 0.0 && right_.touching) || (dy_m > 0.0 && left_.touching);
  if (!stopped) {
    travelled_m_ += dy_m;
    way_since_fix_m_ += std::abs(dy_m);
  }
}

// The left range falls while y rises, but for the cosine of a small heading.
double Lateral::carrier(Side side) const
{
  return side == Side::kRight ? travelled_m_ : -travelled_m_;
}

std::optional<double> Lateral::y_m() const
{
  return known_ ? std::optional<double>(fix_.y_m + travelled_m_ - fix_travelled_m_) : std::nullopt;
}

double Lateral::variance_m2(const LateralView & view) const
{
  return fix_.variance_m2 + squared(params_.odometry_scale * way_since_fix_m_) +
         squared(fix_.slope_yaw) * view.yaw_variance;
}

Verdict Lateral::add_range(
  Side side, const RangeReading & reading, const LateralView & view, SourceReport & report)
{
  const bool walled = side == Side::kLeft ? view.wall_left : view.wall_right;
  if (!walled || !is_distance(reading)) {
    return {Outcome::kNotVisible, Refusal::kNone};
  }
  if (reading.stamp <= beam(side).last_stamp) {
    return {Outcome::kStale, Refusal::kNone};  // the same measurement again
  }
  beam(side).last_stamp = reading.stamp;
  if (!in_reach(side, view)) {
    return {Outcome::kNotVisible, Refusal::kNone};
  }
  if (in_gate(side, reading.range_m, view, report)) {
    beam(side).average.add(reading.stamp, reading.range_m, carrier(side));
    return {Outcome::kFused, Refusal::kNone};
  }
  if (report.reject_streak + 1 >= static_cast<std::uint32_t>(params_.reject_limit)) {
    // With the other side in use, the two contradict each other. Without, the robot is elsewhere.
    closes_ = closes_ && !measured_;
    searching_ = searching_ || !measured_;
  }
  return {Outcome::kGated, Refusal::kNone};
}

// Beyond its reach the sensor now and then makes a number up. That is no contradiction, as long as
// the other side says where the robot is.
bool Lateral::in_reach(Side side, const LateralView & view) const
{
  if (!known_ || searching_ || !measured_) {
    return true;
  }
  const double nearest_m =
    expected_m(side, view) - params_.gate_sigma * std::sqrt(variance_m2(view));
  return nearest_m <= reliable_range_m_;
}

double Lateral::expected_m(Side side, const LateralView & view) const
{
  const Beam & of = beam(side);
  return of.model.range_m(*y_m(), view.yaw_rad, view.width_m) + of.offset.offset.value;
}

bool Lateral::in_gate(
  Side side, double range_m, const LateralView & view, SourceReport & report) const
{
  if (!known_ || searching_) {
    return true;
  }
  const Beam & of = beam(side);
  report.innovation = range_m - expected_m(side, view);
  report.innovation_variance =
    variance_m2(view) + squared(params_.width_sigma_m) +
    mean_variance_m2(noise_, range_m, 1, of.offset.offset.variance, of.offset.calibrated_at_m);
  report.test_ratio =
    squared(report.innovation) / (squared(params_.gate_sigma) * report.innovation_variance);
  return report.test_ratio <= 1.0;
}

std::optional<CarriedAverage::Mean> Lateral::mean(Side side, Nanoseconds now) const
{
  return beam(side).average.at(now, carrier(side));
}

std::optional<SideFix> Lateral::fix_of(Side side, Nanoseconds now, const LateralView & view) const
{
  const auto average = mean(side, now);
  if (!average) {
    return std::nullopt;
  }
  const Beam & of = beam(side);
  const double corrected_m = average->value - of.offset.offset.value;
  const double width = side == Side::kLeft ? squared(params_.width_sigma_m) : 0.0;
  return SideFix{
    average->value, of.model.y_m(corrected_m, view.yaw_rad, view.width_m),
    squared(of.model.slope_range(view.yaw_rad)) * mean_variance_m2(
                                                    noise_, average->value, average->count,
                                                    of.offset.offset.variance,
                                                    of.offset.calibrated_at_m) +
      width,
    of.model.slope_yaw(corrected_m, view.yaw_rad)};
}

void Lateral::choose(Nanoseconds now, const LateralView & view)
{
  const auto left = fix_of(Side::kLeft, now, view);
  const auto right = fix_of(Side::kRight, now, view);
  const auto chosen = selection_.choose(left, right);
  measured_ = chosen.has_value();
  if (!chosen) {
    return;
  }
  if (chosen->left && chosen->right) {
    // Contradicting sides keep the flag until they agree again.
    const double gap_m = left->y_m - right->y_m;
    const double doubt = left->variance_m2 + right->variance_m2;
    closes_ = squared(gap_m) <= squared(params_.gate_sigma) * doubt;
  }
  restarts_ += searching_ ? 1 : 0;
  searching_ = false;
  settle(*chosen);
}

void Lateral::settle(const LateralFix & fix)
{
  known_ = true;
  fix_ = fix;
  fix_travelled_m_ = travelled_m_;
  way_since_fix_m_ = 0.0;
}

void Lateral::reset(double y_m, double variance_m2)
{
  left_.average.clear();
  right_.average.clear();
  measured_ = false;
  closes_ = true;
  settle({y_m, variance_m2, 0.0, false, false});
}

Verdict Lateral::add_bumpers(
  Side side, const std::array<Switch, 3> & bumpers, Nanoseconds now, const LateralView & view,
  SourceReport & report, std::optional<double> & before)
{
  Beam & of = beam(side);
  const std::array<bool, 3> closed{
    bumpers[0].is_closed(), bumpers[1].is_closed(), bumpers[2].is_closed()};
  const bool walled = side == Side::kLeft ? view.wall_left : view.wall_right;
  const auto contact = contact_.fix(side, closed, view.yaw_rad, view.yaw_variance, view.width_m);
  if (!contact || !walled) {
    of.closed = of.touching = of.squared = false;
    return {contact ? Outcome::kGated : Outcome::kNotVisible, Refusal::kNone};
  }
  const bool begins = !of.closed;
  const bool squares = of.touching && !of.squared && closed.front() && closed.back();
  of.closed = true;
  if (!begins && !squares) {
    return {of.touching ? Outcome::kFused : Outcome::kGated, Refusal::kNone};
  }
  if (begins) {
    of.before_contact = of.offset;
    report.innovation = known_ ? contact->y_m - *y_m() : 0.0;
    report.innovation_variance = contact->variance_m2 + (known_ ? variance_m2(view) : 0.0);
    report.test_ratio = squared(report.innovation / params_.contact_gate_m);
  }
  if (report.test_ratio > 1.0 || !learn_offset(side, *contact, now, view)) {
    return {Outcome::kGated, Refusal::kNone};
  }
  if (begins) {
    before = y_m();
  }
  of.touching = true;
  of.squared = closed.front() && closed.back();
  settle({contact->y_m, contact->variance_m2, 0.0, false, false});
  return {Outcome::kFused, Refusal::kNone};
}

// b = mean reading - the range that belongs to the contact. False if that is beyond belief.
bool Lateral::learn_offset(
  Side side, const ContactFix & contact, Nanoseconds now, const LateralView & view)
{
  const auto average = mean(side, now);
  if (!average) {
    return true;  // nothing to calibrate; the contact itself still counts
  }
  Beam & of = beam(side);
  const double true_m = of.model.range_m(contact.y_m, view.yaw_rad, view.width_m);
  const double measured_m = average->value - true_m;
  if (std::abs(measured_m) > params_.offset_limit_m) {
    return false;
  }
  of.offset = of.before_contact;
  of.offset.offset.grow(squared(params_.offset_walk_m));
  of.offset.offset.update(
    measured_m,
    contact.variance_m2 + mean_variance_m2(noise_, true_m, average->count, 0.0, true_m));
  of.offset.calibrated_at_m = true_m;
  ++calibrations_;
  return true;
}

}  // namespace stetro_localizer
