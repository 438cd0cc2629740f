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

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "stetro_supervisor/four_beams/beam_search.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;
using Cells = std::vector<CellIndex>;

constexpr double kPi = 3.14159265358979323846;

// Row 0 is walled at columns 0 and 9; what is behind the wall of row 1 nobody saw.
struct TwoCorridors
{
  OccupancyGrid grid = drawn(
    {"#....??...",  // row 1
     "#........#"});
  ReachTable east{grid, 0.0};
  ReachTable west{grid, kPi};
};

TEST(BeamSearch, AnswersIntervals)
{
  const TwoCorridors at;
  // West 2 to 3, east 6 to 7 of row 0 (d_W + d_E = 9). In row 1 the unknown cells may be free:
  // columns 2 and 3 can see as far to the east, and 7 to 9 may see anything on either side.
  const auto found = cells_agreeing(at.grid, {{&at.west, 2, 3}, {&at.east, 6, 7}}, 2);
  EXPECT_EQ(found.cells, (Cells{{2, 0}, {3, 0}, {2, 1}, {3, 1}, {7, 1}, {8, 1}, {9, 1}}));
  EXPECT_EQ(found.supporting, (std::vector<std::uint8_t>{2, 2, 1, 1, 0, 0, 0}));
  EXPECT_EQ(found.best(), (Cells{{2, 0}, {3, 0}}));
}

// D4-11: no return says that the wall is far.
TEST(BeamSearch, TakesNoReturnForAnInequality)
{
  const TwoCorridors at;
  const auto found = cells_agreeing(at.grid, {{&at.east, 7, kNoReturn}, {&at.west, 1, 1}}, 2);
  EXPECT_EQ(found.cells, (Cells{{1, 0}, {1, 1}, {7, 1}}));
  EXPECT_EQ(found.best(), (Cells{{1, 0}})) << "a known wall supports, the unknown does not";
}

// D4-12: an empty set is the normal result of one wrong beam.
TEST(BeamSearch, AsksForLessWhenABeamIsWrong)
{
  const auto grid = drawn(
    {"#######",  //
     "#.....#",  //
     "#.....#",  //
     "#.....#",  //
     "#######"});
  std::vector<ReachTable> tables;
  for (int i = 0; i < 4; ++i) {
    tables.emplace_back(grid, i * kPi / 2);  // east, north, west, south
  }
  // From (2, 1): 4, 3, 2, 1; north is read as 2.
  const std::vector<BeamInterval> beams{
    {&tables[0], 4, 4}, {&tables[1], 2, 2}, {&tables[2], 2, 2}, {&tables[3], 1, 1}};
  EXPECT_TRUE(cells_agreeing(grid, beams, 4).cells.empty());
  const auto best = best_agreeing(grid, beams);
  EXPECT_EQ(best.beams, 4U);
  EXPECT_EQ(best.least_agreeing, 3U);
  EXPECT_EQ(best.cells, (Cells{{2, 1}, {2, 2}}));  // (2, 2) fits north and not south
}

// Property: with w wrong beams of n, the cells that n - w agree with hold the truth.
TEST(BeamSearch, HoldsTheTruthDespiteWrongBeams)
{
  std::mt19937 random{20240517};
  GridFrame frame;
  frame.columns = 50;
  frame.rows = 40;
  frame.resolution_m = 0.1;
  RoomContents contents;
  contents.boxes = 5;
  contents.unknown_patches = 2;
  const OccupancyGrid grid = random_room(frame, contents, random);
  std::vector<ReachTable> tables;
  for (const double heading_rad : {0.0, 0.4, 1.7, 2.9, -2.0, -0.9}) {
    tables.emplace_back(grid, heading_rad);
  }
  const Cells places = free_cells(grid);
  std::uniform_int_distribution<std::size_t> any(0, places.size() - 1);
  std::uniform_int_distribution<int> wild(0, 60);
  for (std::size_t query = 0; query < 300; ++query) {
    const CellIndex truth = places[any(random)];
    const std::size_t wrong = query % 3;
    std::vector<BeamInterval> beams;
    for (const ReachTable & table : tables) {
      const Reach reach = table.at(grid.offset(truth));
      beams.push_back({&table, reach.first, std::min<int>(reach.first + 2, reach.last)});
    }
    for (std::size_t i = 0; i < wrong; ++i) {
      beams[i].shortest = beams[i].longest = wild(random);
    }
    const auto found = cells_agreeing(grid, beams, beams.size() - wrong);
    EXPECT_NE(std::find(found.cells.begin(), found.cells.end(), truth), found.cells.end());
    const auto best = best_agreeing(grid, beams);
    EXPECT_GE(best.least_agreeing, beams.size() - wrong);
    EXPECT_FALSE(best.cells.empty());
  }
}

TEST(BeamSearch, RefusesWhatIsNoQuestion)
{
  const TwoCorridors at;
  const auto other = drawn({"."});
  const ReachTable of_other(other, 0.0);
  EXPECT_THROW(cells_agreeing(at.grid, {}, 1), std::invalid_argument);
  EXPECT_THROW(cells_agreeing(at.grid, {{nullptr, 1, 1}}, 1), std::invalid_argument);
  EXPECT_THROW(cells_agreeing(at.grid, {{&of_other, 1, 1}}, 1), std::invalid_argument);
  EXPECT_THROW(cells_agreeing(at.grid, {{&at.east, 1, 1}}, 0), std::invalid_argument);
  EXPECT_THROW(cells_agreeing(at.grid, {{&at.east, 1, 1}}, 2), std::invalid_argument);
  EXPECT_TRUE(AgreeingCells{}.best().empty());
}

}  // namespace
}  // namespace stetro_supervisor
