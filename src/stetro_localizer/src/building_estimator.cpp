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

#include "stetro_localizer/building_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_site/floor_speeds.hpp"

namespace stetro_localizer
{

BuildingEstimator::BuildingEstimator(const LocalizerSetup & setup)
: params_(setup.params),
  site_(setup.site),
  drawn_(site_.has_drawn_floor()),
  flights_(site_.flights().size()),
  floors_(params_, site_),
  present_(nullptr),
  correction_nis_(chi_square_3_quantile(params_.floor.gate_false_alarm))
{
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    const stetro_site::Flight & flight = site_.flights()[i];
    passages_.emplace_back(params_.floor, flight);
    if (drawn_ || flight.id() == setup.flight.id()) {
      flights_[i] = make_estimator(params_, setup.robot, flight, drawn_);
    }
  }
  flight_ = static_cast<std::size_t>(std::max(flight_named(setup.flight.id()), 0));
  present_ = flights_[flight_].get();
}

const stetro_site::Flight & BuildingEstimator::flight() const { return site_.flights()[flight_]; }

int BuildingEstimator::flight_named(const std::string & id) const
{
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    if (site_.flights()[i].id() == id) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

int BuildingEstimator::floor_named(const std::string & id) const
{
  for (std::size_t i = 0; i < site_.floors().size(); ++i) {
    if (site_.floors()[i].id == id) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

// One that takes part; -1: none of that name.
int BuildingEstimator::drawn_floor(const std::string & id) const
{
  const int floor = floor_named(id);
  return floor >= 0 && site_.floors()[static_cast<std::size_t>(floor)].is_drawn() ? floor : -1;
}

void BuildingEstimator::be_on_flight(int flight)
{
  flight_ = static_cast<std::size_t>(flight);
  present_ = flights_[flight_].get();
}

void BuildingEstimator::be_on_floor(int floor)
{
  floors_.choose(floor);
  present_ = &floors_;
}

// A robot that had been on a flight goes on there by its blocks. One that had been on a floor may
// be anywhere on it, and of one without history nobody knows more than the parameter says.
void BuildingEstimator::begin(const StateReading & stored)
{
  if (drawn_) {
    const bool found = stored.kind == StateReading::Kind::kFound;
    const bool damaged = stored.kind == StateReading::Kind::kDamaged;
    const std::string begin_at = damaged ? "" : params_.initial_segment;
    const std::string & id = found ? stored.state.segment_id : begin_at;
    const int flight = flight_named(id);
    if (flight >= 0) {
      be_on_flight(flight);
    } else {
      be_on_floor(drawn_floor(id));
    }
  }
  present_->begin(stored);
}

Verdict BuildingEstimator::add_ranges(const RangeSample & sample, Nanoseconds now)
{
  const Verdict verdict = present_->add_ranges(sample, now);
  if (drawn_ && !verdict.is_refused()) {
    hand_over();
  }
  return verdict;
}

Verdict BuildingEstimator::add_contacts(const ContactSample & sample, Nanoseconds now)
{
  const Verdict verdict = present_->add_contacts(sample, now);
  if (verdict.outcome == Outcome::kFused) {
    last_.note(sample);
  }
  return verdict;
}

Verdict BuildingEstimator::add_blocks(const BlockSample & sample, Nanoseconds now)
{
  const Verdict verdict = present_->add_blocks(sample, now);
  if (verdict.outcome == Outcome::kFused) {
    last_.note(sample);
  }
  return verdict;
}

Verdict BuildingEstimator::add_gyro(const GyroSample & sample, Nanoseconds now)
{
  const Verdict verdict = present_->add_gyro(sample, now);
  if (verdict.outcome == Outcome::kFused) {
    last_.note(sample);
  }
  return verdict;
}

Verdict BuildingEstimator::add_odometry(const OdometrySample & sample, Nanoseconds now)
{
  const Verdict verdict = present_->add_odometry(sample, now);
  if (verdict.outcome == Outcome::kFused) {
    last_.note(sample);
  }
  return verdict;
}

void BuildingEstimator::tick(Nanoseconds now) { present_->tick(now); }

std::vector<StepAsBuilt> BuildingEstimator::staircase_as_built() const
{
  return flights_[flight_]->staircase_as_built();
}

// A hand-over changes what is stored, too.
std::uint64_t BuildingEstimator::state_version() const
{
  return (crossings_ << 48) + present_->state_version();
}

void BuildingEstimator::hand_over() { on_floor() ? hand_over_to_flight() : hand_over_to_floor(); }

void BuildingEstimator::hand_over_to_flight()
{
  const StairEstimate & estimate = floors_.estimate();
  const bool doubted = foot_doubted_ || (estimate.reasons & kProfileDisagrees) != 0;
  if (estimate.integrity == Integrity::kLost || doubted) {
    return;
  }
  const stetro_site::Pose in_map = segment().T_map_segment.to_map(estimate.pose);
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    const bool from_here = site_.flights()[i].spec().lower_floor == segment().id;
    if (!from_here || !passages_[i].enters(in_map, estimate.covariance)) {
      continue;
    }
    if (const auto crossing = floors_.leave()) {
      be_on_flight(static_cast<int>(i));
      present_->enter(*crossing, last_);
      ++crossings_;
    }
    return;
  }
}

void BuildingEstimator::hand_over_to_floor()
{
  const StairEstimate & estimate = present_->estimate();
  const Passage & passage = passages_[flight_];
  if (!estimate.step) {
    return;
  }
  const bool back =
    (foot_doubted_ && *estimate.step == 0) || passage.retreats(*estimate.step, estimate.pose);
  if (!back && !passage.may_leave(*estimate.step, last_.block())) {
    return;
  }
  const stetro_site::FlightSpec & spec = flight().spec();
  const int floor = drawn_floor(back ? spec.lower_floor : spec.upper_floor);
  const auto crossing = present_->leave();
  if (floor >= 0 && crossing && (back || passage.leaves(crossing->pose))) {
    be_on_floor(floor);
    present_->enter(*crossing, last_);
    ++crossings_;
  }
}

// Whether a correction contradicts the pose on step 0: far off on the floor below, or on another.
bool BuildingEstimator::contradicts(const PoseCorrection & correction) const
{
  const StairEstimate & estimate = present_->estimate();
  const int floor = drawn_floor(correction.floor_id);
  if (
    on_floor() || estimate.step != 0 || floor < 0 ||
    correction.reset_counter != estimate.reset_counter) {
    return false;
  }
  if (flight().spec().lower_floor != correction.floor_id) {
    return true;
  }
  const auto crossing = present_->leave();
  if (!crossing) {
    return false;
  }
  const Segment below = segment_of(site_.floors()[static_cast<std::size_t>(floor)]);
  const stetro_site::Pose told = below.T_map_segment.to_map(correction.pose);
  const stetro_site::Covariance told_doubt = below.T_map_segment.to_map(correction.covariance);
  // The pose is of now, the correction of a while ago.
  const double age_s = std::abs(seconds(crossing->time - correction.stamp));
  const double moved_m = stetro_site::FloorSpeeds{}.roll_m_s * age_s;
  const double turned_rad = stetro_site::FloorSpeeds{}.turn_rad_s * age_s;
  FixInnovation innovation;
  innovation.value << told.x_m - crossing->pose.x_m, told.y_m - crossing->pose.y_m,
    stetro_site::wrap_angle(told.yaw_rad - crossing->pose.yaw_rad);
  innovation.covariance =
    crossing->covariance.topLeftCorner<3, 3>() + stetro_site::planar(told_doubt);
  innovation.covariance.diagonal() +=
    Eigen::Vector3d(moved_m * moved_m, moved_m * moved_m, turned_rad * turned_rad);
  return innovation.nis() > correction_nis_;
}

// What contradicts step 0 is not looked at twice: the robot is on the floor again, where others
// will tell, and on no flight before they have.
CorrectionOutcome BuildingEstimator::judge(const PoseCorrection & correction, Nanoseconds now)
{
  if (contradicts(correction)) {
    foot_doubted_ = true;
    return CorrectionOutcome::kGated;
  }
  if (!on_floor()) {
    return CorrectionOutcome::kNotOnFloor;
  }
  const int floor = drawn_floor(correction.floor_id);
  return floor < 0 ? CorrectionOutcome::kOtherFloor
                   : floors_.take_correction(correction, floor, now);
}

CorrectionOutcome BuildingEstimator::take_correction(
  const PoseCorrection & correction, Nanoseconds now)
{
  const CorrectionOutcome outcome = judge(correction, now);
  ++corrections_[static_cast<std::size_t>(outcome)];
  const bool found = outcome == CorrectionOutcome::kFused || outcome == CorrectionOutcome::kReset;
  foot_doubted_ = foot_doubted_ && !found;
  return outcome;
}

}  // namespace stetro_localizer
