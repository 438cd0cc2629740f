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

#ifndef STETRO_SUPERVISOR__FLOOR__SCAN_BEAMS_HPP_
#define STETRO_SUPERVISOR__FLOOR__SCAN_BEAMS_HPP_

#include <vector>

#include "stetro_site/robot_geometry.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"
#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/floor/scan.hpp"
#include "stetro_supervisor/four_beams/heading_search.hpp"

namespace stetro_supervisor
{

/// A few single beams of a scan, for the search by few beams (S-G).
/**
 * Eight, every eighth of a turn from the lidar's x axis: the four of S-G and those between, so that
 * some may be wrong. Each is the median of the lidar's three rays about its direction. Where two of
 * them have no return, it has none either: nothing stands within `floor.dependable_m`. One alone is
 * no news, for a lidar drops rays.
 */
struct ScanBeams
{
  std::vector<RangeBeam> beams;
  /// Of each, as REP 117: +inf no return, -inf too near, NaN says nothing.
  std::vector<double> ranges_m;
};

constexpr std::size_t kScanBeams = 8;

/// How many of the eight may end on something that the map does not show.
constexpr std::size_t kWrongBeams = 3;

[[nodiscard]] ScanBeams beams_of(
  const Scan & scan, const stetro_site::Lidar & lidar, const FloorParams & params);

/// Whether enough of the beams agree with a place of base_link, within about a cell of it.
/** Where too few say anything they exclude no place. */
[[nodiscard]] bool beams_allow(
  const DrawnFloor & floor, const ScanBeams & beams, const FloorPlace & place);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__SCAN_BEAMS_HPP_
