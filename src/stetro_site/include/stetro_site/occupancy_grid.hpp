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

#ifndef STETRO_SITE__OCCUPANCY_GRID_HPP_
#define STETRO_SITE__OCCUPANCY_GRID_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stetro_site
{

/// What is known of a cell of a grid map.
enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// What cells nobody has seen are taken for, those outside the grid among them.
enum class Unknown : std::uint8_t {
  kWall,  ///< to drive: a robot keeps off what it does not know
  kFree,  ///< to compare with ranges: only a wall that was seen is a wall
};

/// Whether a cell is taken for a wall.
[[nodiscard]] constexpr bool is_wall(Cell cell, Unknown unknown) noexcept
{
  return cell == Cell::kOccupied || (cell == Cell::kUnknown && unknown == Unknown::kWall);
}

/// A cell by its column (along the grid's x) and row (along its y), from the corner of its origin.
struct CellIndex
{
  int column = 0;
  int row = 0;

  bool operator==(const CellIndex & other) const noexcept
  {
    return column == other.column && row == other.row;
  }
};

/// Where a grid lies in its floor's frame, and how fine it is.
struct GridFrame
{
  int columns = 0;
  int rows = 0;
  double resolution_m = 0.0;                           ///< length of a cell's side
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< outer corner of cell (0, 0)
  double yaw_rad = 0.0;                                ///< of the grid's x axis, CCW
};

/// A floor as square cells, each free, occupied or unknown.
/**
 * Row 0 is the lowest, y runs up: the first row of a map image is the last row here. With the
 * grid's origin o, yaw a and resolution r, the centre of cell (c, w) is
 *
 *   p = o + R(a) r (c + 1/2, w + 1/2)                                                        (1)
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class OccupancyGrid
{
public:
  /// `cells` row by row from row 0, `columns * rows` of them.
  /** \throws std::invalid_argument naming what is not finite, not positive or of another size */
  OccupancyGrid(const GridFrame & frame, std::vector<Cell> cells);

  [[nodiscard]] const GridFrame & frame() const noexcept { return frame_; }
  [[nodiscard]] int columns() const noexcept { return frame_.columns; }
  [[nodiscard]] int rows() const noexcept { return frame_.rows; }
  [[nodiscard]] double resolution_m() const noexcept { return frame_.resolution_m; }

  /// All cells row by row from row 0.
  [[nodiscard]] const std::vector<Cell> & cells() const noexcept { return cells_; }

  [[nodiscard]] bool contains(CellIndex cell) const noexcept
  {
    return cell.column >= 0 && cell.column < frame_.columns && cell.row >= 0 &&
           cell.row < frame_.rows;
  }

  /// Position of a cell of the grid in `cells()`.
  [[nodiscard]] std::size_t offset(CellIndex cell) const noexcept
  {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(frame_.columns) +
           static_cast<std::size_t>(cell.column);
  }

  /// The cell of that position in `cells()`: the way back of `offset`.
  [[nodiscard]] CellIndex cell(std::size_t offset) const noexcept
  {
    const auto at = static_cast<int>(offset);
    return {at % frame_.columns, at / frame_.columns};
  }

  /// What is known of a cell; outside the grid nothing is: unknown.
  [[nodiscard]] Cell at(CellIndex cell) const noexcept
  {
    return contains(cell) ? cells_[offset(cell)] : Cell::kUnknown;
  }

  /// A point of the floor in the grid's own axes, in cells from the outer corner of cell (0, 0).
  [[nodiscard]] Eigen::Vector2d to_cells(const Eigen::Vector2d & point_m) const;

  /// The way back, eq. (1) for fractions of cells.
  [[nodiscard]] Eigen::Vector2d to_floor_m(const Eigen::Vector2d & in_cells) const;

  /// The cell that a point of the floor lies in; it may lie outside the grid.
  [[nodiscard]] CellIndex cell_at(const Eigen::Vector2d & point_m) const;

  /// The centre of a cell in the floor's frame, eq. (1) [m].
  [[nodiscard]] Eigen::Vector2d centre_m(CellIndex cell) const;

private:
  GridFrame frame_;
  std::vector<Cell> cells_;
  Eigen::Matrix2d rotation_;  ///< R(a), grid to floor
};

}  // namespace stetro_site

#endif  // STETRO_SITE__OCCUPANCY_GRID_HPP_
