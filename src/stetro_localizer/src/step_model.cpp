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

#include "stetro_localizer/step_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace stetro_localizer
{
namespace
{

using stetro_site::Place;

constexpr double kHeightSpan = 1.0;       // of a height that means nothing [m]
constexpr double kTravelSpan = 1.0;       // of a way that means nothing [m]
constexpr double kBeamMargin = 0.03;      // block3_front's cone below block 2 [m]
constexpr double kEndless = 1e3;          // depth of the floor and of the landing [m]
constexpr double kMovingAloft = 0.5;      // a block in the air moves or waits
constexpr double kLeastSeparation = 5.0;  // of a riser from none [standard deviations]

}  // namespace

StepModel::StepModel(
  const stetro_site::Flight & flight, const stetro_site::RobotGeometry & robot,
  const StepFilterParams & params)
: params_(params),
  tread_z_m_{0.0},
  tread_m_{kEndless},
  lowest_riser_m_(std::numeric_limits<double>::infinity()),
  block_length_m_(robot.block_length_m),
  switch_x_m_(robot.switch_x_m),
  stroke_m_(robot.stroke_m),
  reliable_range_m_(robot.range_sensor.reliable_range_m),
  down1_contact_m_(robot.contact_reading_m(Place::kBlock1Down)),
  down2_contact_m_(robot.contact_reading_m(Place::kBlock2Down)),
  block3_front_x_m_(robot.at(Place::kBlock3Front).x_m),
  block3_view_m_(robot.at(Place::kBlock3Front).height_m + kBeamMargin)
{
  for (int i = 1; i <= flight.steps(); ++i) {
    tread_z_m_.push_back(flight.tread_z_m(i));
    tread_m_.push_back(i < flight.steps() ? flight.tread_m(i) : kEndless);
    lowest_riser_m_ = std::min(lowest_riser_m_, flight.riser_m(i));
  }
  for (std::size_t i = 0; i < block_x_m_.size(); ++i) {
    block_x_m_[i] = robot.block_x_m(static_cast<int>(i) + 1);
  }
  if (lowest_riser_m_ < kLeastSeparation * params.height_sigma_m) {
    throw std::invalid_argument(
      "height_sigma_m: " + std::to_string(params.height_sigma_m) +
      " refused, accepted: at most a fifth of the lowest riser, " +
      std::to_string(lowest_riser_m_));
  }
}

double StepModel::rise_m(int from, int to) const { return tread_z_m(to) - tread_z_m(from); }

ReadingModel StepModel::range_at(double range_m) const
{
  const double sigma_m = std::hypot(params_.range_sigma_m, params_.range_sigma_per_m * range_m);
  return {sigma_m, params_.range_outlier, reliable_range_m_};
}

ReadingModel StepModel::travel_over(double way_m, double outlier) const
{
  const double sigma_m = std::hypot(params_.travel_sigma_m, params_.travel_sigma_per_m * way_m);
  return {sigma_m, outlier, kTravelSpan};
}

LiftWeights StepModel::weigh(int step, const LiftVotes & votes) const
{
  LiftWeights weights;
  weights.jump = params_.jump_prior * jump_weight(votes);
  for (int treads = -1; treads <= 1; ++treads) {
    const bool possible = votes.lift_seen || treads == 0;
    if (!possible || !has(step + treads)) {
      continue;
    }
    const double moved_prior = 0.5 * (1.0 - params_.stay_prior);
    const double prior = !votes.lift_seen ? 1.0 : treads == 0 ? params_.stay_prior : moved_prior;
    const double rise = rise_m(step, step + treads);
    const double over = prior * ground_density(rise, votes) * roll_density(step, treads, votes);
    const double closed =
      votes.switch_way_m && body_spans_a_riser(votes)
        ? switch_density(step + treads, step + votes.block1_above, *votes.switch_way_m)
        : 1.0;
    weights.landed[static_cast<std::size_t>(treads + 1)] =
      over * closed * standing_weight(rise, votes);
    weights.aloft +=
      over * hanging_weight(rise, votes) * (votes.switch_way_m ? 1.0 / kTravelSpan : 1.0);
  }
  return weights;
}

double StepModel::ground_density(double rise_m, const LiftVotes & votes) const
{
  return votes.ground_m ? range_at(stroke_m_).density(*votes.ground_m, {rise_m, rise_m}) : 1.0;
}

// Everything that tells how far the body has gone with block 2 aloft: equations (5) to (7).
double StepModel::roll_density(int step, int treads, const LiftVotes & votes) const
{
  if (!body_spans_a_riser(votes)) {
    return 1.0;  // on the floor or on the landing it may roll as far as it likes
  }
  double density = 1.0;
  if (votes.travel_m) {
    const double middle_m = treads * block_length_m_;
    const double half_m = 0.5 * block_length_m_;
    density *= travel_over(*votes.travel_m, params_.travel_outlier)
                 .density(*votes.travel_m, {middle_m - half_m, middle_m + half_m});
  }
  if (votes.front_m) {
    density *= front_density(step + treads, step + votes.block1_above, *votes.front_m);
  }
  if (votes.block3_front_m) {
    density *=
      block3_front_density(step - votes.block2_above, step + treads, *votes.block3_front_m);
  }
  return density;
}

double StepModel::front_density(int on, int block1_on, double front_m) const
{
  if (block1_on == 0) {
    return 1.0;  // the floor: the first riser may be anywhere ahead
  }
  const bool free = std::isinf(front_m);
  if (block1_on >= steps()) {
    return free ? 1.0 - params_.range_outlier : params_.range_outlier / reliable_range_m_;
  }
  if (free) {
    return params_.range_outlier;
  }
  const ReadingModel reading = range_at(front_m);
  const double tread = tread_m(block1_on);
  if (on == block1_on) {
    return reading.density(front_m, {tread - 0.5 * block_length_m_, tread});
  }
  if (on == block1_on - 1) {
    return reading.density(front_m, {tread + 0.5 * block_length_m_, tread + block_length_m_});
  }
  return reading.outlier / reading.span;
}

double StepModel::block3_front_density(int block3_on, int on, double range_m) const
{
  const ReadingModel reading = range_at(range_m);
  if (block3_on < 0 || block3_on >= steps() || on < block3_on || on > block3_on + 1) {
    return reading.outlier / reading.span;
  }
  const double half_m = 0.5 * block_length_m_;
  return on == block3_on
           ? reading.density(
               range_m, {half_m - block3_front_x_m_, block_length_m_ - block3_front_x_m_})
           : reading.density(range_m, {-half_m - block3_front_x_m_, -block3_front_x_m_});
}

double StepModel::switch_density(int on, int block1_on, double way_m) const
{
  const ReadingModel reading = travel_over(way_m, params_.switch_outlier);
  if (on >= steps() || on < block1_on - 1 || on > block1_on) {
    return reading.outlier / reading.span;  // no riser ahead that could close a switch
  }
  const double half_m = 0.5 * block_length_m_;
  if (on == block1_on - 1) {
    return reading.density(way_m, {half_m - switch_x_m_, block_length_m_ - switch_x_m_});
  }
  const double tread = tread_m(on);
  return reading.density(way_m, {tread - half_m - switch_x_m_, tread - switch_x_m_});
}

double StepModel::down_density(double clearance_m, const LiftVotes & votes) const
{
  if (!votes.down_m) {
    return 1.0;
  }
  const double expected_m = down2_contact_m_ + clearance_m;
  return range_at(expected_m).density(*votes.down_m, {expected_m, expected_m});
}

// Load and motion flag of a block 2 that stands.
double StepModel::contact_weight(const LiftVotes & votes) const
{
  const double load_right = 1.0 - params_.load_error;
  const double load = !votes.bearing ? 1.0 : *votes.bearing ? load_right : params_.load_error;
  return load * (votes.moving ? params_.motion_error : 1.0 - params_.motion_error);
}

double StepModel::standing_weight(double rise_m, const LiftVotes & votes) const
{
  const ReadingModel height{params_.height_sigma_m, params_.height_outlier, kHeightSpan};
  return 0.5 * height.density(votes.level_m, {rise_m, rise_m}) * contact_weight(votes) *
         down_density(0.0, votes);
}

// Most halts in the air are at the upper lock; the others are anywhere above the ground.
double StepModel::hanging_weight(double rise_m, const LiftVotes & votes) const
{
  const ReadingModel height{params_.height_sigma_m, params_.height_outlier, kHeightSpan};
  const double at_the_lock = height.density(votes.level_m, {stroke_m_, stroke_m_});
  const double anywhere = height.density(votes.level_m, {rise_m, std::max(rise_m, stroke_m_)});
  const double where = (1.0 - params_.halt_prior) * at_the_lock + params_.halt_prior * anywhere;
  const double load = !votes.bearing   ? 1.0
                      : *votes.bearing ? params_.load_error
                                       : 1.0 - params_.load_error;
  const double motion = votes.moving ? kMovingAloft : 1.0 - kMovingAloft;
  const double support = votes.others_lifted ? params_.support_error : 1.0;
  return 0.5 * where * load * motion * support *
         down_density(std::max(0.0, votes.level_m - rise_m), votes);
}

// Block 2 stands where no tread is, and nothing is known about where the body is.
double StepModel::jump_weight(const LiftVotes & votes) const
{
  double weight = contact_weight(votes) / kHeightSpan;
  const auto any_range = [&](const std::optional<double> & vote) {
    weight *= vote ? 1.0 / reliable_range_m_ : 1.0;
  };
  any_range(votes.ground_m);
  any_range(votes.down_m);
  if (body_spans_a_riser(votes)) {
    any_range(votes.block3_front_m);
    if (votes.front_m) {
      weight *= std::isinf(*votes.front_m) ? 0.5 : 0.5 / reliable_range_m_;
    }
    weight *= votes.travel_m ? 1.0 / kTravelSpan : 1.0;
    weight *= votes.switch_way_m ? 1.0 / kTravelSpan : 1.0;
  }
  return weight;
}

bool StepModel::fits(int step, const BlockPattern & pattern) const
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();  // equal to no height
  const double up_m = step < steps() ? rise_m(step, step + 1) : nothing;
  const double down_m = step > 0 ? rise_m(step - 1, step) : nothing;
  const auto same = [this](double a_m, double b_m) { return std::abs(a_m - b_m) <= tolerance_m(); };
  const double front_m = pattern.offset_m(0, 1);
  const double rear_m = pattern.offset_m(1, 2);
  const bool front_level = same(front_m, 0.0);
  const bool rear_level = same(rear_m, 0.0);
  const bool front_fits = !pattern.bearing[0] || front_level || same(front_m, up_m);
  const bool rear_fits = !pattern.bearing[2] || rear_level || same(rear_m, down_m);
  const bool on_a_tread = step > 0 && step < steps();
  const bool too_long = pattern.all_bear() && front_level && rear_level && on_a_tread;
  return pattern.bearing[1] && front_fits && rear_fits && !too_long;
}

}  // namespace stetro_localizer
