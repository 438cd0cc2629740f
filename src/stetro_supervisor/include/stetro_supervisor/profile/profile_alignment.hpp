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

#ifndef STETRO_SUPERVISOR__PROFILE__PROFILE_ALIGNMENT_HPP_
#define STETRO_SUPERVISOR__PROFILE__PROFILE_ALIGNMENT_HPP_

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "stetro_supervisor/profile/beam_comparison.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"
#include "stetro_supervisor/profile/wall_view.hpp"

namespace stetro_supervisor
{

/// What is known of the heading before the profile is looked at.
struct HeadingPrior
{
  double yaw_rad = 0.0;
  double sigma_rad = 0.0;  ///< 0: known, and not to be changed
};

/// Moves a pose by a step in the scanner's axes (x, y, psi).
[[nodiscard]] ScannerPose moved(const ScannerPose & pose, const Eigen::Vector3d & step);

/// Draws a scan onto the map's walls, beam by beam, from a place nearby.
/**
 * A Gauss-Newton step on the distances of the measured ends from the walls that the same beams
 * meet on the map (point to line, correspondence by beam):
 *
 *   minimise sum w(rho / s) (rho + H delta)^2,   rho = (r - m) n d,   H = (n, r n (z x d)),
 *
 * with Geman and McClure's weight w = 1 / (1 + (rho / s)^2)^2. The scale s is twice the median of
 * |rho| and so shrinks as the scan falls into place, down to the noise: beams on what the map does
 * not know lose their say without a threshold of their own.
 */
class ProfileAlignment
{
public:
  /// \param finest_m the least scale s, about three standard deviations of a range
  explicit ProfileAlignment(double finest_m) : finest_m_(finest_m) {}

  /// Begins at another place, with a scale of at least `scale_m`.
  void restart(double scale_m) noexcept { scale_m_ = scale_m / kSlowest; }

  /// At the last step most beams were within the finest scale of their walls.
  [[nodiscard]] bool fits() const noexcept { return fits_; }

  /// The step in the scanner's axes; nothing where walls of one direction only are in view.
  /** \param at heading now, against which the prior pulls */
  [[nodiscard]] std::optional<Eigen::Vector3d> step(
    const Beams & scan, const WallView & view, const HeadingPrior & prior, double yaw_rad);

  /// Weighs each beam of the next steps by its own factor as well; none: all alike.
  void weigh(std::vector<double> factors) { factors_ = std::move(factors); }

private:
  /// The scale shrinks by no more than this in a step, or walls of one direction would fall into
  /// place and leave those of the other behind as strangers.
  static constexpr double kSlowest = 0.3;

  double finest_m_;
  double scale_m_ = 0.0;
  bool fits_ = false;
  std::vector<double> factors_;
  std::vector<double> distances_;
  std::vector<double> sorted_;
};

/// Step and covariance by the beams that agree, each weighed by its own variance.
struct SettledStep
{
  Eigen::Vector3d step = Eigen::Vector3d::Zero();        ///< scanner's axes (x, y, psi)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< scanner's axes
  /// To be added: how far the place would move without each wall that contradicts the others. What
  /// is not on the map may stand flat before a wall of it, within the gate, and agree.
  Eigen::Matrix3d doubt = Eigen::Matrix3d::Zero();
};

/// The maximum-likelihood step of a comparison; nothing if its information is singular.
[[nodiscard]] std::optional<SettledStep> settled_step(
  const BeamComparison & comparison, const HeadingPrior & prior, double yaw_rad);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__PROFILE_ALIGNMENT_HPP_
