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

#include "stetro_site/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stetro_site
{
namespace
{

// Whole numbers throughout: lengths in halves of a cell, squares in quarters of a cell's area.
constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();  // no wall in the column

std::int64_t floor_divided(std::int64_t a, std::int64_t b)  // b > 0
{
  return a / b - (a % b < 0 ? 1 : 0);
}

/// The lower envelope of parabolas (x - position)^2 + height, given in the order of positions.
class Envelope
{
public:
  explicit Envelope(std::size_t most)
  {
    parabolas_.reserve(most);
    from_.reserve(most);
  }

  void clear()
  {
    parabolas_.clear();
    from_.clear();
  }

  void add(std::int64_t position, std::int64_t height)
  {
    const Parabola next{position, height};
    while (!parabolas_.empty() && first_below(parabolas_.back(), next) <= from_.back()) {
      parabolas_.pop_back();
      from_.pop_back();
    }
    from_.push_back(
      parabolas_.empty() ? std::numeric_limits<std::int64_t>::min()
                         : first_below(parabolas_.back(), next));
    parabolas_.push_back(next);
  }

  [[nodiscard]] bool empty() const { return parabolas_.empty(); }

  /// The lowest at x; `at` is where to look from, and moves up as x does.
  [[nodiscard]] std::int64_t lowest(std::int64_t x, std::size_t & at) const
  {
    while (at + 1 < parabolas_.size() && from_[at + 1] <= x) {
      ++at;
    }
    const std::int64_t away = x - parabolas_[at].position;
    return away * away + parabolas_[at].height;
  }

private:
  struct Parabola
  {
    std::int64_t position;
    std::int64_t height;
  };

  /// The first whole x at which `right` is below `left`.
  static std::int64_t first_below(const Parabola & left, const Parabola & right)
  {
    const std::int64_t rise =
      right.position * right.position - left.position * left.position + right.height - left.height;
    return floor_divided(rise, 2 * (right.position - left.position)) + 1;
  }

  std::vector<Parabola> parabolas_;
  std::vector<std::int64_t> from_;  ///< the first whole x at which each is the lowest
};

/// The gap of a cell beside one with this gap: a wall's edge is half a cell from the next centre.
std::int32_t beside(std::int32_t gap) { return gap == 0 ? 1 : gap == kFar ? kFar : gap + 2; }

/// g of eq. (1) along the columns, row by row: from each cell to the nearest wall above or below.
std::vector<std::int32_t> gaps_along_columns(const OccupancyGrid & grid, Unknown unknown)
{
  const auto columns = static_cast<std::size_t>(grid.columns());
  const std::size_t count = grid.cells().size();
  const std::int32_t at_rim = unknown == Unknown::kWall ? 1 : kFar;
  std::vector<std::int32_t> gaps(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t gap = i < columns ? at_rim : beside(gaps[i - columns]);
    gaps[i] = is_wall(grid.cells()[i], unknown) ? 0 : gap;
  }
  for (std::size_t i = count; i-- > 0;) {
    gaps[i] = std::min(gaps[i], i + columns >= count ? at_rim : beside(gaps[i + columns]));
  }
  return gaps;
}

/// Squares of eq. (1) along one row, whose cells have these gaps along their columns.
class Row
{
public:
  Row(std::size_t columns, Unknown unknown)
  : has_rim_(unknown == Unknown::kWall), columns_(columns), envelope_(columns + 1)
  {
  }

  /// Line k between the columns k - 1 and k is an edge of both: 2 k - 1 halves from cell 0.
  void trace(const std::int32_t * gaps)
  {
    envelope_.clear();
    for (std::size_t k = 0; k <= columns_; ++k) {
      const std::int64_t outside = has_rim_ ? 0 : kFar;
      const std::int64_t left = k > 0 ? gaps[k - 1] : outside;
      const std::int64_t right = k < columns_ ? gaps[k] : outside;
      const std::int64_t gap = std::min(left, right);
      if (gap != kFar) {
        envelope_.add(2 * static_cast<std::int64_t>(k) - 1, gap * gap);
      }
    }
  }

  /// Of each cell, and its own column besides: straight up or down no edge line is crossed.
  template <class Take>
  void read(const std::int32_t * gaps, const Take & take) const
  {
    std::size_t at = 0;
    for (std::size_t column = 0; column < columns_; ++column) {
      if (envelope_.empty()) {
        take(column, std::numeric_limits<double>::infinity());
        continue;
      }
      const std::int64_t own = gaps[column];
      const std::int64_t around = envelope_.lowest(2 * static_cast<std::int64_t>(column), at);
      take(column, static_cast<double>(std::min(own * own, around)));
    }
  }

private:
  bool has_rim_;
  std::size_t columns_;
  Envelope envelope_;
};

}  // namespace

DistanceField::DistanceField(std::shared_ptr<const OccupancyGrid> grid, Unknown unknown)
: grid_(std::move(grid)), unknown_(unknown)
{
  if (!grid_) {
    throw std::invalid_argument("distance field: no grid, a grid wanted");
  }
  const std::vector<std::int32_t> gaps = gaps_along_columns(*grid_, unknown);
  const double half_m = 0.5 * grid_->resolution_m();
  const auto columns = static_cast<std::size_t>(grid_->columns());
  distances_m_.resize(gaps.size());
  Row row{columns, unknown};
  for (std::size_t first = 0; first < gaps.size(); first += columns) {
    row.trace(&gaps[first]);
    row.read(&gaps[first], [&](std::size_t column, double squares) {
      distances_m_[first + column] = static_cast<float>(half_m * std::sqrt(squares));
    });
  }
}

bool DistanceField::is_wall(CellIndex cell) const noexcept
{
  return stetro_site::is_wall(grid_->at(cell), unknown_);
}

double DistanceField::clearance_m(const Eigen::Vector2d & point_m) const
{
  const Eigen::Vector2d at = grid_->to_cells(point_m);
  const Eigen::Vector2d size(grid_->columns(), grid_->rows());
  const Eigen::Vector2d beyond = (-at).cwiseMax(at - size).cwiseMax(0.0);
  if (!at.allFinite() || beyond.maxCoeff() > 0.0) {
    return unknown_ == Unknown::kWall ? 0.0 : beyond.norm() * grid_->resolution_m();
  }
  const CellIndex first{
    static_cast<int>(std::floor(at.x() - 0.5)), static_cast<int>(std::floor(at.y() - 0.5))};
  double least_m = 0.0;
  for (const CellIndex step : {CellIndex{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    const CellIndex cell{first.column + step.column, first.row + step.row};
    if (grid_->contains(cell)) {
      const Eigen::Vector2d centre(cell.column + 0.5, cell.row + 0.5);
      const double way_m = (at - centre).norm() * grid_->resolution_m();
      least_m = std::max(least_m, distance_m(cell) - way_m);
    }
  }
  return least_m;
}

}  // namespace stetro_site
