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

#ifndef STETRO_SUPERVISOR__PROFILE__END_MATCHING_HPP_
#define STETRO_SUPERVISOR__PROFILE__END_MATCHING_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "stetro_site/distance_field.hpp"
#include "stetro_supervisor/profile/beam_noise.hpp"
#include "stetro_supervisor/profile/place_search.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// How the ends of a scan are laid onto the walls of a map.
struct EndMatchingParams
{
  double on_wall_m = 0.10;           ///< an end within counts as on a wall
  double spacing_m = 0.10;           ///< between places tried
  double turn_rad = 0.0262;          ///< between headings tried, 1.5 degrees
  std::size_t kept = 12;             ///< of the best, refined
  std::size_t beams = 120;           ///< of the scan, to search with
  int steps = 12;                    ///< of a refinement
  double apart_m = 0.20;             ///< places farther apart are two
  BeamNoise noise{0.02, 0.05, 0.5};  ///< of an end, and of the map that has aged
};

/// A place by the ends of the beams, and how well they lie on walls there.
struct EndMatch
{
  ScannerPose pose;
  double on_wall_share = 0.0;  ///< of the ends
  double likelihood = 0.0;     ///< mean of 1 / (1 + (distance / on_wall_m)^2), 0 to 1
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of (x, y, psi), floor's axes
};

/// Lays the ends of a scan onto the nearest walls of a map, whatever the beams pass on their way.
/**
 * A real floor has changed since it was mapped: chairs have gone, doors stand open, glass lets
 * beams through. A beam then ends on a wall behind one that is no more, and comparing it with the
 * first wall of the map says "through a wall" however right the place is. What the ends lie on is
 * left (the likelihood field of Thrun, Burgard and Fox, Probabilistic Robotics 2005, section 6.4,
 * here with Cauchy's weight): for an end p = K + R(psi) r d with the distance D(p) of the nearest
 * wall,
 *
 *   minimise sum w D(p)^2,   w = 1 / (1 + (D / s)^2)^2,   H = grad D (I, r R'(psi) d)
 *
 * from many places and headings. It tells less than a comparison of profiles, as a place is not
 * contradicted by what it should not see through: how much better than all other places the best
 * one is must be asked as well.
 */
class EndMatching
{
public:
  /// \throws std::invalid_argument if there is no field
  EndMatching(
    std::shared_ptr<const stetro_site::DistanceField> walls, const EndMatchingParams & params);

  /// The best places of an area, refined, best first; no two nearer than `apart_m`.
  [[nodiscard]] std::vector<EndMatch> matches(
    const Beams & scan, const SearchArea & area, double reach_m) const;

private:
  /// How well the ends lie on walls from a pose.
  [[nodiscard]] EndMatch rated(
    const std::vector<Eigen::Vector2d> & ends, const ScannerPose & pose, double step_rad) const;
  [[nodiscard]] EndMatch refined(
    const std::vector<Eigen::Vector2d> & ends, const ScannerPose & from, double step_rad) const;
  /// Distance of the nearest wall and its gradient, between the centres of cells.
  [[nodiscard]] Eigen::Vector3d field_at(const Eigen::Vector2d & point_m) const;
  [[nodiscard]] double quick_likelihood(
    const std::vector<Eigen::Vector2d> & ends, const ScannerPose & pose) const;

  std::shared_ptr<const stetro_site::DistanceField> walls_;
  EndMatchingParams params_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__END_MATCHING_HPP_
