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

#include "stetro_driver/site_shape.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>

#include "stetro_site/sensor_place.hpp"

namespace stetro_driver
{

StairShape shape_of(const stetro_site::Flight & flight)
{
  const stetro_site::FlightSpec & spec = flight.spec();
  StairShape shape;
  for (const stetro_site::Step & step : spec.steps) {
    shape.riser_m.push_back(step.riser_m);
    shape.tread_m.push_back(step.tread_m);
  }
  shape.width_foot_m = spec.width_foot_m;
  shape.width_top_m = spec.width_top_m;
  shape.right_walled = spec.right == stetro_site::Side::kWalled;
  shape.left_walled = spec.left == stetro_site::Side::kWalled;
  shape.wall_overrun_m = spec.wall_overrun_m;
  return shape;
}

namespace
{

FloorShape shape_of(const stetro_site::Floor & floor)
{
  FloorShape shape;
  shape.id = floor.id;
  shape.pose_in_map = floor.pose_in_map;
  shape.drawn = floor.is_drawn();
  if (const auto * walls = std::get_if<stetro_site::PolygonWalls>(&floor.drawing)) {
    shape.walls.push_back(walls->outline);
    shape.walls.insert(shape.walls.end(), walls->obstacles.begin(), walls->obstacles.end());
  }
  return shape;
}

std::size_t index_of(const stetro_site::Site & site, const std::string & floor)
{
  const auto found = std::find_if(
    site.floors().begin(), site.floors().end(),
    [&](const stetro_site::Floor & one) { return one.id == floor; });
  return static_cast<std::size_t>(found - site.floors().begin());
}

}  // namespace

BuildingShape shape_of(const stetro_site::Site & site, const std::string & flight)
{
  const stetro_site::Flight & start = site.flight(flight);
  const bool drawn = site.has_drawn_floor();
  BuildingShape building;
  for (const stetro_site::Flight & one : site.flights()) {
    if (!drawn && &one != &start) {
      continue;
    }
    if (&one == &start) {
      building.start = building.flights.size();
    }
    PlacedStairs placed;
    placed.id = one.id();
    placed.shape = shape_of(one);
    placed.pose_in_map = one.spec().pose_in_map;
    if (drawn) {
      placed.lower = index_of(site, one.spec().lower_floor);
      placed.upper = index_of(site, one.spec().upper_floor);
    }
    building.flights.push_back(std::move(placed));
  }
  for (const stetro_site::Floor & floor : site.floors()) {
    if (drawn) {
      building.floors.push_back(shape_of(floor));
    }
  }
  return building;
}

BodyShape shape_of(const stetro_site::Robot & robot)
{
  const stetro_site::RobotGeometry & geometry = robot.geometry;
  BodyShape shape;
  shape.block_length_m = geometry.block_length_m;
  shape.body_width_m = geometry.body_width_m;
  shape.block_height_m = geometry.body_height_m;
  shape.contact_width_m = geometry.contact_width_m;
  shape.stroke_m = geometry.stroke_m;
  shape.lift_speed_m_s = robot.speeds.lift_m_s;
  shape.steer_speed_rad_s = robot.speeds.steer_rad_s;
  shape.switch_y_m = geometry.switch_y_m;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto place = stetro_site::place_named(std::string(kRangeNames[i])).value();
    const stetro_site::Mounting & mounting = geometry.at(place);
    const auto direction = stetro_site::beam_direction(place);
    shape.tof[i] = {
      stetro_site::block_of(place),
      {mounting.x_m, mounting.y_m, mounting.height_m},
      {direction.x(), direction.y(), direction.z()}};
  }
  const stetro_site::Lidar & lidar = geometry.lidar;
  shape.lidar = {
    lidar.x_m,
    lidar.y_m,
    lidar.height_m,
    lidar.yaw_rad,
    lidar.min_range_m,
    lidar.max_range_m,
    static_cast<std::size_t>(lidar.beams),
    lidar.rate_hz};
  return shape;
}

}  // namespace stetro_driver
