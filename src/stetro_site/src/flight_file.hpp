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

#ifndef FLIGHT_FILE_HPP_
#define FLIGHT_FILE_HPP_

#include <optional>
#include <string>
#include <vector>

#include "stetro_config/map_reader.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_site
{

/// Reads a map with x_m, y_m and yaw_rad, and z_m if `with_z`.
[[nodiscard]] Pose read_pose(stetro_config::MapReader map, bool with_z);

/// Reads one flight of a site file. Nothing if a fault was added.
/**
 * The totals a file may give besides are checked against the sums (D1-10, D2).
 * \param notes gets a line when a total length turns out to be the papers' L
 */
[[nodiscard]] std::optional<Flight> read_flight(
  stetro_config::MapReader & map, double tolerance_m, std::vector<std::string> & notes);

}  // namespace stetro_site

#endif  // FLIGHT_FILE_HPP_
