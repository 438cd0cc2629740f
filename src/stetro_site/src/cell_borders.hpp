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

#ifndef CELL_BORDERS_HPP_
#define CELL_BORDERS_HPP_

#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

/// The borders between cells that stop beams and cells that do not, in the grid's axes [cells].
/**
 * Straight pieces as long as the same side stops; seen from the free side, which is on their left,
 * they run counter-clockwise. Outside the grid everything is unknown.
 */
[[nodiscard]] std::vector<Segment> cell_borders(const OccupancyGrid & grid, Unknown unknown);

}  // namespace stetro_site

#endif  // CELL_BORDERS_HPP_
