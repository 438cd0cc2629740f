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
#include <optional>

#include "stetro_site/profile_caster.hpp"

namespace stetro_supervisor
{

/// How the profile of a place is taken to tell its contraction.
struct ContractionParams
{
  std::size_t beams = 360;
  double reach_m = 12.0;  ///< of a beam: one that meets nothing within it is left out
  double step_m = 0.05;   ///< of the differences; some cells on a grid
};

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
 * Beams that meet nothing are left out as `published_search` leaves them out: closed by the reach
 * instead, the profile is another one, its J is another, and tells nothing of that search.
 *
 * \return nothing where a profile has no area
 */
[[nodiscard]] std::optional<Contraction> contraction(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & position_m,
  const ContractionParams & params);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__CONTRACTION_HPP_
