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

#ifndef PROFILES__RECORDED_FLOOR_HPP_
#define PROFILES__RECORDED_FLOOR_HPP_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stetro_site/free_space.hpp"
#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/place_search.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"
#include "stetro_supervisor/profile/scan_check.hpp"
#include "stetro_supervisor/profile/usability_layer.hpp"

namespace stetro_bringup
{

/// What a scanner sees from a place, by another caster than the map's.
using World = std::function<stetro_supervisor::RangeProfile(
  const stetro_supervisor::ScannerPose & pose, std::size_t beams, double reach_m)>;

/// A floor of a recorded or drawn map: what the check knows of it, and what a scanner sees there.
struct RecordedFloor
{
  std::string name;   ///< of the map; the floors of a building share it
  std::string level;  ///< of a building; empty: it has one
  std::shared_ptr<const stetro_site::ProfileCaster> map;
  std::shared_ptr<const stetro_site::OccupancyGrid> grid;
  std::shared_ptr<const stetro_site::GridFreeSpace> free;
  stetro_supervisor::FreeSpace is_free;
  std::shared_ptr<const stetro_site::DistanceField> walls;  ///< for the ends of beams
  std::shared_ptr<const stetro_supervisor::UsabilityLayer> layer;
  bool drawn = false;  ///< walls are lines and not cells
  World world;
  World rough_world;  ///< other cells along the same walls; none for a drawn floor
};

/// How the check is set up there.
[[nodiscard]] stetro_supervisor::ScanCheckParams scan_check_params_of(const RecordedFloor & floor);

/// A map of the ROS map_server format.
/** \throws stetro_config::ConfigError */
[[nodiscard]] RecordedFloor grid_floor(const std::string & name, const std::string & yaml);

/// tau_fl4, tau_lab446, uw_hallway, tb3_world, and the levels of hotel, from `tests/recorded`.
/** \throws std::exception naming what cannot be read */
[[nodiscard]] std::vector<RecordedFloor> recorded_floors(const std::string & folder);

}  // namespace stetro_bringup

#endif  // PROFILES__RECORDED_FLOOR_HPP_
