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

#ifndef STETRO_LOCALIZER__FLOOR_ESTIMATOR_HPP_
#define STETRO_LOCALIZER__FLOOR_ESTIMATOR_HPP_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/floor/floor_model.hpp"
#include "stetro_localizer/input_watch.hpp"
#include "stetro_localizer/pose_correction.hpp"
#include "stetro_localizer/sample_history.hpp"
#include "stetro_localizer/segment_estimator.hpp"

namespace stetro_localizer
{

/// Estimates the pose on the floors of a site by wheels, gyroscope and corrections.
/**
 * One filter for all floors: it is on one of them, or on none yet. Whichever estimator the flights
 * have, floors have this one. Ranges are looked at by nobody here; they only pace the answers.
 *
 * LOST while the pose was never known, and when corrections that agree with each other contradict
 * it; z is the floor's, or what a flight has handed over. What wheels and gyroscope cannot see, a
 * robot that is carried away, only corrections tell.
 *
 * Derivation: docs/derivations/floor_filter.md.
 */
class FloorEstimator : public SegmentEstimator
{
public:
  /// \throws std::invalid_argument naming the parameter, its value and what is accepted
  FloorEstimator(const LocalizerParams & params, const stetro_site::Site & site);
  FloorEstimator(const FloorEstimator &) = delete;  // the history refers to its model
  FloorEstimator & operator=(const FloorEstimator &) = delete;

  /// The floor that the next `begin` or `enter` is on, by its place in the site; -1: none yet.
  void choose(int floor) { chosen_ = floor; }

  void begin(const StateReading & stored) override;
  Verdict add_ranges(const RangeSample & sample, Nanoseconds now) override;
  Verdict add_contacts(const ContactSample & sample, Nanoseconds now) override;
  Verdict add_blocks(const BlockSample & sample, Nanoseconds now) override;
  Verdict add_gyro(const GyroSample & sample, Nanoseconds now) override;
  Verdict add_odometry(const OdometrySample & sample, Nanoseconds now) override;
  void tick(Nanoseconds now) override;
  std::optional<std::string> tell_pose(
    const stetro_site::Pose & pose, const stetro_site::Covariance & covariance) override;

  /// Judges a correction; `floor` is its place in the site.
  CorrectionOutcome take_correction(const PoseCorrection & correction, int floor, Nanoseconds now);

  [[nodiscard]] const Segment & segment() const override;
  [[nodiscard]] Legacy legacy() const override;
  /// Nothing while the pose is unknown, LOST or contradicted.
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
  [[nodiscard]] Refusal fault_of_stamp(Nanoseconds stamp, Nanoseconds now) const;
  Verdict take(Source input, const FloorSample & sample, Nanoseconds now, Refusal fault);
  Verdict note(Source input, Nanoseconds stamp, Nanoseconds now, Refusal fault);
  [[nodiscard]] FloorCore core_with_calibration(const StoredState & stored) const;
  [[nodiscard]] bool located() const { return now_.gate.trust() == CorrectionGate::Trust::kKnown; }
  void refresh(ResetCause cause = ResetCause::kNone);
  void refresh_pose();
  void refresh_protection();
  void refresh_integrity();

  LocalizerParams params_;
  std::vector<Segment> floors_;
  Segment nowhere_;
  FloorModel model_;
  SampleHistory<FloorModel> history_;
  FloorCore now_;  // the history's core at its time
  int chosen_ = -1;
  bool pose_told_ = false;  // the pose was known once on this floor, though it may be LOST now
  double z_m_ = 0.0;        // in the floor's frame
  double z_variance_ = 0.0;
  InputWatch watch_;
  SourceReports reports_;
  StairEstimate estimate_;
  StoredState stored_;  // calibration of what a floor does not use
  Nanoseconds last_fix_{0};
  std::array<Nanoseconds, kSourceCount> last_stamp_{};  // of inputs that are only watched
  std::array<double, 3> block_heights_m_{kUnknown, kUnknown, kUnknown};
  bool silent_ = false;
  std::uint32_t begin_reasons_ = kNotInitialised;
  std::uint32_t resets_counted_ = 0;  // of the core
  double risk_quantile_;  // standard deviations that an error exceeds at the integrity risk
};

/// Why a pose in a floor's frame cannot be told; nothing if it can.
[[nodiscard]] std::optional<std::string> implausible_on_floor(const stetro_site::Pose & pose);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR_ESTIMATOR_HPP_
