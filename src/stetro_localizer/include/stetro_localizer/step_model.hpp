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

#ifndef STETRO_LOCALIZER__STEP_MODEL_HPP_
#define STETRO_LOCALIZER__STEP_MODEL_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_config/rule.hpp"
#include "stetro_localizer/step_counter.hpp"
#include "stetro_localizer/step_evidence.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// How the step filter doubts. Standard deviations are of the devices, uncalibrated.
struct StepFilterParams
{
  double publish_probability = 0.999;  ///< a less probable step is not published [-]
  double lost_probability = 0.5;       ///< of an impossible change, from which on it is lost [-]
  double stay_prior = 0.1;             ///< of a lift cycle that ends on its own tread [-]
  double halt_prior = 0.1;             ///< halts in the air that are not at the upper lock [-]
  double jump_prior = 1e-3;            ///< of a change that no lift cycle makes [-]
  double unseen_prior = 0.05;          ///< of a climb, or a descent, while nothing was seen [-]

  double height_sigma_m = 0.004;     ///< level of a block against a tread's, as built [m]
  double height_outlier = 1e-5;      ///< share of lift heights that mean nothing [-]
  double range_sigma_m = 0.012;      ///< ToF offset and noise at no distance [m]
  double range_sigma_per_m = 0.03;   ///< ToF gain, added in squares [m/m]
  double range_outlier = 0.05;       ///< share of ToF readings that mean nothing [-]
  double travel_sigma_m = 0.015;     ///< slips of a usual roll [m]
  double travel_sigma_per_m = 0.03;  ///< wheel scale, added in squares [m/m]
  double travel_outlier = 0.05;      ///< share of rolls that slip all the way [-]
  double switch_outlier = 0.02;      ///< share of switch closures that mean nothing [-]
  double load_error = 0.005;         ///< share of touch-downs with a wrong load [-]
  double motion_error = 0.02;        ///< share of touch-downs with a wrong motion flag [-]
  double support_error = 1e-5;       ///< of block 1 or 3 being lifted while block 2 is aloft [-]

  double bearing_load = 0.05;       ///< share of the weight from which on a block stands [-]
  double lift_off_m = 0.01;         ///< a block that moved by this has left its place [m]
  double still_m = 0.003;           ///< heights that stay within this are settled [m]
  double settle_s = 0.09;           ///< for so long [s]
  double tolerance_share = 0.25;    ///< of the lowest riser: heights of one tread [-]
  double down_tolerance_m = 0.025;  ///< block2_down may exceed its contact reading by this [m]
  double conflict_s = 1.0;          ///< contradicting evidence of this duration is reported [s]
  double restless_s = 10.0;         ///< heights unsettled for longer say nothing any more [s]
  double gap_s = 0.5;               ///< a longer silence of the blocks may have hidden a climb [s]
};

/// How well each outcome of a lift cycle from one step explains the votes; not normalised.
struct LiftWeights
{
  std::array<double, 3> landed{};  ///< one tread lower, on the old one, one higher
  double aloft = 0.0;              ///< block 2 is still in the air
  double jump = 0.0;               ///< none of these

  [[nodiscard]] double sum() const { return landed[0] + landed[1] + landed[2] + aloft + jump; }
};

/// The stairs, the body and the doubt of each sensor, as the step filter needs them.
/**
 * Geometry behind the intervals (docs/derivations/step_filter.md): of three blocks of length L in a
 * row, each with its centre over the tread it stands on and its front behind the next riser. A
 * riser between blocks 1 and 2 is then L/2 to L ahead of base_link, one between blocks 2 and 3 is 0
 * to L/2 behind it.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class StepModel
{
public:
  /// \throws std::invalid_argument if the lowest riser is less than five height_sigma_m
  StepModel(
    const stetro_site::Flight & flight, const stetro_site::RobotGeometry & robot,
    const StepFilterParams & params);

  [[nodiscard]] const StepFilterParams & params() const { return params_; }
  [[nodiscard]] int steps() const { return static_cast<int>(tread_z_m_.size()) - 1; }
  [[nodiscard]] bool has(int step) const { return step >= 0 && step <= steps(); }
  [[nodiscard]] double tread_z_m(int step) const  ///< height of an existing tread [m]
  {
    return tread_z_m_[static_cast<std::size_t>(step)];
  }
  /// Depth of an existing tread; of the floor and of the last: without end [m].
  [[nodiscard]] double tread_m(int step) const { return tread_m_[static_cast<std::size_t>(step)]; }
  [[nodiscard]] double block_length_m() const { return block_length_m_; }
  [[nodiscard]] double down1_contact_m() const { return down1_contact_m_; }
  [[nodiscard]] double down2_contact_m() const { return down2_contact_m_; }
  [[nodiscard]] double block_x_m(std::size_t block) const { return block_x_m_[block]; }
  /// Block 2 must be this much above block 3 to let `block3_front` look below it [m].
  [[nodiscard]] double block3_view_m() const { return block3_view_m_; }
  [[nodiscard]] double lowest_riser_m() const { return lowest_riser_m_; }
  /// Heights that may belong to one tread [m].
  [[nodiscard]] double tolerance_m() const { return params_.tolerance_share * lowest_riser_m_; }

  /// Weighs every outcome of a lift cycle that began on an existing `step`, equations (3) to (9).
  [[nodiscard]] LiftWeights weigh(int step, const LiftVotes & votes) const;

  /// Blocks at rest may stand so while block 2 is on that step.
  /**
   * Block 3 stands on the same tread as block 2 or one lower, block 1 on the same or one higher;
   * all three on one tread only where there is room for a body longer than a tread.
   */
  [[nodiscard]] bool fits(int step, const BlockPattern & pattern) const;

