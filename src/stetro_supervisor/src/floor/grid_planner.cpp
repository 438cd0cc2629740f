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

#include "stetro_supervisor/floor/grid_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

namespace stetro_supervisor
{
namespace
{

using stetro_site::CellIndex;
using stetro_site::DistanceField;
using stetro_site::OccupancyGrid;

constexpr double kEscape_m = 0.60;  // how far off a place is looked for when the start has none
constexpr int kPulls = 4;
constexpr int kHalvings = 8;
constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();

constexpr CellIndex kSteps[] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};

std::string place(const Eigen::Vector2d & point_m)
{
  const auto cm = [](double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.size() - 4);
  };
  return "(" + cm(point_m.x()) + ", " + cm(point_m.y()) + ")";
}

}  // namespace

double FloorPath::length_m() const
{
  double length = 0.0;
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    length += (corners_m[i] - corners_m[i - 1]).norm();
  }
  return length;
}

/// One search over the cells.
class GridPlanner::Search
{
public:
  explicit Search(const GridPlanner & planner)
  : planner_(planner),
    grid_(planner.field_->grid()),
    cost_m_(grid_.cells().size(), std::numeric_limits<double>::infinity()),
    parent_(grid_.cells().size(), kNobody),
    closed_(grid_.cells().size(), false)
  {
  }

  /// The corners from the one to the other; empty if there is no way.
  Cells run(CellIndex from, CellIndex to)
  {
    goal_m_ = grid_.centre_m(to);
    const std::size_t start = grid_.offset(from);
    cost_m_[start] = 0.0;
    parent_[start] = start;
    open(start);
    while (!open_.empty()) {
      const std::size_t cell = open_.top().second;
      open_.pop();
      if (closed_[cell]) {
        continue;
      }
      closed_[cell] = true;
      settle(cell);
      if (cell == grid_.offset(to)) {
        return trace(cell);
      }
      expand(cell);
    }
    return {};
  }

private:
  Eigen::Vector2d centre_m(std::size_t cell) const { return grid_.centre_m(grid_.cell(cell)); }

  void open(std::size_t cell)
  {
    open_.push({cost_m_[cell] + (goal_m_ - centre_m(cell)).norm(), cell});
  }

  /// The parent was taken on trust: where it does not see the cell, the best neighbour is.
  void settle(std::size_t cell)
  {
    const std::size_t parent = parent_[cell];
    if (parent == cell || planner_.is_clear(centre_m(parent), centre_m(cell))) {
      return;
    }
    cost_m_[cell] = std::numeric_limits<double>::infinity();
    for_each_neighbour(cell, [&](std::size_t other) {
      const double cost = cost_m_[other] + (centre_m(other) - centre_m(cell)).norm();
      if (closed_[other] && cost < cost_m_[cell]) {
        cost_m_[cell] = cost;
        parent_[cell] = other;
      }
    });
  }

  void expand(std::size_t cell)
  {
    const std::size_t parent = parent_[cell];
    for_each_neighbour(cell, [&](std::size_t other) {
      const double cost = cost_m_[parent] + (centre_m(parent) - centre_m(other)).norm();
      if (!closed_[other] && cost < cost_m_[other]) {
        cost_m_[other] = cost;
        parent_[other] = parent;
        open(other);
      }
    });
  }

  template <class Visit>
  void for_each_neighbour(std::size_t cell, Visit && visit)
  {
    const CellIndex at = grid_.cell(cell);
    for (const CellIndex step : kSteps) {
      const CellIndex next{at.column + step.column, at.row + step.row};
      if (planner_.is_passable(next)) {
        visit(grid_.offset(next));
      }
    }
  }

  Cells trace(std::size_t cell) const
  {
    Cells cells{grid_.cell(cell)};
    while (parent_[cell] != cell) {
      cell = parent_[cell];
      cells.push_back(grid_.cell(cell));
    }
    std::reverse(cells.begin(), cells.end());
    return cells;
  }

  using Ranked = std::pair<double, std::size_t>;

  const GridPlanner & planner_;
  const OccupancyGrid & grid_;
  Eigen::Vector2d goal_m_ = Eigen::Vector2d::Zero();
  std::vector<double> cost_m_;
  std::vector<std::size_t> parent_;
  std::vector<bool> closed_;
  std::priority_queue<Ranked, std::vector<Ranked>, std::greater<>> open_;
};

GridPlanner::GridPlanner(std::shared_ptr<const DistanceField> field, double clearance_m)
: field_(std::move(field)), clearance_m_(clearance_m)
{
  if (!field_) {
    throw std::invalid_argument("grid planner: no distance field, one wanted");
  }
  if (!(clearance_m > 0.0) || !std::isfinite(clearance_m)) {
    throw std::invalid_argument(
      "grid planner: clearance_m = " + std::to_string(clearance_m) + ", a positive length wanted");
  }
  const double half_diagonal_m = std::sqrt(0.5) * field_->grid().resolution_m();
  passable_m_ = std::hypot(clearance_m, half_diagonal_m);
}

