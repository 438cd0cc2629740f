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

#ifndef STETRO_SUPERVISOR__PROFILE__CONTRACTION_HPP_
#define STETRO_SUPERVISOR__PROFILE__CONTRACTION_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>

#include "stetro_site/profile_caster.hpp"

namespace stetro_supervisor
{

/// Ranges beyond this many medians are cut off in the guarded centroids of TrustedCentreOfMass.
constexpr double kCapMedians = 3.0;

/// How the profile of a place is taken to tell its contraction.
struct ContractionParams
{
  std::size_t beams = 360;
  double reach_m = 12.0;  ///< of a beam: one that meets nothing within it is left out
  double step_m = 0.05;   ///< of the differences; some cells on a grid
  /// Ranges are cut off at this many medians of the place, as by the steps that run; infinite: not
  /// at all, as by `published_search`.
  double cap_medians = kCapMedians;
};

/// The same asked of the search as published.
[[nodiscard]] inline ContractionParams as_published(ContractionParams params)
{
  params.cap_medians = std::numeric_limits<double>::infinity();
  return params;
}

/// What one step of the centroid search does to a small error of position.
struct Contraction
{
  Eigen::Matrix2d jacobian;  ///< error after the step by error before it
  double spectral_radius;    ///< below 1 the search comes home from nearby, however slowly
};

/// Whether the centre of mass is worth something at a place, which the map alone tells.
/**
 * With F(K) = K + c(K) the centroid of the map's profile from K, in the floor's frame, the search
 * of S-C eq. (8) is K <- F(K) - c_robot, and an error e of K becomes J e with J = dF/dK. In a room
 * without obstacles F is the room's own centroid wherever one stands: J = 0, one step. Where
 * the profile moves along with the scanner, as in a corridor longer than the reach, J has an
 * eigenvalue of 1: the centroid knows nothing of that direction.
 *
 * J is of one iteration and tells nothing of another. The guarded steps of TrustedCentreOfMass cut
 * ranges off at a cap and leave out beams that have no echo in the scan: here those that meet
 * nothing from `position_m`. `published_search` knows no cap and leaves out what meets nothing from
 * where it is. The guarded steps take a hundred beams, in whatever heading, and so J is asked with
 * more: of a few it would tell through which doors they happen to look. What it leaves out: limits
 * and halvings of a step, which only shorten it, and that steps end at 2 % of the profile's size.
 *
 * \return nothing where a profile has no area
 */
[[nodiscard]] std::optional<Contraction> contraction(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & position_m,
  const ContractionParams & params);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__CONTRACTION_HPP_
