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

#ifndef STETRO_LOCALIZER__ESTIMATOR_HPP_
#define STETRO_LOCALIZER__ESTIMATOR_HPP_

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_localizer/integrity.hpp"
#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_localizer/reset_cause.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/staircase_as_built.hpp"
#include "stetro_localizer/state_file.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
/// An error beyond its protection level counts once it has lasted for longer than this [s].
constexpr double kTimeToAlert_s = 1.0;

/// Where the robot is on its segment, a flight or a floor. Numbers that are not known are NaN.
struct StairEstimate
{
  Nanoseconds stamp{0};                ///< time it is for; never runs backwards
  std::optional<int> step;             ///< tread block 2 stands on, 0 on a floor
  double step_probability = kUnknown;  ///< of `step`, if the method knows one
  stetro_site::Pose pose{kUnknown, kUnknown, kUnknown, kUnknown};        ///< in the segment's frame
  stetro_site::Covariance covariance = stetro_site::Covariance::Zero();  ///< of the pose
  /// The same relative to the tread and the riser ahead: what is measured here, without the doubt
  /// of the treads and risers below.
  stetro_site::Covariance tread_covariance = stetro_site::Covariance::Zero();
  double tread_x_m = kUnknown;      ///< from the tread's own riser [m]
  double riser_ahead_m = kUnknown;  ///< from base_link along x to the next riser's face [m]
  double tread_y_m = kUnknown;      ///< from the right wall [m]
  std::array<double, 3> block_heights_m{kUnknown, kUnknown, kUnknown};  ///< in the flight frame
  Integrity integrity = Integrity::kLost;
  std::uint32_t reasons = kNotInitialised;   ///< bits of `Reason`
  double protection_along_m = kUnknown;      ///< level of the error of x, at `integrity_risk` [m]
  double protection_across_m = kUnknown;     ///< of y [m]
  double protection_heading_rad = kUnknown;  ///< [rad]
  /// Probability per step that the error of x, y or heading exceeds its protection level for longer
  /// than 1 s (`kTimeToAlert_s`) while the state is OK.
  double integrity_risk = kUnknown;
  std::uint32_t reset_counter = 0;  ///< jumps of the estimate, those before a restart too
  ResetCause reset_cause = ResetCause::kNone;  ///< why it jumped last
  stetro_site::Pose reset_delta;            ///< how far it jumped; NaN where it was unknown before
  std::optional<double> measured_x_m;       ///< x by the front pair (D1-13) [m]
  std::optional<double> contact_closure_m;  ///< eq. (3) of this tread [m]
};

/// A constant error that the estimator learns.
struct Bias
{
  const char * name;        ///< of the sensor or source; a gain's ends in `_gain`
  ScalarEstimate estimate;  ///< [m]; [rad/s] for the gyroscope; a share for a gain or a scale
};

/// Estimates the pose on a segment of the building from samples that each carry their time.
/**
 * Samples may come in any order between kinds and must be in order within a kind. `now` is the
 * reader's time at which the sample is looked at: stamps are refused against it, silence is counted
 * on it. A refused sample changes nothing but its count. No clock is read, nothing throws, and no
 * memory is allocated while samples are taken. One thread.
 */
class Estimator
{
public:
  virtual ~Estimator() = default;

  /// Begins from what the state file gave; call it once, before the first sample.
  virtual void begin(const StateReading & stored) = 0;

  virtual Verdict add_ranges(const RangeSample & sample, Nanoseconds now) = 0;
  virtual Verdict add_contacts(const ContactSample & sample, Nanoseconds now) = 0;
  virtual Verdict add_blocks(const BlockSample & sample, Nanoseconds now) = 0;
  virtual Verdict add_gyro(const GyroSample & sample, Nanoseconds now) = 0;
  virtual Verdict add_odometry(const OdometrySample & sample, Nanoseconds now) = 0;

  /// Lets time pass: notices inputs that have stopped, and predicts while there are no ranges.
  virtual void tick(Nanoseconds now) = 0;

  /// Takes a pose in the segment's frame that an operator tells.
  /** \return nothing if it was taken, otherwise why not */
  virtual std::optional<std::string> tell_pose(
    const stetro_site::Pose & pose, const stetro_site::Covariance & covariance) = 0;

  [[nodiscard]] virtual const StairEstimate & estimate() const = 0;
  [[nodiscard]] virtual const SourceReports & reports() const = 0;

  /// The sources that it compares with an expectation of its own; the others only have counts.
  [[nodiscard]] virtual const std::vector<Source> & compared() const = 0;

  /// Every error that it learns. Allocates.
  [[nodiscard]] virtual std::vector<Bias> biases() const = 0;

  /// The steps as they were found so far, rising; empty from a method that measures none.
  /** It begins anew with the estimator, and when the robot is located anew. Allocates. */
  [[nodiscard]] virtual std::vector<StepAsBuilt> staircase_as_built() const { return {}; }

  /// What should survive a restart, and a number that rises whenever it changed.
  [[nodiscard]] virtual StoredState state_to_store() const = 0;
  [[nodiscard]] virtual std::uint64_t state_version() const = 0;
};

/// Counts a jump of the estimate, from `before` to the pose that it has now.
void note_reset(StairEstimate & estimate, ResetCause cause, const stetro_site::Pose & before);

/// Why a pose in the flight frame cannot be told to an estimator; nothing if it can.
/** It must be a number, stand on the step under it, lie between the walls and face the stairs. */
[[nodiscard]] std::optional<std::string> implausible(
  const stetro_site::Pose & pose, const stetro_site::Flight & flight, double most_yaw_rad);

/// Variance of row i of a told pose: at least 0.01 squared; 0.1 squared if none was given.
[[nodiscard]] double told_variance(const stetro_site::Covariance & covariance, int i);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__ESTIMATOR_HPP_
