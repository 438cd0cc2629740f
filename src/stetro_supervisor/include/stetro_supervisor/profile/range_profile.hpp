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

#ifndef STETRO_SUPERVISOR__PROFILE__RANGE_PROFILE_HPP_
#define STETRO_SUPERVISOR__PROFILE__RANGE_PROFILE_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "stetro_site/profile_caster.hpp"

namespace stetro_supervisor
{

/// Where a scanner stands on a floor: K and psi of S-C, the scanner's and not base_link's.
struct ScannerPose
{
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< in the floor's frame
  double yaw_rad = 0.0;  ///< of the scanner's x axis in the floor's frame, CCW
};

/// What a scanner saw in one turn, or in the part of a turn that it covers.
/**
 * Beam i points along `fan.first_rad + i * fan.step_rad` in the scanner's axes. REP 117: +inf
 * where nothing was in range, -inf too near to tell, NaN not valid.
 */
struct RangeProfile
{
  stetro_site::BeamFan fan;
  std::vector<double> ranges_m;
};

/// A profile with the directions of its beams worked out, whole or thinned to every n-th beam.
class Beams
{
public:
  /// \throws std::invalid_argument unless there is a range for each beam and a step between beams
  explicit Beams(const RangeProfile & profile);

  /// Takes another profile of the same fan; the directions stay. \return false if it is another fan
  [[nodiscard]] bool renew(const RangeProfile & profile);

  /// About `count` beams of these, evenly; these if there are no more.
  [[nodiscard]] Beams thinned(std::size_t count) const;

  [[nodiscard]] std::size_t size() const noexcept { return ranges_m_.size(); }
  [[nodiscard]] const std::vector<double> & ranges_m() const noexcept { return ranges_m_; }

  /// Unit vectors in the scanner's axes.
  [[nodiscard]] const std::vector<Eigen::Vector2d> & directions() const noexcept
  {
    return directions_;
  }

  /// The last beam has the first one for its neighbour.
  [[nodiscard]] bool closed() const noexcept { return closed_; }

  /// Angle between neighbours, positive [rad].
  [[nodiscard]] double step_rad() const noexcept;

  /// The same beams in the floor's frame, for a scanner turned by `yaw_rad`.
  [[nodiscard]] stetro_site::BeamFan fan_at(double yaw_rad) const noexcept;

private:
  Beams() = default;

  stetro_site::BeamFan fan_;
  std::vector<double> ranges_m_;
  std::vector<Eigen::Vector2d> directions_;
  bool closed_ = false;
};

/// R(psi): takes the scanner's axes to the floor's.
[[nodiscard]] Eigen::Matrix2d rotation(double yaw_rad);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__RANGE_PROFILE_HPP_
