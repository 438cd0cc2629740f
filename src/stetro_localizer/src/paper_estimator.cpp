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

#include "stetro_localizer/paper_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stetro_localizer/front_reference.hpp"
#include "stetro_localizer/sample_fault.hpp"

namespace stetro_localizer
{
namespace
{

// x measured off its tread by less, or for less time, is an error of measurement or a passing beam.
constexpr double kOutsideMargin = 0.06;  // [m]
constexpr double kOutsideTime = 0.5;     // [s]

std::vector<double> risers_of(const stetro_site::Flight & flight)
{
  std::vector<double> risers_m;
  for (int i = 1; i <= flight.steps(); ++i) {
    risers_m.push_back(flight.riser_m(i));
  }
  return risers_m;
}

}  // namespace

PaperEstimator::PaperEstimator(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight)
: params_(params),
  robot_(robot),
  flight_(flight),
  segment_(segment_of(flight)),
  watch_(params.silence_s),
  standstill_(params.standstill),
  heading_(params.heading, params.gyro, robot),
  lateral_(params.lateral, robot),
  steps_(risers_of(flight), robot.contact_reading_m(Place::kBlock2Down), params.steps),
  closure_(flight.width_m(0.0), robot.contact_width_m)
{
  guards_.fill(
    StampGuard({nanoseconds(params.future_tolerance_s), nanoseconds(params.max_sample_age_s)}));
}

Verdict PaperEstimator::admit(Source input, Nanoseconds stamp, Nanoseconds now, Refusal fault)
{
  if (fault == Refusal::kNone) {
    fault = guards_[static_cast<std::size_t>(input)].accept(stamp, now);
  }
  Verdict verdict{Outcome::kFused, fault};
  if (fault != Refusal::kNone) {
    verdict = Verdict::refused(fault);
  } else {
    watch_.note(input, now);
  }
  reports_[input].note(verdict);
  return verdict;
}

Verdict PaperEstimator::add_gyro(const GyroSample & sample, Nanoseconds now)
{
  const Verdict verdict = admit(Source::kGyro, sample.stamp, now, fault_of(sample));
  if (!verdict.is_refused()) {
    heading_.add_gyro(sample, standstill_.standing());
  }
  return verdict;
}

Verdict PaperEstimator::add_odometry(const OdometrySample & sample, Nanoseconds now)
{
  const Nanoseconds before = guards_[static_cast<std::size_t>(Source::kOdometry)].last();
  const Verdict verdict = admit(Source::kOdometry, sample.stamp, now, fault_of(sample));
  if (verdict.is_refused()) {
    return verdict;
  }
  standstill_.note(sample);
  const double dt_s =
    before == Nanoseconds{0} ? 0.0 : std::min(seconds(sample.stamp - before), params_.silence_s);
  const double yaw = heading_.yaw_rad();
  travel_x_m_ += (sample.vx_mps * std::cos(yaw) - sample.vy_mps * std::sin(yaw)) * dt_s;
  lateral_.travel((sample.vx_mps * std::sin(yaw) + sample.vy_mps * std::cos(yaw)) * dt_s);
  return verdict;
}

Verdict PaperEstimator::add_blocks(const BlockSample & sample, Nanoseconds now)
{
  const Verdict verdict = admit(Source::kBlocks, sample.stamp, now, fault_of(sample));
  if (!verdict.is_refused()) {
    take_step_event(steps_.add(sample, block2_down_m(now)));
  }
  return verdict;
}

std::optional<double> PaperEstimator::block2_down_m(Nanoseconds now) const
{
  const bool counts = block2_down_.status == RangeStatus::kValid &&
                      now - block2_down_.stamp <= nanoseconds(params_.max_sample_age_s);
  return counts ? std::optional<double>(block2_down_.range_m) : std::nullopt;
}

void PaperEstimator::take_step_event(StepEvent event)
{
  if (event == StepEvent::kNone) {
    return;
  }
  ++step_changes_;
  if (event == StepEvent::kClimbed || event == StepEvent::kUndone) {
    closure_ = ContactClosure(width_here_m(), robot_.contact_width_m);
    foot_assumed_ = false;
    climbed_travel_m_ = travel_x_m_;
  }
  jumps_.undone += event == StepEvent::kUndone ? 1 : 0;
  if (event == StepEvent::kLost) {
    step_reasons_ = kStepUncertain;
    foot_assumed_ = false;
  }
}

Verdict PaperEstimator::add_contacts(const ContactSample & sample, Nanoseconds now)
{
  const Verdict verdict = admit(Source::kContacts, sample.stamp, now, Refusal::kNone);
  if (verdict.is_refused()) {
    return verdict;
  }
  const LateralView view = lateral_view();
  add_bumpers(Side::kLeft, sample, view);
  add_bumpers(Side::kRight, sample, view);
  SourceReport & switches = reports_[Source::kRiserSwitches];
  const bool both = sample.riser_left.is_closed() && sample.riser_right.is_closed();
  const Verdict pressed = heading_.add_switches(both, switches);
  switches.note(pressed);
  switch_conflict_ = pressed.outcome == Outcome::kGated;
  return verdict;
}

void PaperEstimator::add_bumpers(Side side, const ContactSample & sample, const LateralView & view)
{
  const bool left = side == Side::kLeft;
  SourceReport & report = reports_[left ? Source::kBumperLeft : Source::kBumperRight];
  std::optional<double> before;
  report.note(lateral_.add_bumpers(
    side, left ? sample.left : sample.right, sample.stamp, view, report, before));
  if (before) {
    left ? closure_.note_left(*before) : closure_.note_right(*before);
  }
}

Verdict PaperEstimator::add_ranges(const RangeSample & sample, Nanoseconds now)
{
  const Verdict verdict = admit(Source::kRanges, sample.stamp, now, Refusal::kNone);
  if (verdict.is_refused()) {
    return verdict;
  }
  block2_down_ = sample[Place::kBlock2Down];
  SourceReport & pair = reports_[Source::kFrontPair];
  pair.note(heading_.add_pair(
    sample[Place::kFrontLeft], sample[Place::kFrontRight], riser_ahead_of_beams(sample),
    travel_x_m_, pair));
  measure_x(sample.stamp);

  const LateralView view = lateral_view();
  SourceReport & left = reports_[Source::kSideLeft];
  SourceReport & right = reports_[Source::kSideRight];
  left.note(lateral_.add_range(Side::kLeft, sample[Place::kSideLeft], view, left));
  right.note(lateral_.add_range(Side::kRight, sample[Place::kSideRight], view, right));
  lateral_.choose(sample.stamp, view);
  refresh(sample.stamp);
  return verdict;
}

void PaperEstimator::tick(Nanoseconds now)
{
  silent_ = watch_.any_silent(now);
  if (watch_.is_silent(Source::kRanges, now)) {
    lateral_.choose(now, lateral_view());  // its averages have run out: the wheels predict
    refresh(now);
  } else {
    refresh(estimate_.stamp);
  }
}

LateralView PaperEstimator::lateral_view() const
{
  LateralView view;
  view.yaw_rad = heading_.yaw_rad();
  view.yaw_variance = heading_.variance();
  view.width_m = width_here_m();
  view.wall_left = flight_.spec().left == stetro_site::Side::kWalled;
  view.wall_right = flight_.spec().right == stetro_site::Side::kWalled;
  return view;
}

double PaperEstimator::width_here_m() const
{
  const int step = steps_.step().value_or(0);
  return flight_.width_m(step > 0 ? flight_.tread_centre_m(step) : 0.0);
}

std::optional<int> PaperEstimator::riser_ahead_of_beams(const RangeSample & sample) const
{
  const auto heights = steps_.heights_in_flight();
  if (
    !heights || sees_side_wall(Place::kFrontLeft, sample[Place::kFrontLeft]) ||
    sees_side_wall(Place::kFrontRight, sample[Place::kFrontRight])) {
    return std::nullopt;
  }
  const double beam_z_m = (*heights)[0] + robot_.at(Place::kFrontLeft).height_m;
  return riser_ahead(flight_, beam_z_m, params_.heading.nosing_margin_m);
}

// Beside a wall the cone of the outer beam takes the wall in and reads short, which looks like a
// turn: at contact, 1.5 cm from the wall, by tens of degrees.
bool PaperEstimator::sees_side_wall(Place front, const RangeReading & reading) const
{
  const auto y_m = lateral_.y_m();
  if (!y_m || reading.status != RangeStatus::kValid) {
    return false;
  }
  const auto & mount = robot_.at(front);
  const double yaw = heading_.yaw_rad();
  const double beam_y_m = *y_m + mount.x_m * std::sin(yaw) + mount.y_m * std::cos(yaw);
  const double reach_m =
    reading.range_m * std::tan(robot_.range_sensor.cone_rad / 2.0) + params_.heading.wall_margin_m;
  return beam_y_m < reach_m || width_here_m() - beam_y_m < reach_m;
}

// x_meas = x_riser - (d + mount) cos psi (D1-13): gives x on the floor, and doubts the step.
void PaperEstimator::measure_x(Nanoseconds stamp)
{
  const auto distance = heading_.riser_distance_m(stamp, travel_x_m_);
  const auto step = steps_.step();
  estimate_.measured_x_m.reset();
  if (!distance || !step) {
    outside_since_ = Nanoseconds{0};
    return;
  }
  const double reach_m = *distance + robot_.at(Place::kFrontLeft).x_m;
  const double x_m =
    flight_.riser_x_m(*heading_.riser_in_use()) - reach_m * std::cos(heading_.yaw_rad());
  estimate_.measured_x_m = x_m;
  foot_assumed_ = false;
  if (*step == 0) {
    floor_x_m_ = x_m;
    floor_travel_m_ = travel_x_m_;
  }
  const bool outside = *step > 0 && !steps_.block2_aloft() &&
                       (x_m < flight_.tread_start_m(*step) - kOutsideMargin ||
                        x_m > flight_.tread_end_m(*step) + kOutsideMargin);
  if (!outside) {
    outside_since_ = Nanoseconds{0};
  } else if (outside_since_ == Nanoseconds{0}) {
    outside_since_ = stamp;
  }
  outside_tread_ = outside && seconds(stamp - outside_since_) > kOutsideTime;
}

}  // namespace stetro_localizer
