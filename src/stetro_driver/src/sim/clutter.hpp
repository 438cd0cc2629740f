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

#ifndef SIM__CLUTTER_HPP_
#define SIM__CLUTTER_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/building.hpp"

namespace stetro_driver::sim
{

/// A person's waist, seen from above.
struct Disc
{
  double x_m = 0.0;
  double y_m = 0.0;
  double radius_m = 0.0;
};

/// Distance along a level ray to a disc; +inf when it misses, or starts inside.
[[nodiscard]] double distance_along(const Disc & disc, double x, double y, double dx, double dy);

/// What no drawing of the floors shows: boxes that were left there, and people who walk.
/**
 * Drawn from the seed for each floor with walls, clear of the walls and of the metre before its
 * stairs. The lidar sees them, nothing touches them: people step aside from the robot, and a box is
 * gone while the robot stands where it was. People walk to and fro on straight lines, so that where
 * they are follows from the time alone.
 */
class Clutter
{
public:
  /// \param boxes, people of each floor \param start_m where the robot starts, in map
  Clutter(
    const Building & building, int boxes, int people, std::uint64_t seed, std::size_t start_floor,
    const Eigen::Vector3d & start_m);

  /// What is on a floor now, in its frame. \param x_m, y_m where the robot is
  void look(std::size_t floor, double time_s, double x_m, double y_m);

  [[nodiscard]] const std::vector<Wall> & walls() const { return walls_; }
  [[nodiscard]] const std::vector<Disc> & people() const { return people_; }

private:
  struct Box
  {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0;  ///< of the circle around it
    std::array<Wall, 4> sides{};
  };
  struct Walk
  {
    double from_x_m = 0.0;
    double from_y_m = 0.0;
    double to_x_m = 0.0;
    double to_y_m = 0.0;
    double speed_m_s = 0.0;
    double ahead_m = 0.0;  ///< along the line and back, at time zero
  };
  struct OnFloor
  {
    std::vector<Box> boxes{};
    std::vector<Walk> walks{};
  };

  static Disc at(const Walk & walk, double time_s);

  std::vector<OnFloor> floors_{};
  std::vector<Wall> walls_{};
  std::vector<Disc> people_{};
};

}  // namespace stetro_driver::sim

#endif  // SIM__CLUTTER_HPP_