private:
  [[nodiscard]] double rise_m(int from, int to) const;
  [[nodiscard]] ReadingModel range_at(double range_m) const;
  [[nodiscard]] ReadingModel travel_over(double way_m, double outlier) const;
  [[nodiscard]] double ground_density(double rise_m, const LiftVotes & votes) const;
  [[nodiscard]] double roll_density(int step, int treads, const LiftVotes & votes) const;
  [[nodiscard]] double front_density(int on, int block1_on, double front_m) const;
  [[nodiscard]] double block3_front_density(int block3_on, int on, double range_m) const;
  [[nodiscard]] double switch_density(int on, int block1_on, double way_m) const;
  [[nodiscard]] double down_density(double clearance_m, const LiftVotes & votes) const;
  [[nodiscard]] double contact_weight(const LiftVotes & votes) const;
  [[nodiscard]] double standing_weight(double rise_m, const LiftVotes & votes) const;
  [[nodiscard]] double hanging_weight(double rise_m, const LiftVotes & votes) const;
  [[nodiscard]] double jump_weight(const LiftVotes & votes) const;
  [[nodiscard]] bool body_spans_a_riser(const LiftVotes & votes) const
  {
    return votes.block1_above != 0 || votes.block2_above != 0;
  }

  StepFilterParams params_;
  std::vector<double> tread_z_m_;  // of step 0..N
  std::vector<double> tread_m_;    // of step 0..N
  double lowest_riser_m_ = 0.0;
  double block_length_m_;
  double switch_x_m_;
  double stroke_m_;
  double reliable_range_m_;
  double down1_contact_m_;
  double down2_contact_m_;
  double block3_front_x_m_;
  double block3_view_m_;
  std::array<double, 3> block_x_m_{};
};

/// The list of StepFilterParams, see stetro_config/field.hpp.
template <class Visitor>
void visit_step_filter(StepFilterParams & p, Visitor && each)
{
  using stetro_config::Within;
  each("publish_probability", p.publish_probability, Within{0.9, 0.999999}, "of a published step");
  each("lost_probability", p.lost_probability, Within{0.01, 0.99}, "of an impossible change");
  each("stay_prior", p.stay_prior, Within{1e-3, 0.9}, "lift cycles that end on their own tread");
  each("halt_prior", p.halt_prior, Within{1e-3, 1.0}, "halts in the air below the upper lock");
  each("jump_prior", p.jump_prior, Within{1e-9, 0.1}, "changes that no lift cycle makes");
  each("unseen_prior", p.unseen_prior, Within{1e-3, 0.3}, "climbs while nothing was seen");
  each("height_sigma_m", p.height_sigma_m, Within{1e-4, 0.02}, "block against tread, as built [m]");
  each("height_outlier", p.height_outlier, Within{1e-12, 0.1}, "heights that mean nothing");
  each("range_sigma_m", p.range_sigma_m, Within{1e-4, 0.1}, "ToF offset and noise [m]");
  each("range_sigma_per_m", p.range_sigma_per_m, Within{0.0, 0.2}, "ToF gain, in squares [m/m]");
  each("range_outlier", p.range_outlier, Within{1e-6, 0.5}, "ToF readings that mean nothing");
  each("travel_sigma_m", p.travel_sigma_m, Within{1e-4, 0.1}, "slips of a usual roll [m]");
  each("travel_sigma_per_m", p.travel_sigma_per_m, Within{0.0, 0.5}, "wheel scale [m/m]");
  each("travel_outlier", p.travel_outlier, Within{1e-6, 0.5}, "rolls that slip all the way");
  each("switch_outlier", p.switch_outlier, Within{1e-6, 0.5}, "closures that mean nothing");
  each("load_error", p.load_error, Within{1e-6, 0.5}, "touch-downs with a wrong load");
  each("motion_error", p.motion_error, Within{1e-6, 0.5}, "touch-downs with a wrong motion flag");
  each("support_error", p.support_error, Within{1e-12, 0.1}, "block 1 or 3 up while 2 is aloft");
  each("bearing_load", p.bearing_load, Within{0.001, 0.5}, "share of the weight of a block");
  each("lift_off_m", p.lift_off_m, Within{0.002, 0.05}, "a block has left its place [m]");
  each("still_m", p.still_m, Within{5e-4, 0.02}, "heights within this are settled [m]");
  each("settle_s", p.settle_s, Within{0.0, 2.0}, "for so long [s]");
  each("tolerance_share", p.tolerance_share, Within{0.05, 0.45}, "same tread, of the riser");
  each("down_tolerance_m", p.down_tolerance_m, Within{0.001, 0.1}, "block2_down at contact [m]");
  each("conflict_s", p.conflict_s, Within{0.1, 60.0}, "contradiction that is reported [s]");
  each("restless_s", p.restless_s, Within{1.0, 60.0}, "heights that do not settle [s]");
  each("gap_s", p.gap_s, Within{0.05, 60.0}, "silence that may have hidden a climb [s]");
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STEP_MODEL_HPP_
