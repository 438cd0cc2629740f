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

#ifndef STETRO_LOCALIZER__FUSED_ESTIMATOR_HPP_
#define STETRO_LOCALIZER__FUSED_ESTIMATOR_HPP_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/fused/as_built_record.hpp"
#include "stetro_localizer/fused/closure_watch.hpp"
#include "stetro_localizer/fused/fused_model.hpp"
#include "stetro_localizer/fused/history.hpp"
#include "stetro_localizer/fused/range_watch.hpp"
#include "stetro_localizer/fused/switch_watch.hpp"
#include "stetro_localizer/input_watch.hpp"
#include "stetro_localizer/segment_estimator.hpp"

namespace stetro_localizer
{

/// The default: every sensor in one error-state Kalman filter that calibrates itself.
/**
 * Each sample counts at its own time, late ones too, and corrects with the covariance of all that
 * is unknown: pose, speed, the errors of gyroscope, wheels and range sensors, and the staircase as
 * built. At each wall contact the distance to that wall is known, which calibrates the sensor that
 * sees it; the opposite one and the wheels follow through the filter.
 *
 * From the first ranges on there is an estimate upon each array of them, and whenever wheels and
 * gyroscope have both told of a later time: between two arrays a body that slips moves by 4 mm.
 *
 * Derivation: docs/derivations/fused_estimator.md.
 */
class FusedEstimator : public SegmentEstimator
{
public:
  /// \param floors_drawn no wall is missed where it ends: the robot comes from a floor and knows y
  /// \throws std::invalid_argument naming the parameter, its value and what is accepted
  FusedEstimator(
    const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
    const stetro_site::Flight & flight, bool floors_drawn = false);

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
  [[nodiscard]] std::vector<StepAsBuilt> staircase_as_built() const override;
  [[nodiscard]] StoredState state_to_store() const override;
  [[nodiscard]] std::uint64_t state_version() const override;

private:
  [[nodiscard]] Verdict take(Source input, const Sample & sample, Nanoseconds now, Refusal fault);
  [[nodiscard]] Refusal fault_of_stamp(Nanoseconds stamp, Nanoseconds now) const;
  [[nodiscard]] RangeSample new_readings(const RangeSample & sample);
  void watch_devices(const Sample & sample);
  void follow_motion(Nanoseconds & newest, Nanoseconds stamp);
  void refresh(ResetCause cause = ResetCause::kNone);
  [[nodiscard]] ResetCause jumped(std::optional<int> step_before);
  void refresh_position();
  [[nodiscard]] StateVector slopes_along() const;
  void refresh_covariance();
  void refresh_protection();
  void refresh_integrity();
  [[nodiscard]] bool recent(Ranger ranger) const;  ///< it corrected a moment ago
  [[nodiscard]] std::uint32_t sensor_reasons() const;
  [[nodiscard]] std::uint32_t conflict_reasons() const;
  [[nodiscard]] std::uint32_t pose_reasons() const;
  [[nodiscard]] bool off_tread() const;
  [[nodiscard]] bool wall_missed() const;  ///< none is seen although one should be

  LocalizerParams params_;
  stetro_site::Flight flight_;
  Segment segment_;
  bool floors_drawn_;  // the flight ends there for the estimator, as its walls do
  FusedModel model_;
  History history_;
  AsBuiltRecord as_built_;
  InputWatch watch_;
  RangeWatch ranges_;
  SwitchWatch switches_;
  ClosureWatch closure_;
  SourceReports reports_;
  StairEstimate estimate_;
  std::array<Nanoseconds, stetro_site::kPlaces.size()> last_reading_{};
  Nanoseconds last_array_{0};
  Nanoseconds rolled_until_{0};  // the newest sample of the wheels
  Nanoseconds turned_until_{0};  // and of the gyroscope
  bool silent_ = false;
  std::uint32_t begin_reasons_ = 0;  // what the state file left to say
  std::uint32_t jumps_counted_ = 0;  // of the core, in the reset counter
  bool located_once_ = false;        // by itself or told: the next time is another time
  double front_edge_m_;              // of block 2 from base_link
  double risk_quantile_;  // standard deviations that an error exceeds at the integrity risk
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED_ESTIMATOR_HPP_
