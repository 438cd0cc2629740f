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

#ifndef STETRO_LOCALIZER__HEADING_HPP_
#define STETRO_LOCALIZER__HEADING_HPP_

#include <optional>

#include "stetro_localizer/carried_average.hpp"
#include "stetro_localizer/gyro_heading.hpp"
#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_localizer/range_offset.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// Heading against the risers: S-A and S-B eq. (2), and what stands in for it.
/**
 * While the front pair sees a riser, psi is eq. (2) of the moving average of d_left - d_right, freed
 * from its constant part, each cycle (D1-6, D1-7, D1-16). Without a riser in sight (treads N - 1 and
 * N, a dead beam, a window that is still filling) the gyroscope carries the last heading on and the
 * variance grows: that is ours.
 *
 * Both riser switches closed mean that block 2 stands square to the riser before it: psi = 0. The
 * front pair, on block 1 one tread further, then sees the next riser, which is parallel to that one
 * but for how the stairs were built; its mean difference over a full window is its constant error.
 */
class Heading
{
public:
  Heading(
    const HeadingParams & params, const GyroParams & gyro,
    const stetro_site::RobotGeometry & robot);

  /// \return false if the gyroscope was silent for too long before
  bool add_gyro(const GyroSample & sample, bool standing);

  /// Takes one pair of front ranges.
  /**
   * \param riser the riser that block 1's height puts before the beams; nothing: none in sight
   * \param travel_m distance driven along x, by the wheels: carries the ranges [m]
   */
  Verdict add_pair(
    const RangeReading & left, const RangeReading & right, std::optional<int> riser,
    double travel_m, SourceReport & report);

  /// Takes the state of the riser switches; `both_closed` over time is one press.
  Verdict add_switches(bool both_closed, SourceReport & report);

  /// Starts from a heading that was told.
  void reset(double yaw_rad, double variance);

  /// Starts facing the stairs as well as a robot that was correcting itself does.
  void assume_aligned(double sigma_rad)
  {
    fix_variance_ = reference_variance_ = sigma_rad * sigma_rad;
  }

  [[nodiscard]] double yaw_rad() const;
  [[nodiscard]] double variance() const { return fix_variance_ + gyro_.variance_since_mark(); }

  /// Doubt since the last reference, without the constant error of the front pair [rad^2].
  [[nodiscard]] double reference_variance() const
  {
    return reference_variance_ + gyro_.variance_since_mark();
  }

  /// Mean range from the front pair to the riser it sees, along the robot [m].
  [[nodiscard]] std::optional<double> riser_distance_m(Nanoseconds now, double travel_m) const;
  [[nodiscard]] std::optional<int> riser_in_use() const { return riser_; }

  /// Rises by one when the heading started anew because the pair contradicted it for too long.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }
  /// Rises by one with each calibration of the pair's difference.
  [[nodiscard]] std::uint32_t calibrations() const { return calibrations_; }

  [[nodiscard]] const RangeOffset & difference_offset() const { return offset_; }
  [[nodiscard]] const ScalarEstimate & gyro_bias() const { return gyro_.bias(); }
  void set_calibration(const RangeOffset & difference, const ScalarEstimate & gyro_bias);

private:
  [[nodiscard]] bool usable(const RangeReading & left, const RangeReading & right) const;
  [[nodiscard]] bool in_gate(double difference_m, double range_m, SourceReport & report) const;
  [[nodiscard]] double mean_variance(double range_m, std::size_t count) const;  // of psi [rad^2]
  void clear_window();
  void follow_window(Nanoseconds now, double travel_m);
  void calibrate_difference(double difference_m, double range_m);
  void fix(double yaw_rad, double variance);

  HeadingParams params_;
  TofNoise noise_;
  double baseline_m_;     // D, between the front beams [m]
  double range_limit_m_;  // beyond it a range is not reliable [m]
  GyroHeading gyro_;
  CarriedAverage difference_;  // d_left - d_right [m], carried by the turned angle
  CarriedAverage distance_;    // (d_left + d_right) / 2 [m], carried by the way driven
  RangeOffset offset_;
  std::optional<int> riser_;
  Nanoseconds last_stamp_{0};  // of the last pair taken
  bool seen_ = false;          // the heading has had a reference since it started
  bool restarting_ = false;    // the pair contradicted the heading for too long
  double fix_yaw_rad_ = 0.0;
  double fix_variance_;
  double fix_angle_rad_ = 0.0;       // of the gyroscope
  double reference_variance_;        // of the start, zero once a reference was seen [rad^2]
  bool pressed_ = false;             // both riser switches are closed
  RangeOffset before_press_;         // the pair's constant error when they closed
  double press_difference_m_ = 0.0;  // sums over this press
  double press_range_m_ = 0.0;
  std::size_t press_count_ = 0;
  std::uint32_t restarts_ = 0;
  std::uint32_t calibrations_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__HEADING_HPP_
