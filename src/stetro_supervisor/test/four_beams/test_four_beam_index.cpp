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

#include "stetro_supervisor/four_beams/four_beam_index.hpp"
#include "stetro_supervisor/four_beams/published_search.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;
using Cells = std::vector<CellIndex>;

Cells find(const FourBeamIndex & index, const PerAzimuth<int> & distances, int tolerance)
{
  Cells cells;
  index.find(distances, tolerance, cells);
  std::sort(cells.begin(), cells.end(), [](CellIndex a, CellIndex b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  });
  return cells;
}

/// First possible obstacle and first certain one, walked cell by cell; far stands for none.
constexpr int kFar = 100000;

struct Walked
{
  int first = kFar;
  int last = kFar;
};

Walked walked(const OccupancyGrid & grid, CellIndex cell, Azimuth azimuth)
{
  Walked found;
  for (int d = 1;; ++d) {
    const CellIndex at{cell.column + d * step(azimuth).column, cell.row + d * step(azimuth).row};
    if (grid.at(at) != Cell::kFree) {
      found.first = std::min(found.first, d);
    }
    if (grid.at(at) == Cell::kOccupied) {
      found.last = d;
    }
    if (found.last != kFar || !grid.contains(at)) {
      return found;
    }
  }
}

/// The set of eq. (1) by asking each free cell.
class BruteForce
{
public:
  explicit BruteForce(const OccupancyGrid & grid) : cells_(free_cells(grid))
  {
    for (const CellIndex & cell : cells_) {
      for (const Azimuth azimuth : kAzimuths) {
        walked_.push_back(walked(grid, cell, azimuth));
      }
    }
  }

  [[nodiscard]] Cells find(const PerAzimuth<int> & distances, int tolerance) const
  {
    Cells found;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      bool possible = true;
      for (std::size_t beam = 0; beam < 4; ++beam) {
        const Walked & at = walked_[4 * i + beam];
        possible = possible && at.first <= distances[beam] + tolerance &&
                   at.last >= distances[beam] - tolerance;
      }
      if (possible) {
        found.push_back(cells_[i]);
      }
    }
    return found;
  }

  [[nodiscard]] const Cells & cells() const { return cells_; }
  [[nodiscard]] const Walked & beam(std::size_t cell, std::size_t azimuth) const
  {
    return walked_[4 * cell + azimuth];
  }

private:
  Cells cells_;
  std::vector<Walked> walked_;
};

TEST(FourBeamIndex, FindsByHand)
{
  const auto grid = drawn(
    {"######",  //
     "#...##",  //
     "#....#",  //
     "######"});
  const FourBeamIndex index(grid);
  EXPECT_EQ(index.size(), 7U);
  EXPECT_EQ(index.open_size(), 0U);
  EXPECT_EQ(find(index, {1, 1, 1, 4}, 0), (Cells{{4, 1}}));
  EXPECT_EQ(find(index, {2, 3, 1, 2}, 0), (Cells{{2, 1}}));
  EXPECT_TRUE(find(index, {2, 2, 2, 2}, 0).empty());
  // Within one of (2, 3, 1, 2): (1, 1) reads (2, 4, 1, 1), (3, 1) reads (2, 2, 1, 3); above,
  // (1, 2) reads (1, 3, 2, 1) and (2, 2) reads (1, 2, 2, 2), but (3, 2) reads 1 in the east.
  EXPECT_EQ(find(index, {2, 3, 1, 2}, 1), (Cells{{1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}}));
}

// A corridor nobody saw the end of: whatever the east beam says from one cell on is possible.
TEST(FourBeamIndex, UnknownCellsCannotExclude)
{
  const auto grid = drawn(
    {"#####",  //
     "#...?",  //
     "#####"});
  const FourBeamIndex index(grid);
  EXPECT_EQ(index.open_size(), 3U);
  EXPECT_EQ(find(index, {1, 700, 1, 2}, 0), (Cells{{2, 1}}));
  EXPECT_EQ(find(index, {1, 2, 1, 2}, 0), (Cells{{2, 1}}));
  EXPECT_TRUE(find(index, {1, 1, 1, 2}, 0).empty()) << "that cell is known to be free";
}

/// Queries of random places, errors within the tolerance: the sets of brute force, with the truth.
void ask_at_random(const OccupancyGrid & grid, int queries, std::mt19937 & random)
{
  const FourBeamIndex index(grid);
  const BruteForce brute(grid);
  std::uniform_int_distribution<std::size_t> any(0, brute.cells().size() - 1);
  for (int query = 0; query < queries; ++query) {
    const std::size_t truth = any(random);
    const int tolerance = query % 4;
    std::uniform_int_distribution<int> error(-tolerance, tolerance);
    PerAzimuth<int> distances{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Walked & beam = brute.beam(truth, i);
      const int last = std::min(beam.last, beam.first + 40);
      distances[i] = std::uniform_int_distribution<int>(beam.first, last)(random) + error(random);
    }
    const Cells found = find(index, distances, tolerance);
    ASSERT_EQ(found, brute.find(distances, tolerance)) << "query " << query;
    ASSERT_NE(std::find(found.begin(), found.end(), brute.cells()[truth]), found.end());
    if (tolerance == 0 && index.open_size() == 0) {
      ASSERT_EQ(found, published_search(grid, distances, BeamPath::kTracked));
    }
  }
}

// 20 rooms of 500 queries; half of the rooms have places where nobody looked.
class RandomQueries : public testing::TestWithParam<int>
{
};

TEST_P(RandomQueries, AnswersWithTheBruteForceSetAndItHoldsTheTruth)
{
  std::mt19937 random{static_cast<unsigned>(GetParam())};
  GridFrame frame;
  frame.columns = 61;
  frame.rows = 83;
  frame.resolution_m = 0.05;
  RoomContents contents;
  contents.unknown_patches = GetParam() % 2 == 0 ? 0 : 3;
  contents.loose_cells = GetParam();
  ask_at_random(random_room(frame, contents, random), 500, random);
}

INSTANTIATE_TEST_SUITE_P(Rooms, RandomQueries, testing::Range(0, 20));

// The largest map of S-G's table 1, then with places nobody looked at.
TEST(FourBeamIndex, AnswersWithTheBruteForceSetOnALargeMap)
{
  GridFrame frame;
  frame.columns = 402;
  frame.rows = 721;
  frame.resolution_m = 0.005;
  RoomContents contents;
  contents.grain = 20;
  std::mt19937 random{12};
  for (const int unknown_patches : {0, 6}) {
    contents.unknown_patches = unknown_patches;
    const OccupancyGrid grid = random_room(frame, contents, random);
    ask_at_random(grid, 300, random);
  }
}

TEST(FourBeamIndex, AnswersNothingToWhatCannotBe)
{
  const FourBeamIndex index(drawn({"###", "#.#", "###"}));
  EXPECT_TRUE(find(index, {-5, 1, 1, 1}, 0).empty());
  EXPECT_TRUE(find(index, {1, 1, 1, 1 << 30}, 2).empty());
  EXPECT_EQ(find(index, {1, 1, 1, 1}, 1000).size(), 1U);
  EXPECT_THROW(find(index, {1, 1, 1, 1}, -1), std::invalid_argument);
  EXPECT_TRUE(find(FourBeamIndex(drawn({"##"})), {1, 1, 1, 1}, 0).empty());
}

}  // namespace
}  // namespace stetro_supervisor
