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

#ifndef STETRO_SUPERVISOR__FOUR_BEAMS__AZIMUTH_HPP_
#define STETRO_SUPERVISOR__FOUR_BEAMS__AZIMUTH_HPP_

#include <array>
#include <cstddef>

#include "stetro_site/occupancy_grid.hpp"

/**
 * \file
 * S-G counts azimuths clockwise from north and rows downwards from the top of the map (D4-1, D4-8);
 * here yaw is counter-clockwise from a grid's x axis and rows run upwards. North is the grid's +y:
 * "the map is aligned with the geographical north". No other file turns the one into the other.
 */

namespace stetro_supervisor
{

/// The four directions of S-G: 0, 90, 180 and 270 degrees of azimuth.
enum class Azimuth : std::size_t { kNorth, kEast, kSouth, kWest };

constexpr std::array<Azimuth, 4> kAzimuths{
  Azimuth::kNorth, Azimuth::kEast, Azimuth::kSouth, Azimuth::kWest};

/// One number a direction, in the order of `kAzimuths`.
template <class Number>
using PerAzimuth = std::array<Number, 4>;

constexpr std::size_t position(Azimuth azimuth) noexcept
{
  return static_cast<std::size_t>(azimuth);
}

/// From a cell to its neighbour along `azimuth`; S-G's (0, -1) for north is (0, 1) here.
constexpr stetro_site::CellIndex step(Azimuth azimuth) noexcept
{
  constexpr PerAzimuth<stetro_site::CellIndex> kSteps{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
  return kSteps[position(azimuth)];
}

/// Yaw about a grid's x axis of a direction given as an azimuth, in (-pi, pi] [rad].
[[nodiscard]] double yaw_rad(double azimuth_rad);

/// The same for one of the four directions.
[[nodiscard]] double yaw_rad(Azimuth azimuth);

/// A cell as S-G numbers it: from the top left corner, rows downwards.
struct PaperCell
{
  int x = 0;  ///< column
  int y = 0;  ///< row from the top
};

[[nodiscard]] stetro_site::CellIndex from_paper(
  const stetro_site::OccupancyGrid & grid, PaperCell cell);
[[nodiscard]] PaperCell to_paper(
  const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex cell);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FOUR_BEAMS__AZIMUTH_HPP_
