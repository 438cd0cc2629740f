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

#ifndef STETRO_SUPERVISOR__PROFILE__PLACE_SEARCH_HPP_
#define STETRO_SUPERVISOR__PROFILE__PLACE_SEARCH_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// Whether a scanner can stand at a place of the floor.
using FreeSpace = std::function<bool(const Eigen::Vector2d &)>;

/// Where to look for the scanner.
struct SearchArea
{
  ScannerPose around;
  double radius_m = 1.0;
  double yaw_half_width_rad = 0.0;  ///< 0: the heading of `around`; pi: any
};

/// A place worth a closer look.
struct Place
{
  ScannerPose pose;
  double misfit = 0.0;  ///< mean capped difference of the ranges [m]
};

/// How finely places are tried.
struct SearchGrid
{
  double spacing_m = 1.0;   ///< between places
  std::size_t most = 4000;  ///< places; a larger area is searched more coarsely
  std::size_t kept = 12;    ///< of the best, no two neighbours at one heading
  double reach_m = 30.0;    ///< of a beam
};

/// The places of an area whose profile on the map is most like the scan.
/**
 * Every free place of a square grid is scanned on the map with the few beams of `scan`, once. The
 * misfit is the mean of min(|r - m|, 2 spacing): what the map does not know counts as little as
 * what a place half a spacing off changes. Other headings are the same scan counted from another
 * beam, so they cost no cast; a scan of less than a turn is tried at one heading only.
 */
[[nodiscard]] std::vector<Place> likely_places(
  const stetro_site::ProfileCaster & map, const FreeSpace & is_free, const Beams & scan,
  const SearchArea & area, const SearchGrid & grid);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__PLACE_SEARCH_HPP_
