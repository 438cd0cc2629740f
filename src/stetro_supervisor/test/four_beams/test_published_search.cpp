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

#include "stetro_supervisor/four_beams/published_search.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;
using Cells = std::vector<CellIndex>;

/// What the beams measure at a place; nothing if one of them ends in the unknown.
std::optional<PerAzimuth<int>> reading(const OccupancyGrid & grid, CellIndex place)
{
  PerAzimuth<int> distances{};
  for (const Azimuth azimuth : kAzimuths) {
    const auto distance = beam_distance(grid, place, azimuth);
    if (!distance) {
      return std::nullopt;
    }
    distances[position(azimuth)] = *distance;
  }
  return distances;
}

OccupancyGrid room(int seed, int unknown_patches)
{
  GridFrame frame;
  frame.columns = 40;
  frame.rows = 30;
  frame.resolution_m = 0.1;
  std::mt19937 random{static_cast<unsigned>(seed)};
  RoomContents contents;
  contents.unknown_patches = unknown_patches;
  contents.loose_cells = 20;
  return random_room(frame, contents, random);
}

// Eq. (1) and (2) by hand.
TEST(PublishedSearch, HypothesesOfOneBeamByHand)
{
  const auto grid = drawn(
    {"##.#",    // row 3
     "#..#",    // row 2
     "..#.",    // row 1
     "#..?"});  // row 0
  // North by 2: (1, 1) sees the wall (1, 3) freely, (0, 1) and (3, 1) only through the walls (0, 2)
  // and (3, 2); from row 0, (1, 0) comes to (1, 2) and (2, 0) to (2, 2), both free.
  EXPECT_EQ(
    hypotheses(grid, Azimuth::kNorth, 2, BeamPath::kIgnored), (Cells{{0, 1}, {1, 1}, {3, 1}}));
  EXPECT_EQ(hypotheses(grid, Azimuth::kNorth, 2, BeamPath::kTracked), (Cells{{1, 1}}));
  EXPECT_EQ(
    hypotheses(grid, Azimuth::kWest, 1, BeamPath::kTracked),
    (Cells{{1, 0}, {3, 1}, {1, 2}, {2, 3}}));
  EXPECT_TRUE(hypotheses(grid, Azimuth::kWest, 0, BeamPath::kIgnored).empty());
}

// D4-7: what is not known is no proof of a free way, and no obstacle either.
TEST(PublishedSearch, AnUnknownCellBlocksMethod1Only)
{
  const auto grid = drawn({".?.#"});
  EXPECT_EQ(hypotheses(grid, Azimuth::kEast, 3, BeamPath::kIgnored), (Cells{{0, 0}}));
  EXPECT_TRUE(hypotheses(grid, Azimuth::kEast, 3, BeamPath::kTracked).empty());
  EXPECT_TRUE(hypotheses(grid, Azimuth::kEast, 1, BeamPath::kIgnored) == (Cells{{2, 0}}));
  EXPECT_FALSE(beam_distance(grid, {0, 0}, Azimuth::kEast).has_value());
  EXPECT_FALSE(beam_distance(grid, {0, 0}, Azimuth::kNorth).has_value()) << "beyond the grid";
}

// The middle of a plus sign is the only place with two free cells in all directions.
TEST(PublishedSearch, NamesTheOnlyPlace)
{
  const auto grid = drawn(
    {"?###?",  //
     "?#.#?",  //
     "##.##",  //
     "#...#",  //
     "##.##",  //
     "?#.#?",  //
     "?###?"});
  EXPECT_EQ(published_search(grid, {3, 2, 3, 2}, BeamPath::kTracked), (Cells{{2, 3}}));
  EXPECT_EQ(published_search(grid, {3, 2, 3, 2}, BeamPath::kIgnored), (Cells{{2, 3}}));
  EXPECT_TRUE(published_search(grid, {3, 3, 3, 2}, BeamPath::kTracked).empty());
}

// D4-10: method 2 places the robot "through" walls where method 1 does not.
TEST(PublishedSearch, Method2SeesThroughWalls)
{
  const auto grid = drawn(
    {"#######",  //
     "#..#..#",  //
     "#######"});
  // From (1, 1), reading 5 in the east would need to pass the wall at 3.
  EXPECT_TRUE(published_search(grid, {1, 5, 1, 1}, BeamPath::kTracked).empty());
  EXPECT_EQ(published_search(grid, {1, 5, 1, 1}, BeamPath::kIgnored), (Cells{{1, 1}}));
  EXPECT_TRUE(hybrid_search(grid, {1, 5, 1, 1}).empty());
}

class RandomRooms : public testing::TestWithParam<int>
{
};

// Method 1 finds the place and is what the hybrid finds; method 2 finds that and more; both ways of
// searching for hypotheses find the same, in the same order.
TEST_P(RandomRooms, MethodsContainOneAnother)
{
  const OccupancyGrid grid = room(GetParam(), GetParam() % 2 == 0 ? 0 : 3);
  const Cells places = free_cells(grid);
  std::mt19937 random{7};
  std::uniform_int_distribution<std::size_t> any(0, places.size() - 1);
  for (int i = 0; i < 50; ++i) {
    const CellIndex place = places[any(random)];
    const auto distances = reading(grid, place);
    if (!distances) {
      continue;
    }
    const Cells method_1 = published_search(grid, *distances, BeamPath::kTracked);
    const Cells method_2 = published_search(grid, *distances, BeamPath::kIgnored);
    EXPECT_NE(std::find(method_1.begin(), method_1.end(), place), method_1.end());
    for (const CellIndex & cell : method_1) {
      EXPECT_NE(std::find(method_2.begin(), method_2.end(), cell), method_2.end());
    }
    EXPECT_EQ(hybrid_search(grid, *distances), method_1);
    constexpr auto kBack = HypothesisSearch::kFromObstacles;
    EXPECT_EQ(published_search(grid, *distances, BeamPath::kTracked, kBack), method_1);
    EXPECT_EQ(published_search(grid, *distances, BeamPath::kIgnored, kBack), method_2);
    EXPECT_EQ(hybrid_search(grid, *distances, kBack), method_1);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRooms, testing::Range(1, 11));

}  // namespace
}  // namespace stetro_supervisor
