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

#ifndef STETRO_LOCALIZER__BUILDING_ESTIMATOR_HPP_
#define STETRO_LOCALIZER__BUILDING_ESTIMATOR_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/floor/passage.hpp"
#include "stetro_localizer/floor_estimator.hpp"
#include "stetro_localizer/localizer_setup.hpp"
#include "stetro_localizer/segment_estimator.hpp"

namespace stetro_localizer
{

/// Why a told pose is not taken.
struct RefusedPose
{
  const char * reason;  ///< one word, for counters
  std::string detail;   ///< for a person
};

/// Estimates the pose throughout the building: one estimator for each flight, one for the floors.
/**
 *   floor  --(at the foot of a flight, see Passage)--------------> flight   step 0
 *   flight --(turned back on step 0)-----------------------------> floor below
 *   flight --(a correction contradicts the pose on step 0)-------> floor below, until others agree
 *   flight --(stands level at the end of the last step)----------> floor above
 *   any    --(told)----------------------------------------------> the segment that was named
 *
 * Only floors that are drawn take part: where nobody has drawn the floors, it is the estimator of
 * one flight and nothing else. The pose in `map` does not jump at a hand-over and the reset counter
 * goes on. All estimators are made at construction; of `paper` alone a hand-over allocates.
 */
class BuildingEstimator : public Estimator
{
public:
  explicit BuildingEstimator(const LocalizerSetup & setup);
  BuildingEstimator(const BuildingEstimator &) = delete;
  BuildingEstimator & operator=(const BuildingEstimator &) = delete;

  void begin(const StateReading & stored) override;
  Verdict add_ranges(const RangeSample & sample, Nanoseconds now) override;
  Verdict add_contacts(const ContactSample & sample, Nanoseconds now) override;
  Verdict add_blocks(const BlockSample & sample, Nanoseconds now) override;
  Verdict add_gyro(const GyroSample & sample, Nanoseconds now) override;
  Verdict add_odometry(const OdometrySample & sample, Nanoseconds now) override;
  void tick(Nanoseconds now) override;
  std::optional<std::string> tell_pose(
    const stetro_site::Pose & pose, const stetro_site::Covariance & covariance) override;

  /// Takes a pose in `map`, or in the frame of a floor or flight, which it then is on.
  /** In `map` the segment is the only one at that height that has the place: else it is refused. */
  std::optional<RefusedPose> tell_pose(
    const std::string & frame_id, const stetro_site::Pose & pose,
    const stetro_site::Covariance & covariance);

  /// Judges a correction and counts its outcome.
  CorrectionOutcome take_correction(const PoseCorrection & correction, Nanoseconds now);

  [[nodiscard]] const Segment & segment() const { return present_->segment(); }
  /// The flight that the robot is on, was on last, or begins with.
  [[nodiscard]] const stetro_site::Flight & flight() const;
  /// Corrections so far, by `CorrectionOutcome`.
  [[nodiscard]] const std::array<std::uint64_t, kCorrectionOutcomes> & corrections() const
  {
    return corrections_;
  }
  [[nodiscard]] std::uint64_t crossings() const { return crossings_; }

  [[nodiscard]] const StairEstimate & estimate() const override { return present_->estimate(); }
  [[nodiscard]] const SourceReports & reports() const override { return present_->reports(); }
  [[nodiscard]] const std::vector<Source> & compared() const override
  {
    return present_->compared();
  }
  [[nodiscard]] std::vector<Bias> biases() const override { return present_->biases(); }
  [[nodiscard]] std::vector<StepAsBuilt> staircase_as_built() const override;
  [[nodiscard]] StoredState state_to_store() const override { return present_->state_to_store(); }
  [[nodiscard]] std::uint64_t state_version() const override;

private:
  [[nodiscard]] bool on_floor() const { return present_ == &floors_; }
  [[nodiscard]] int floor_named(const std::string & id) const;
  [[nodiscard]] int drawn_floor(const std::string & id) const;
  [[nodiscard]] int flight_named(const std::string & id) const;
  void be_on_flight(int flight);
  void be_on_floor(int floor);
  void hand_over();
  void hand_over_to_flight();
  void hand_over_to_floor();
  [[nodiscard]] bool contradicts(const PoseCorrection & correction) const;
  CorrectionOutcome judge(const PoseCorrection & correction, Nanoseconds now);
  [[nodiscard]] std::string accepted_frames() const;
  std::optional<RefusedPose> find_segment(const stetro_site::Pose & in_map, std::string & id) const;
  [[nodiscard]] bool stands_on(
    const stetro_site::Floor & floor, const stetro_site::Pose & in_map) const;

  LocalizerParams params_;
  stetro_site::Site site_;
  bool drawn_;                                              // floors take part
  std::vector<std::unique_ptr<SegmentEstimator>> flights_;  // those that may be climbed
  std::vector<Passage> passages_;                           // of each
  FloorEstimator floors_;
  SegmentEstimator * present_;
  std::size_t flight_ = 0;  // present, last or first
  LastSamples last_;
  bool foot_doubted_ = false;  // a correction has contradicted step 0, none has been believed since
  double correction_nis_;      // a correction beyond it contradicts the pose
  std::array<std::uint64_t, kCorrectionOutcomes> corrections_{};
  std::uint64_t crossings_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__BUILDING_ESTIMATOR_HPP_
