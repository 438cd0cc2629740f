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

#ifndef SIM__BUILDING_HPP_
#define SIM__BUILDING_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/floor_plan.hpp"
#include "sim/stair_world.hpp"
#include "sim/surroundings.hpp"
#include "stetro_driver/building_shape.hpp"
#include "stetro_driver/sim_errors.hpp"
#include "stetro_site/frame_transform.hpp"

namespace stetro_driver::sim
{

/// A flight as built, where it stands.
struct Stairs
{
  std::string id;
  StairWorld world;
  stetro_site::Pose pose_in_map;  ///< z as built
  stetro_site::FrameTransform in_map;
  std::size_t lower;
  std::size_t upper;
  double widest_m;  ///< drawn or built [m]
  Surroundings around{};
};

/// A floor as drawn, as high as the flights below it were built.
struct Storey
{
  std::string id;
  FloorPlan plan;
  stetro_site::Pose pose_in_map;
  stetro_site::FrameTransform in_map;
};

/// Flights as built and floors as drawn, placed in `map`.
/**
 * x and y are the site's. Heights are the builders': the lowest floor is where the site says, and
 * what follows a flight is as high as the sum of its risers. The first flight draws its errors as
 * one alone does, each other from a stream of its own.
 *
 * A building in which no floor is drawn is one flight and nothing else.
 */
class Building
{
public:
  /// How near a floor's stairs the body counts as at them, along their x [m].
  static constexpr double kAtStairs = 0.6;

  /// \param errors of the builders; null: it is as drawn
  /// \throws std::invalid_argument when a flight is impossible or the shape names what is not there
  Building(const BuildingShape & shape, const SimErrors * errors, std::uint64_t seed);

  [[nodiscard]] const std::vector<Stairs> & flights() const { return flights_; }
  [[nodiscard]] const std::vector<Storey> & floors() const { return floors_; }
  [[nodiscard]] const Stairs & flight(std::size_t i) const { return flights_[i]; }
  [[nodiscard]] const Storey & floor(std::size_t i) const { return floors_[i]; }

  /// Whether there are floors to be on.
  [[nodiscard]] bool has_floors() const { return !floors_.empty(); }

  /// The flight at whose stairs a body on a floor is; the nearest, of two equally near `present`.
  /** Nothing: on the open floor. */
  [[nodiscard]] std::optional<std::size_t> stairs_at(
    std::size_t floor, const Eigen::Vector3d & in_map, std::size_t present) const;

  /// From a point to the nearest flight that joins a floor, seen from above; +inf without any [m].
  [[nodiscard]] double stairs_distance_m(std::size_t floor, const Eigen::Vector3d & in_map) const;

private:
  void place_flights(
    const BuildingShape & shape, std::vector<StairWorld> worlds, const std::vector<double> & z_m);
  void surround(Stairs & stairs) const;
  [[nodiscard]] bool joins(const Stairs & stairs, std::size_t floor) const;
  [[nodiscard]] std::vector<Wall> standing_walls(std::size_t floor, const Stairs & seen_from) const;
  void append_solid(
    const Stairs & solid, const Stairs & seen_from, std::vector<Wall> & walls) const;

  std::vector<Storey> floors_;
  std::vector<Stairs> flights_;
};

/// The parts of a wall outside a rectangle, both in the same axes; none, one or two.
[[nodiscard]] std::vector<Wall> parts_outside(
  const Wall & wall, double min_x_m, double max_x_m, double min_y_m, double max_y_m);

}  // namespace stetro_driver::sim

#endif  // SIM__BUILDING_HPP_
