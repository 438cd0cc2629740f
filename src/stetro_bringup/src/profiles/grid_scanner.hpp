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

#ifndef PROFILES__GRID_SCANNER_HPP_
#define PROFILES__GRID_SCANNER_HPP_

#include <cstddef>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_bringup
{

/// Ranges of a scanner on a grid, each beam from cell to cell (Amanatides and Woo 1987).
/** It shares no code with the casters of stetro_site, which cast borders as segments: what they
 *  get wrong shows. Unknown cells let beams pass. +inf beyond `reach_m`. */
[[nodiscard]] stetro_supervisor::RangeProfile scanned(
  const stetro_site::OccupancyGrid & grid, const stetro_supervisor::ScannerPose & pose,
  std::size_t beams, double reach_m);

}  // namespace stetro_bringup

#endif  // PROFILES__GRID_SCANNER_HPP_
