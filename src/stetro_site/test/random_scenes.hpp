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

#ifndef RANDOM_SCENES_HPP_
#define RANDOM_SCENES_HPP_

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "stetro_site/occupancy_grid.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

constexpr double kTurn = 6.283185307179586;

/// `count` beams round the whole turn.
inline BeamFan full_turn(std::size_t count, double first_rad = 0.0)
{
  return {first_rad, kTurn / static_cast<double>(count), count};
}

/// A box in a room: a square turned by some angle, as a circle about it for what must stay clear.
struct TurnedBox
{
  Eigen::Vector2d centre;
  double radius;
  double angle_rad;

  /// Its corners counter-clockwise.
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners() const
  {
    std::array<Eigen::Vector2d, 4> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double at = angle_rad + 0.25 * kTurn * static_cast<double>(i);
      corners[i] = centre + radius * Eigen::Vector2d(std::cos(at), std::sin(at));
    }
    return corners;
  }
};

/// A square room with boxes that keep clear of each other, and places between them.
struct RandomRoom
{
  static constexpr double kSide = 100.0;

  std::vector<Segment> walls;           ///< the room's four, then four a box
  std::vector<Eigen::Vector2d> places;  ///< outside all boxes

  RandomRoom(std::size_t segments, std::size_t places_wanted, unsigned seed)
  {
    std::mt19937 random{seed};
    const std::size_t wanted = (segments - 4) / 4;
    const double spacing = kSide / std::sqrt(static_cast<double>(wanted) + 1.0);
    std::uniform_real_distribution<double> at{0.0, kSide};
    std::uniform_real_distribution<double> radius{0.05 * spacing, 0.3 * spacing};
    std::uniform_real_distribution<double> angle{0.0, kTurn};
    add({Eigen::Vector2d(0, 0), {kSide, 0}, {kSide, kSide}, {0, kSide}});
    while (boxes_.size() < wanted) {
      const TurnedBox box{{at(random), at(random)}, radius(random), angle(random)};
      if (clear(box.centre, box.radius)) {
        boxes_.push_back(box);
        add(box.corners());
      }
    }
    while (places.size() < places_wanted) {
      const Eigen::Vector2d place(at(random), at(random));
      if (clear(place, 0.01 * spacing)) {
        places.push_back(place);
      }
    }
  }

private:
  void add(const std::array<Eigen::Vector2d, 4> & corners)
  {
    for (std::size_t i = 0; i < 4; ++i) {
      walls.push_back({corners[i], corners[(i + 1) % 4]});
    }
  }

  /// Whether a circle touches neither the room's walls nor a box's circle.
  [[nodiscard]] bool clear(const Eigen::Vector2d & centre, double radius) const
  {
    const double inside = 1.001 * radius;
    if (centre.minCoeff() < inside || centre.maxCoeff() > kSide - inside) {
      return false;
    }
    for (const TurnedBox & box : boxes_) {
      if ((box.centre - centre).norm() < inside + box.radius) {
        return false;
      }
    }
    return true;
  }

  std::vector<TurnedBox> boxes_;
};

/// A walled room of `side` x `side` cells with boxes of 2 to 10 % of its side.
inline OccupancyGrid random_grid_room(int side, int boxes, unsigned seed, double resolution_m = 1.0)
{
  GridFrame frame;
  frame.columns = frame.rows = side;
  frame.resolution_m = resolution_m;
  std::vector<Cell> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  const auto fill = [&](int column, int row, int width, int height) {
    for (int w = row; w < std::min(row + height, side); ++w) {
      for (int c = column; c < std::min(column + width, side); ++c) {
        cells[static_cast<std::size_t>(w * side + c)] = Cell::kOccupied;
      }
    }
  };
  fill(0, 0, side, 1);
  fill(0, side - 1, side, 1);
  fill(0, 0, 1, side);
  fill(side - 1, 0, 1, side);
  std::mt19937 random{seed};
  std::uniform_int_distribution<int> at{0, side - 1};
  std::uniform_int_distribution<int> length{std::max(1, side / 50), std::max(2, side / 10)};
  for (int i = 0; i < boxes; ++i) {
    const int column = at(random);
    const int row = at(random);
    const int width = length(random);
    fill(column, row, width, length(random));
  }
  return OccupancyGrid(frame, cells);
}

/// Random places in the free cells of a grid.
inline std::vector<Eigen::Vector2d> free_places(
  const OccupancyGrid & grid, std::size_t wanted, unsigned seed)
{
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> column{0.0, static_cast<double>(grid.columns())};
  std::uniform_real_distribution<double> row{0.0, static_cast<double>(grid.rows())};
  std::vector<Eigen::Vector2d> places;
  while (places.size() < wanted) {
    const Eigen::Vector2d place = grid.to_floor_m({column(random), row(random)});
    if (grid.at(grid.cell_at(place)) == Cell::kFree) {
      places.push_back(place);
    }
  }
  return places;
}

}  // namespace stetro_site

#endif  // RANDOM_SCENES_HPP_
