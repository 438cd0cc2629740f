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
#include <set>
#include <tuple>
#include <vector>

#include "random_scenes.hpp"
#include "wall_tree.hpp"

namespace stetro_site
{
namespace
{

using Ends = std::tuple<double, double, double, double>;

/// Goes through a tree from a node on, collects the walls and looks whether boxes hold them.
void collect(const WallTree & tree, std::int32_t at, int depth, std::multiset<Ends> & walls)
{
  ASSERT_LE(depth, WallTree::kDeepest);
  const BoxNode & node = tree.nodes()[static_cast<std::size_t>(at)];
  for (int lane = 0; lane < node.count; ++lane) {
    std::multiset<Ends> below;
    const std::int32_t child = node.child[lane];
    if (child >= 0) {
      collect(tree, child, depth + 1, below);
    } else {
      const WallBlock & block = tree.blocks()[static_cast<std::size_t>(-1 - child)];
      for (int i = 0; i < block.count; ++i) {
        below.emplace(block.ax[i], block.ay[i], block.bx[i], block.by[i]);
      }
    }
    for (const auto & [ax, ay, bx, by] : below) {
      EXPECT_LE(node.min_x[lane], std::min(ax, bx));
      EXPECT_LE(node.min_y[lane], std::min(ay, by));
      EXPECT_GE(node.max_x[lane], std::max(ax, bx));
      EXPECT_GE(node.max_y[lane], std::max(ay, by));
    }
    walls.merge(below);
  }
}

TEST(WallTree, HoldsEachWallOnceInItsBoxes)
{
  for (const std::size_t count : {4U, 8U, 12U, 64U, 68U, 512U, 516U, 4000U}) {
    const std::vector<Segment> room = RandomRoom(count, 0, 2).walls;
    const WallTree tree(room, WallSides::kBoth);
    std::multiset<Ends> wanted;
    for (const Segment & wall : room) {
      wanted.emplace(wall.from_m.x(), wall.from_m.y(), wall.to_m.x(), wall.to_m.y());
    }
    std::multiset<Ends> found;
    collect(tree, 0, 1, found);
    EXPECT_EQ(found, wanted) << count << " walls";
    EXPECT_EQ(tree.blocks().size(), (count + 7) / 8) << "all full but the last";
  }
}

TEST(WallTree, ManyWallsInOnePlaceDoNoHarm)
{
  const std::vector<Segment> walls(1000, Segment{{1.0, 2.0}, {3.0, 4.0}});
  std::multiset<Ends> found;
  collect(WallTree(walls, WallSides::kBoth), 0, 1, found);
  EXPECT_EQ(found.size(), walls.size());
}

TEST(WallTree, IsEmptyWithoutWalls) { EXPECT_TRUE(WallTree({}, WallSides::kBoth).empty()); }

}  // namespace
}  // namespace stetro_site
