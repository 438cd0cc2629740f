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

#ifndef STETRO_SUPERVISOR__PROFILE__WALL_VIEW_HPP_
#define STETRO_SUPERVISOR__PROFILE__WALL_VIEW_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// What a scanner at a place would see by the map: each beam's range and the wall it ends on.
/**
 * The direction of a wall comes from the ends of neighbouring beams, so any caster will do. On a
 * map of cells two ends must lie some cells apart, or the direction is that of a cell's side.
 * Everything is in the scanner's axes. Memory is kept from look to look; for one thread.
 */
class WallView
{
public:
  /// \param reach_m of a beam \param baseline_m least length a wall's direction is taken from
  WallView(double reach_m, double baseline_m);

  /// Casts the profile from `pose`, without the walls' directions.
  void look(const stetro_site::ProfileCaster & map, const Beams & beams, const ScannerPose & pose);

  /// Works the walls' directions out from the last look.
  void find_walls(const Beams & beams);

  /// Of the beams, +inf where the map shows nothing within reach [m].
  [[nodiscard]] const std::vector<double> & ranges_m() const noexcept { return ranges_m_; }

  /// The wall's unit normal that faces the scanner; zero where no wall was made out.
  [[nodiscard]] const Eigen::Vector2d & normal(std::size_t i) const { return normals_[i]; }

  /// Cosine between beam and normal, 0 to 1; zero where no wall was made out.
  [[nodiscard]] double incidence(std::size_t i) const { return incidences_[i]; }

private:
  /// Beams from an end to the ends its wall's direction is taken from.
  [[nodiscard]] std::size_t spread(std::size_t i, double step_rad) const;

  double reach_m_;
  double baseline_m_;
  std::vector<double> ranges_m_;
  std::vector<Eigen::Vector2d> ends_;
  std::vector<Eigen::Vector2d> normals_;
  std::vector<double> incidences_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__WALL_VIEW_HPP_
