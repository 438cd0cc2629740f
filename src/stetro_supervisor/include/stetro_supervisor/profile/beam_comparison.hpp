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

#ifndef STETRO_SUPERVISOR__PROFILE__BEAM_COMPARISON_HPP_
#define STETRO_SUPERVISOR__PROFILE__BEAM_COMPARISON_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "stetro_supervisor/profile/beam_noise.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"
#include "stetro_supervisor/profile/wall_view.hpp"

namespace stetro_supervisor
{

/// What a beam says of a place on the map.
enum class BeamOutcome : std::uint8_t {
  kAgrees,   ///< within the gate of the map's range
  kShorter,  ///< something stands before the wall that the map does not know
  kLonger,   ///< it went through a wall of the map: of all the strongest word against the place
  kEdge,     ///< between the ranges of its neighbours, at a jump of the profile: says nothing
  kSilent    ///< no echo, not valid, nothing on the map either, or too near to tell: says nothing
};

/// What the agreeing beams on one wall of the map say together, scanner's axes.
struct WallEvidence
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
};

/// A measured profile against the map's from one place, beam by beam.
struct BeamComparison
{
  std::vector<BeamOutcome> outcomes;
  std::size_t agreeing = 0;
  std::size_t shorter = 0;
  std::size_t longer = 0;
  std::size_t near_misses = 0;  ///< of `shorter` and `longer`, those off by less than five gates
  std::size_t edges = 0;
  std::size_t silent = 0;

  /// Sum of min((e / sigma)^2, gate^2) over the beams that speak, one error of a wall counted once
  /// and a beam through a wall four times. Infinite until something was compared.
  double mismatch = std::numeric_limits<double>::infinity();
  /// Beams through walls of the map, one error of a wall counted once.
  double contradiction = 0.0;
  /// Mean of (e / sigma)^2 of the agreeing beams; about 1 where noise is what was stated.
  double chi_square = 0.0;
  /// Of position and heading (scanner's axes) by the agreeing beams [1/m^2, 1/m, 1].
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Where a Newton step of the agreeing beams leads: right-hand side beside `information`.
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  /// Both, wall by wall.
  std::vector<WallEvidence> walls;
  /// Share of the agreeing in the evidence of the direction where it is least, 0 to 1.
  double least_direction_share = 0.0;

  /// Beams that say something of the place.
  [[nodiscard]] std::size_t speaking() const noexcept { return agreeing + shorter + longer; }
  [[nodiscard]] double agreeing_share() const noexcept { return share(agreeing); }
  [[nodiscard]] double longer_share() const noexcept { return share(longer); }
  [[nodiscard]] double near_share() const noexcept { return share(near_misses); }

private:
  [[nodiscard]] double share(std::size_t part) const noexcept
  {
    return speaking() == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(speaking());
  }
};

/// Compares `scan` with a view of the map whose walls were found.
/**
 * With the residual e = r - m of a beam along d, the wall's normal n and c = |n d|, the variance
 * is sigma^2 = sigma_r^2 + (sigma_map / c)^2, and a beam agrees if |e| <= gate sigma. Its residual
 * across the wall rho = e n d has the Jacobian H = (n, r n (z x d)) in (x, y, psi), and the
 * information sums H'H / v with v = c^2 sigma_r^2 + k sigma_map^2, k the number of beams that
 * share one error of the wall.
 */
void compare_beams(
  const Beams & scan, const WallView & view, const BeamNoise & noise, double gate,
  BeamComparison & comparison);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__BEAM_COMPARISON_HPP_
