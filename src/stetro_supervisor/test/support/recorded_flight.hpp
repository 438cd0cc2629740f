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

#ifndef SUPPORT__RECORDED_FLIGHT_HPP_
#define SUPPORT__RECORDED_FLIGHT_HPP_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_supervisor/four_beams/heading_search.hpp"

namespace stetro_supervisor
{

/// One sample of a flight through a room, and where it was taken.
struct FlightSample
{
  std::array<double, 4> ranges_m{};  ///< front, left, back, right
  Eigen::Vector2d position_m{0.0, 0.0};
  double heading_rad = 0.0;  ///< of the front beam, CCW
};

/// Reads tests/recorded/fourbeam_room363, whose README tells its traps.
/** \throws std::runtime_error when the file is missing or is no list of samples */
[[nodiscard]] std::vector<FlightSample> read_flight(const std::string & path);

/// Directions of the four beams from the front beam, CCW [rad].
extern const std::array<double, 4> kFlightBeams;

/// A map from samples alone: cells of 5 cm, free where beams passed, occupied where they ended.
/**
 * A beam is taken for a fan of +-6 degrees, half of the sensor's cone, which clears the cells
 * between beams; two successive ends of one sensor less than 0.3 m apart are one wall and are
 * joined. A cell is occupied if three tenths of the beams that met it ended there.
 */
[[nodiscard]] stetro_site::OccupancyGrid map_of(const std::vector<FlightSample> & samples);

/// Ranges less the length of their beams' axes in a map, where these end on a wall [m].
[[nodiscard]] std::vector<double> range_errors_m(
  const stetro_site::OccupancyGrid & map, const std::vector<FlightSample> & samples);

/// Alternate blocks of `length` samples: the first block and every other one after it, or the rest.
[[nodiscard]] std::vector<FlightSample> every_other_block(
  const std::vector<FlightSample> & samples, std::size_t length, bool first);

}  // namespace stetro_supervisor

#endif  // SUPPORT__RECORDED_FLIGHT_HPP_
