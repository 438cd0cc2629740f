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

#ifndef PROFILES__ROUGHENED_HPP_
#define PROFILES__ROUGHENED_HPP_

#include <random>

#include "stetro_site/occupancy_grid.hpp"

namespace stetro_bringup
{

/// The same floor as if it had been mapped once more: other cells along the same walls.
/**
 * A map says of a wall's face no more than which cells it passes. With the share as probability a
 * free cell beside a wall becomes wall, and a wall's cell beside free ones becomes free if another
 * stands behind it, so that no wall is opened. What a check makes of the steps of the cells alone,
 * it does not find there.
 */
[[nodiscard]] stetro_site::OccupancyGrid roughened(
  const stetro_site::OccupancyGrid & grid, double share, std::mt19937_64 & random);

}  // namespace stetro_bringup

#endif  // PROFILES__ROUGHENED_HPP_
