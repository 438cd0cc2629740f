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

#include <cstdint>
#include <string>
#include <vector>

#include "sim/archive.hpp"
#include "sim/sim_world.hpp"
#include "stetro_config/report.hpp"

namespace stetro_driver
{
namespace
{

void list(StairShape shape, sim::StateWriter & each)
{
  for (std::size_t i = 0; i < shape.riser_m.size(); ++i) {
    each(shape.riser_m[i], shape.tread_m[i]);
  }
  each(
    shape.width_foot_m, shape.width_top_m, shape.right_walled, shape.left_walled,
    shape.wall_overrun_m);
}

void list(stetro_site::Pose pose, sim::StateWriter & each)
{
  each(pose.x_m, pose.y_m, pose.z_m, pose.yaw_rad);
}

void list(BuildingShape building, sim::StateWriter & each)
{
  for (PlacedStairs & flight : building.flights) {
    list(flight.shape, each);
    list(flight.pose_in_map, each);
    each(flight.lower, flight.upper);
  }
  for (FloorShape & floor : building.floors) {
    list(floor.pose_in_map, each);
    each(floor.drawn);
    for (stetro_site::Polygon & polygon : floor.walls) {
      for (Eigen::Vector2d & corner : polygon) {
        each(corner.x(), corner.y());
      }
    }
  }
  each(building.start);
}

void list(BodyShape b, sim::StateWriter & each)
{
  each(
    b.block_length_m, b.body_width_m, b.block_height_m, b.contact_width_m, b.stroke_m,
    b.lift_speed_m_s, b.steer_speed_rad_s, b.bumper_travel_m, b.switch_travel_m, b.switch_y_m);
  for (TofMounting & tof : b.tof) {
    each(tof.block, tof.position_m, tof.direction);
  }
  LidarShape & l = b.lidar;
  each(l.x_m, l.y_m, l.height_m, l.yaw_rad, l.min_range_m, l.max_range_m, l.beams, l.rate_hz);
}

}  // namespace

std::uint64_t identity_of(
  const BuildingShape & building, const BodyShape & body, const SimOptions & options,
  std::uint32_t layout)
{
  std::vector<std::uint8_t> bytes;
  sim::StateWriter each{bytes};
  each(layout);
  list(building, each);
  list(body, each);
  SimOptions o = options;
  each(o.seed, o.as_built, o.origin, o.lidar, o.people, o.unmapped_boxes);
  for (const SimFault & fault : o.faults) {
    SimFault f = fault;
    each(f.kind, f.from_s, f.until_s, f.value);
    bytes.insert(bytes.end(), f.device.begin(), f.device.end());
  }
  const std::string errors = stetro_config::to_yaml(o.errors);
  bytes.insert(bytes.end(), errors.begin(), errors.end());
  return sim::checksum_of(bytes.data(), bytes.size());
}

}  // namespace stetro_driver
