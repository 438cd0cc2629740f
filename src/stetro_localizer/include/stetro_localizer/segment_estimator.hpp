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

#ifndef STETRO_LOCALIZER__SEGMENT_ESTIMATOR_HPP_
#define STETRO_LOCALIZER__SEGMENT_ESTIMATOR_HPP_

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "stetro_localizer/estimator.hpp"
#include "stetro_localizer/floor/floor_state.hpp"
#include "stetro_localizer/segment.hpp"
#include "stetro_site/site.hpp"

namespace stetro_localizer
{

/// The last samples of what changes seldom: a new estimator learns from them how the robot stands.
class LastSamples
{
public:
  void note(const BlockSample & sample) { blocks_[next_++ % blocks_.size()] = sample; }
  void note(const ContactSample & sample) { contacts_ = sample; }
  void note(const GyroSample & sample) { gyro_ = sample; }
  void note(const OdometrySample & sample) { wheels_ = sample; }

  /// The latest samples of the blocks in order; those with stamp zero are none.
  [[nodiscard]] std::array<BlockSample, 12> blocks() const
  {
    std::array<BlockSample, 12> ordered;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
      ordered[i] = blocks_[(next_ + i) % blocks_.size()];
    }
    return ordered;
  }
  [[nodiscard]] const BlockSample & block() const
  {
    return blocks_[(next_ + blocks_.size() - 1) % blocks_.size()];
  }
  [[nodiscard]] const ContactSample & contacts() const { return contacts_; }
  [[nodiscard]] const GyroSample & gyro() const { return gyro_; }
  [[nodiscard]] const OdometrySample & wheels() const { return wheels_; }

private:
  std::array<BlockSample, 12> blocks_;
  std::size_t next_ = 0;
  ContactSample contacts_;
  GyroSample gyro_;
  OdometrySample wheels_;
};

/// What an estimator goes on with that does not know where it is.
struct Legacy
{
  StoredState calibration;  ///< the constant errors; its step means nothing here
  std::uint32_t reset_counter = 0;
  ResetCause reset_cause = ResetCause::kNone;
  stetro_site::Pose reset_delta;
  SourceReports reports;
  Nanoseconds stamp{0};  ///< of the last estimate: the next is not earlier
};

/// A pose that is handed from the estimator of one segment to that of the next.
struct Crossing
{
  Nanoseconds time{0};
  stetro_site::Pose pose;  ///< base_link in `map`
  /// Errors of gyroscope and wheels, beside x, y and heading in `map`.
  FloorVector state = FloorVector::Zero();
  FloorMatrix covariance = FloorMatrix::Zero();  ///< of `state`, position in the axes of `map`
  double z_variance = 0.0;                       ///< [m^2]
  Legacy legacy;
};

/// Estimates the pose on one segment, and hands it over to the next segment's estimator.
/** The pose in `map` is the same before and after, and so is its covariance: no jump, no reset. */
class SegmentEstimator : public Estimator
{
public:
  [[nodiscard]] virtual const Segment & segment() const = 0;

  /// What goes on in the next segment whatever the pose.
  [[nodiscard]] virtual Legacy legacy() const = 0;

  /// The pose as it is now; nothing while it is unknown.
  [[nodiscard]] virtual std::optional<Crossing> leave() const = 0;

  /// Begins anew at a pose: on a flight it must be of the floor below, step 0.
  virtual void enter(const Crossing & crossing, const LastSamples & last) = 0;

  /// Begins anew without a pose.
  virtual void enter(const Legacy & legacy) = 0;
};

/// What an estimate hands on whatever its pose.
[[nodiscard]] Legacy legacy_of(
  const StairEstimate & estimate, const SourceReports & reports, const StoredState & stored);

/// Writes what it hands on into the estimate of the next segment.
void take_over(StairEstimate & estimate, const Legacy & legacy);

/// The estimator of flights that the parameters name.
/** \param floors_drawn it begins and ends on floors that the localizer knows */
[[nodiscard]] std::unique_ptr<SegmentEstimator> make_estimator(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight, bool floors_drawn = false);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SEGMENT_ESTIMATOR_HPP_
