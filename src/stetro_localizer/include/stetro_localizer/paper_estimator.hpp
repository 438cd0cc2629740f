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

#ifndef STETRO_LOCALIZER__PAPER_ESTIMATOR_HPP_
#define STETRO_LOCALIZER__PAPER_ESTIMATOR_HPP_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/contact_closure.hpp"
#include "stetro_localizer/heading.hpp"
#include "stetro_localizer/input_watch.hpp"
#include "stetro_localizer/lateral.hpp"
#include "stetro_localizer/segment_estimator.hpp"
#include "stetro_localizer/stamp_guard.hpp"
#include "stetro_localizer/standstill.hpp"
#include "stetro_localizer/step_counter.hpp"

namespace stetro_localizer
{

/// The method of S-A and S-B, Algorithm I, with its faults mended: the yardstick.
/**
 * Each cycle of ranges, on step i with tread t and riser r (sums of them if they differ, D1-10):
 *
 *   x   = (i - 1/2) t                  eq. (1); on the floor, step 0, from the front pair
 *   y   = from the side ranges         eq. (1) and the 120 cm rule, see Lateral (D1-4, D1-5)
 *   z   = i r                          eq. (1)
 *   psi = atan2(d_left - d_right, D)   eq. (2), see Heading (D1-6, D1-7, D1-16)
 *   i   = readStep()                   see StepCounter (D1-12, D3-14)
 *
 * x is the centre of the tread by the papers' choice, while a sweeping robot of this body stands
 * 0.075 m further: a constant offset that is stated here and in the covariance, not hidden. The
 * measured x of D1-13 is given beside it and serves to doubt the step.
 *
 * On the last tread the way since the touch-down tells when the robot is on the floor beyond; x is
 * then taken from it, so that the pose moves by up to a tread at that hand-over.
 *
 * Ours, not the papers': offsets learned at the walls, wheels and gyroscope where nothing is seen,
 * covariance, integrity, restart. Derivation: docs/derivations/paper_estimator.md.
 */
class PaperEstimator : public SegmentEstimator
{
public:
  /// \throws std::invalid_argument naming the parameter, its value and what is accepted
  PaperEstimator(
    const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
    const stetro_site::Flight & flight);

  void begin(const StateReading & stored) override;
  Verdict add_ranges(const RangeSample & sample, Nanoseconds now) override;
  Verdict add_contacts(const ContactSample & sample, Nanoseconds now) override;
  Verdict add_blocks(const BlockSample & sample, Nanoseconds now) override;
  Verdict add_gyro(const GyroSample & sample, Nanoseconds now) override;
  Verdict add_odometry(const OdometrySample & sample, Nanoseconds now) override;
  void tick(Nanoseconds now) override;
  std::optional<std::string> tell_pose(
    const stetro_site::Pose & pose, const stetro_site::Covariance & covariance) override;

  [[nodiscard]] const Segment & segment() const override { return segment_; }
  [[nodiscard]] Legacy legacy() const override;
  [[nodiscard]] std::optional<Crossing> leave() const override;
  void enter(const Crossing & crossing, const LastSamples & last) override;
  void enter(const Legacy & legacy) override;

  [[nodiscard]] const StairEstimate & estimate() const override { return estimate_; }
  [[nodiscard]] const SourceReports & reports() const override { return reports_; }
  [[nodiscard]] const std::vector<Source> & compared() const override;
  [[nodiscard]] std::vector<Bias> biases() const override;
  [[nodiscard]] StoredState state_to_store() const override;
  [[nodiscard]] std::uint64_t state_version() const override;

private:
  [[nodiscard]] Verdict admit(Source input, Nanoseconds stamp, Nanoseconds now, Refusal fault);
  [[nodiscard]] LateralView lateral_view() const;
  [[nodiscard]] double width_here_m() const;
  [[nodiscard]] std::optional<int> riser_ahead_of_beams(const RangeSample & sample) const;
  [[nodiscard]] bool sees_side_wall(Place front, const RangeReading & reading) const;
  [[nodiscard]] std::optional<double> block2_down_m(Nanoseconds now) const;
  void add_bumpers(Side side, const ContactSample & sample, const LateralView & view);
  void take_step_event(StepEvent event);
  void measure_x(Nanoseconds stamp);
  void refresh(Nanoseconds stamp);
  void refresh_position();
  void refresh_covariance();
  void refresh_integrity();
  void count_resets(const stetro_site::Pose & before);
  [[nodiscard]] ResetCause jumped();

  LocalizerParams params_;
  stetro_site::RobotGeometry robot_;
  stetro_site::Flight flight_;
  Segment segment_;
  std::array<StampGuard, kSourceCount> guards_;
  InputWatch watch_;
  Standstill standstill_;
  Heading heading_;
  Lateral lateral_;
  StepCounter steps_;
  ContactClosure closure_;
  SourceReports reports_;
  StairEstimate estimate_;

  RangeReading block2_down_;       // the last one; it counts while it is young
  double travel_x_m_ = 0.0;        // by the wheels, along the flight
  double floor_x_m_ = kUnknown;    // x on step 0 when it was last measured
  double floor_travel_m_ = 0.0;    // travel_x_m_ at that time
  double climbed_travel_m_ = 0.0;  // travel_x_m_ when block 2 last came down a step higher
  Nanoseconds outside_since_{0};   // x was first measured off the tread; zero: it is on it
  bool outside_tread_ = false;
  std::optional<int> told_step_;  // where it stands, until the blocks have agreed or not
  bool foot_assumed_ = false;     // step 0 rests on level blocks alone
  bool silent_ = false;
  bool switch_conflict_ = false;
  std::uint32_t step_reasons_ = kNotInitialised;  // while the step is unknown

  struct Jumps
  {
    std::uint32_t told = 0;
    std::uint32_t undone = 0;  // steps
    std::uint32_t across = 0;  // y was measured anew
    std::uint32_t heading = 0;
  };
  Jumps jumps_;          // so far
  Jumps jumps_counted_;  // of them, in the reset counter
  std::uint64_t step_changes_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__PAPER_ESTIMATOR_HPP_
