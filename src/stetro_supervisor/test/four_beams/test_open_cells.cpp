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

#include <vector>

#include "stetro_supervisor/four_beams/open_cells.hpp"

namespace stetro_supervisor
{
namespace
{

using Cells = std::vector<stetro_site::CellIndex>;

constexpr Reach known(int distance)
{
  return {static_cast<CellDistance>(distance), static_cast<CellDistance>(distance)};
}

constexpr Reach kAny{1, kNoReturn};

Cells find(const OpenCells & open, const PerAzimuth<int> & distances, int tolerance)
{
  Cells cells;
  open.find(distances, tolerance, cells);
  return cells;
}

// North, east, south, west. What is known must fit, what is not may.
TEST(OpenCells, FindsByTheBeamsThatAreKnown)
{
  OpenCells open;
  open.add({known(3), known(7), known(4), kAny}, {1, 1});
  open.add({known(3), known(9), known(4), kAny}, {2, 2});
  open.add({known(5), kAny, Reach{2, 6}, kAny}, {3, 3});
  open.add({kAny, kAny, kAny, kAny}, {4, 4});
  open.sort();
  EXPECT_EQ(open.size(), 4U);
  EXPECT_EQ(find(open, {3, 7, 4, 50}, 0), (Cells{{4, 4}, {1, 1}}));
  EXPECT_EQ(find(open, {3, 8, 4, 50}, 0), (Cells{{4, 4}}));
  EXPECT_EQ(find(open, {3, 8, 4, 50}, 1), (Cells{{4, 4}, {1, 1}, {2, 2}}));
  EXPECT_EQ(find(open, {4, 8, 5, 50}, 1), (Cells{{4, 4}, {3, 3}, {1, 1}, {2, 2}}));
  EXPECT_EQ(find(open, {5, 8, 8, 50}, 0), (Cells{{4, 4}})) << "the south beam meets by 6";
  EXPECT_EQ(find(open, {1, 1, 1, 1}, 100).size(), 4U);
  EXPECT_TRUE(find(open, {-9, 1, 1, 1}, 0).empty());
  EXPECT_EQ(find(open, {1 << 30, 1, 1, 1}, 2), (Cells{})) << "no beam is that long";
}

TEST(OpenCells, LeapsOverWhatLiesBetween)
{
  OpenCells open;
  for (int north = 1; north <= 40; ++north) {
    for (int south = 1; south <= 40; ++south) {
      open.add({known(north), kAny, known(south), kAny}, {north, south});
    }
  }
  open.sort();
  EXPECT_EQ(find(open, {20, 5, 30, 5}, 1).size(), 9U);
  EXPECT_EQ(find(open, {40, 5, 1, 5}, 1).size(), 4U) << "39 and 40, 1 and 2";
}

}  // namespace
}  // namespace stetro_supervisor
