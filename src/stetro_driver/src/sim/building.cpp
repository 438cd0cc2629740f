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

#include "sim/building.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_driver
{

BuildingShape building_of(const StairShape & stairs)
{
  BuildingShape shape;
  PlacedStairs placed;
  placed.id = "flight";
  placed.shape = stairs;
  shape.flights.push_back(std::move(placed));
  return shape;
}

namespace sim
{
namespace
{

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

void require_whole(const BuildingShape & shape)
{
  if (shape.start >= shape.flights.size()) {
    throw std::invalid_argument(
      "the robot starts at flight " + std::to_string(shape.start) + " of " +
      std::to_string(shape.flights.size()));
  }
  for (const PlacedStairs & flight : shape.flights) {
    const bool joined = flight.lower < shape.floors.size() && flight.upper < shape.floors.size();
    if (!shape.floors.empty() && !joined) {
      throw std::invalid_argument("flight " + flight.id + " joins a floor that is not there");
    }
  }
}

StairWorld built(
  const BuildingShape & shape, std::size_t i, const SimErrors * errors, std::uint64_t seed)
{
  const PlacedStairs & flight = shape.flights[i];
  const std::string stream = i == 0 ? "world" : "world of " + flight.id;
  StairWorld world =
    errors != nullptr ? StairWorld{flight.shape, *errors, seed, stream} : StairWorld{flight.shape};
  if (!shape.floors.empty()) {
    world.end_at_sides();
  }
  return world;
}

/// z of each floor: from the lowest one, up and down the flights.
std::vector<double> heights_of_floors(
  const BuildingShape & shape, const std::vector<StairWorld> & worlds)
{
  std::vector<double> z_m(shape.floors.size(), kUnknown);
  const auto lowest = std::min_element(
    shape.floors.begin(), shape.floors.end(), [](const FloorShape & a, const FloorShape & b) {
      return a.pose_in_map.z_m < b.pose_in_map.z_m;
    });
  if (lowest == shape.floors.end()) {
    return z_m;
  }
  z_m[static_cast<std::size_t>(lowest - shape.floors.begin())] = lowest->pose_in_map.z_m;
  for (std::size_t round = 0; round < shape.floors.size(); ++round) {
    for (std::size_t i = 0; i < shape.flights.size(); ++i) {
      const double rise_m = worlds[i].height_m(worlds[i].steps());
      double & lower_m = z_m[shape.flights[i].lower];
      double & upper_m = z_m[shape.flights[i].upper];
      if (std::isnan(upper_m)) {
        upper_m = lower_m + rise_m;
      } else if (std::isnan(lower_m)) {
        lower_m = upper_m - rise_m;
      }
    }
  }
  for (std::size_t i = 0; i < z_m.size(); ++i) {
    z_m[i] = std::isnan(z_m[i]) ? shape.floors[i].pose_in_map.z_m : z_m[i];
  }
  return z_m;
}

}  // namespace

Building::Building(const BuildingShape & shape, const SimErrors * errors, std::uint64_t seed)
{
  require_whole(shape);
  std::vector<StairWorld> worlds;
  for (std::size_t i = 0; i < shape.flights.size(); ++i) {
    worlds.push_back(built(shape, i, errors, seed));
  }
  const std::vector<double> z_m = heights_of_floors(shape, worlds);
  for (std::size_t i = 0; i < shape.floors.size(); ++i) {
    stetro_site::Pose pose = shape.floors[i].pose_in_map;
    pose.z_m = z_m[i];
    floors_.push_back(
      {shape.floors[i].id, FloorPlan{shape.floors[i]}, pose, stetro_site::FrameTransform{pose}});
  }
  place_flights(shape, std::move(worlds), z_m);
  if (has_floors()) {
    for (Stairs & stairs : flights_) {
      surround(stairs);
    }
  }
}

void Building::place_flights(
  const BuildingShape & shape, std::vector<StairWorld> worlds, const std::vector<double> & z_m)
{
  for (std::size_t i = 0; i < shape.flights.size(); ++i) {
    const PlacedStairs & flight = shape.flights[i];
    stetro_site::Pose pose = flight.pose_in_map;
    if (has_floors()) {
      pose.z_m = z_m[flight.lower];
    }
    const double widest_m = std::max(
      {flight.shape.width_foot_m, flight.shape.width_top_m, worlds[i].width_m(0.0),
       worlds[i].width_m(worlds[i].length_m())});
    flights_.push_back(
      {flight.id, std::move(worlds[i]), pose, stetro_site::FrameTransform{pose}, flight.lower,
       flight.upper, widest_m});
  }
}

bool Building::joins(const Stairs & stairs, std::size_t floor) const
{
  return stairs.lower == floor || stairs.upper == floor;
}

std::optional<std::size_t> Building::stairs_at(
  std::size_t floor, const Eigen::Vector3d & in_map, std::size_t present) const
{
  std::optional<std::size_t> found;
  double nearest_m = kAtStairs;
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    const Stairs & stairs = flights_[i];
    const Eigen::Vector3d at = stairs.in_map.to_frame(in_map);
    if (!joins(stairs, floor) || at.y() < 0.0 || at.y() > stairs.world.width_m(at.x())) {
      continue;
    }
    const bool foot = stairs.lower == floor;
    const double gap_m = foot ? -at.x() : std::max(0.0, at.x() - stairs.world.length_m());
    const bool before = foot ? gap_m >= 0.0 : at.x() >= 0.0;
    if (before && (gap_m < nearest_m || (i == present && gap_m <= nearest_m))) {
      nearest_m = gap_m;
      found = i;
    }
  }
  return found;
}

double Building::stairs_distance_m(std::size_t floor, const Eigen::Vector3d & in_map) const
{
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Stairs & stairs : flights_) {
    if (!joins(stairs, floor)) {
      continue;
    }
    const Eigen::Vector3d at = stairs.in_map.to_frame(in_map);
    const double beyond_x_m = std::max({-at.x(), at.x() - stairs.world.length_m(), 0.0});
    const double beyond_y_m = std::max({-at.y(), at.y() - stairs.widest_m, 0.0});
    nearest_m = std::min(nearest_m, std::hypot(beyond_x_m, beyond_y_m));
  }
  return nearest_m;
}

}  // namespace sim
}  // namespace stetro_driver
