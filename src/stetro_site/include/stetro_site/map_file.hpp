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

#ifndef STETRO_SITE__MAP_FILE_HPP_
#define STETRO_SITE__MAP_FILE_HPP_

#include <optional>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_site/occupancy_grid.hpp"

namespace stetro_site
{

/// A map read from the ROS map_server format, and what had to be decided in reading it.
struct GridMap
{
  OccupancyGrid grid;
  std::vector<std::string> notes;
};

/// Reads a map of the ROS map_server format: a YAML file and the image it names. Nothing if a fault
/// was added.
/**
 * With a pixel's level g (the mean of its colours) and the level of white G, its occupancy is
 *
 *   p = 1 - g / G     or g / G with `negate`, modes trinary and scale                      (1)
 *   p = v / 100       of v = round(255 g / G), unknown above v = 100, mode raw              (2)
 *
 * and it is occupied for p > occupied_thresh, free for p < free_thresh, else unknown: what scale
 * and raw maps say between the two, in per cent, no robot drives on. Two readings differ from
 * map_server's, both towards unknown (docs/decisions/0008-unknown-cells-of-a-map.md):
 *
 *  - level 205 of 255 in a trinary map is unknown even if free_thresh makes it free; a note
 *    counts the cells;
 *  - a pixel that is not wholly opaque is unknown in every mode, and an opaque one is judged by
 *    its colour alone.
 *
 * The lower left pixel's outer corner is `origin` (x, y, yaw); the image's path counts from the
 * folder of the YAML file. PGM (P2, P5, up to 16 bits) and PNG are read.
 */
[[nodiscard]] std::optional<GridMap> read_map(
  const std::string & path, stetro_config::Faults & faults);

/// The same. \throws stetro_config::ConfigError with every fault
[[nodiscard]] GridMap load_map(const std::string & path);

}  // namespace stetro_site

#endif  // STETRO_SITE__MAP_FILE_HPP_
