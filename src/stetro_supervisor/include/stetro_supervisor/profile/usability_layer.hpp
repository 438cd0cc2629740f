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

#ifndef STETRO_SUPERVISOR__PROFILE__USABILITY_LAYER_HPP_
#define STETRO_SUPERVISOR__PROFILE__USABILITY_LAYER_HPP_

#include <Eigen/Core>
#include <vector>

#include "stetro_site/free_space.hpp"
#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/contraction.hpp"
#include "stetro_supervisor/profile/determination.hpp"

namespace stetro_supervisor
{

/// What the profile of a place is worth, by the map alone.
struct Usability
{
  double spectral_radius = 0.0;   ///< of a guarded centroid step; NaN where nobody stands
  double published_radius = 0.0;  ///< of a step as published, see Contraction
  double worst_sigma_m = 0.0;     ///< of the position, see Determination
  Eigen::Vector2d worst_direction = Eigen::Vector2d::UnitX();
};

/// How a map is asked what its places are worth.
struct UsabilityParams
{
  double spacing_m = 0.25;    ///< between the places asked
  double clearance_m = 0.25;  ///< of a place where the body fits; others are not asked
  ContractionParams contraction{720, 12.0, 0.05, kCapMedians};
  DeterminationParams determination;
};

/// The usability of a floor's places, worked out once for a map.
/** Immutable after construction: one instance may be shared between threads. */
class UsabilityLayer
{
public:
  /// Asks every place of a grid between two corners: about a third of a millisecond each.
  /** \throws std::invalid_argument unless the spacing is positive and the corners are in order */
  UsabilityLayer(
    const stetro_site::ProfileCaster & map, const stetro_site::FreeSpace & free,
    const Eigen::Vector2d & low_m, const Eigen::Vector2d & high_m, const UsabilityParams & params);

  /// Of the four places about a point the one that contracts least; null where none was asked.
  [[nodiscard]] const Usability * at(const Eigen::Vector2d & point_m) const;

  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }
  [[nodiscard]] Eigen::Vector2d place_m(int column, int row) const;

  /// The value of a place of the grid; its spectral radius is NaN where it was not asked.
  [[nodiscard]] const Usability & of(int column, int row) const;

private:
  Eigen::Vector2d low_m_;
  double spacing_m_;
  int columns_;
  int rows_;
  std::vector<Usability> places_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__USABILITY_LAYER_HPP_
