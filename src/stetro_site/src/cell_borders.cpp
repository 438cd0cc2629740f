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

#include "cell_borders.hpp"

namespace stetro_site
{

namespace
{

/// Which side of a line between two rows or columns of cells is free, where only one is.
enum class FreeSide { kNone, kBefore, kBehind };

/// Borders along one line of a grid as they come, cell by cell.
class BorderLine
{
public:
  /// Before a vertical line lies the column on its left, before a horizontal one the row below.
  BorderLine(bool vertical, int at, std::vector<Segment> & borders)
  : vertical_(vertical), at_(at), borders_(borders)
  {
  }

  /// Takes the next cells along the line, at `along`; past the last ones neither stops.
  void take(int along, bool before_stops, bool behind_stops)
  {
    const FreeSide free = before_stops == behind_stops ? FreeSide::kNone
                          : before_stops               ? FreeSide::kBehind
                                                       : FreeSide::kBefore;
    if (free == free_) {
      return;
    }
    if (free_ != FreeSide::kNone) {
      end_piece(along);
    }
    free_ = free;
    start_ = along;
  }

private:
  /// On the left of the way up lies what is before, on the left of the way right what is behind.
  void end_piece(int end)
  {
    const bool forwards = (free_ == FreeSide::kBefore) == vertical_;
    const Eigen::Vector2d low = point(start_);
    const Eigen::Vector2d high = point(end);
    borders_.push_back(forwards ? Segment{low, high} : Segment{high, low});
  }

  [[nodiscard]] Eigen::Vector2d point(int along) const
  {
    return vertical_ ? Eigen::Vector2d(at_, along) : Eigen::Vector2d(along, at_);
  }

  bool vertical_;
  int at_;
  std::vector<Segment> & borders_;
  FreeSide free_ = FreeSide::kNone;
  int start_ = 0;
};

}  // namespace

std::vector<Segment> cell_borders(const OccupancyGrid & grid, Unknown unknown)
{
  std::vector<Segment> borders;
  const auto stops_at = [&](int column, int row) {
    return is_wall(grid.at({column, row}), unknown);
  };
  for (int column = 0; column <= grid.columns(); ++column) {
    BorderLine line(true, column, borders);
    for (int row = 0; row < grid.rows(); ++row) {
      line.take(row, stops_at(column - 1, row), stops_at(column, row));
    }
    line.take(grid.rows(), false, false);
  }
  for (int row = 0; row <= grid.rows(); ++row) {
    BorderLine line(false, row, borders);
    for (int column = 0; column < grid.columns(); ++column) {
      line.take(column, stops_at(column, row - 1), stops_at(column, row));
    }
    line.take(grid.columns(), false, false);
  }
  return borders;
}

}  // namespace stetro_site