bool GridPlanner::is_passable(CellIndex cell) const
{
  return field_->grid().contains(cell) && field_->distance_m(cell) >= passable_m_;
}

bool GridPlanner::leaves(
  double clearance_m, const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m) const
{
  const double least_step_m = 0.5 * field_->grid().resolution_m();
  const double wanted_m = std::hypot(clearance_m, 0.5 * least_step_m);
  const double length = (to_m - from_m).norm();
  const Eigen::Vector2d along = length > 0.0 ? Eigen::Vector2d((to_m - from_m) / length)
                                             : Eigen::Vector2d(Eigen::Vector2d::Zero());
  for (double at = 0.0; at < length;) {
    const double left_m = field_->clearance_m(from_m + at * along);
    if (left_m < wanted_m) {
      return false;
    }
    at += std::max(left_m - wanted_m, least_step_m);
  }
  return field_->clearance_m(to_m) >= wanted_m;
}

/// Where the search may begin for a point: its own cell, or the nearest it can go straight to.
std::optional<CellIndex> GridPlanner::cell_near(const Eigen::Vector2d & point_m) const
{
  const OccupancyGrid & grid = field_->grid();
  const CellIndex own = grid.cell_at(point_m);
  const double stands_m =
    std::min(clearance_m_, std::max(0.0, field_->clearance_m(point_m) - grid.resolution_m()));
  const int reach = static_cast<int>(std::ceil(kEscape_m / grid.resolution_m()));
  std::optional<CellIndex> best;
  double least = kEscape_m;
  for (int row = own.row - reach; row <= own.row + reach; ++row) {
    for (int column = own.column - reach; column <= own.column + reach; ++column) {
      const CellIndex cell{column, row};
      if (!is_passable(cell)) {
        continue;
      }
      const Eigen::Vector2d centre = grid.centre_m(cell);
      const double way = (centre - point_m).norm();
      if (way < least && leaves(stands_m, point_m, centre)) {
        least = way;
        best = cell;
      }
    }
  }
  return best;
}

FloorPath GridPlanner::plan(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m) const
{
  const auto none = [](const std::string & why) { return FloorPath{{}, why}; };
  if (!from_m.allFinite() || !to_m.allFinite()) {
    return none("start or goal is not a number");
  }
  const auto start = cell_near(from_m);
  if (!start) {
    return none("the robot stands in a wall of the map, at " + place(from_m) + " m");
  }
  const auto goal = cell_near(to_m);
  if (!goal || !leaves(clearance_m_, to_m, field_->grid().centre_m(*goal))) {
    return none("the goal " + place(to_m) + " m is nearer to a wall than the body's clearance");
  }
  if (is_clear(from_m, to_m)) {
    return {{from_m, to_m}, ""};
  }
  const Cells cells = Search(*this).run(*start, *goal);
  if (cells.empty()) {
    return none("no way wide enough from " + place(from_m) + " m to " + place(to_m) + " m");
  }
  FloorPath path;
  path.corners_m.push_back(from_m);
  for (const CellIndex cell : cells) {
    path.corners_m.push_back(field_->grid().centre_m(cell));
  }
  path.corners_m.push_back(to_m);
  // A start too near to a wall leaves it first: that leg and its end stay.
  const bool squeezed = !is_clear(path.corners_m[0], path.corners_m[1]);
  pull_taut(path.corners_m, squeezed ? 2 : 1);
  return path;
}

void GridPlanner::pull_taut(std::vector<Eigen::Vector2d> & corners_m, std::size_t first) const
{
  for (int pull = 0; pull < kPulls; ++pull) {
    for (std::size_t i = first; i + 1 < corners_m.size();) {
      if (is_clear(corners_m[i - 1], corners_m[i + 1])) {
        corners_m.erase(corners_m.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        pull_corner(corners_m, i);
        ++i;
      }
    }
  }
}

/// Moves a corner towards the line between its neighbours, as far as both legs stay clear.
void GridPlanner::pull_corner(std::vector<Eigen::Vector2d> & corners_m, std::size_t i) const
{
  const Eigen::Vector2d before = corners_m[i - 1];
  const Eigen::Vector2d after = corners_m[i + 1];
  const Eigen::Vector2d chord = after - before;
  const double share =
    chord.squaredNorm() > 0.0
      ? std::clamp((corners_m[i] - before).dot(chord) / chord.squaredNorm(), 0.0, 1.0)
      : 0.0;
  const Eigen::Vector2d foot = before + share * chord;
  Eigen::Vector2d clear = corners_m[i];
  Eigen::Vector2d blocked = foot;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const Eigen::Vector2d middle = 0.5 * (clear + blocked);
    const bool fits = is_clear(before, middle) && is_clear(middle, after);
    (fits ? clear : blocked) = middle;
  }
  corners_m[i] = clear;
}

}  // namespace stetro_supervisor
