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

#include "wall_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <string>

namespace stetro_site
{

namespace
{

using Box = Eigen::AlignedBox2d;
using Walls = std::vector<Segment>::iterator;

/// Part of the walls, in their order.
struct Run
{
  Walls begin;
  Walls end;

  [[nodiscard]] std::ptrdiff_t size() const { return end - begin; }
};

Eigen::Vector2d centre(const Segment & wall) { return 0.5 * (wall.from_m + wall.to_m); }

Box box_about(const Run & run)
{
  Box box;
  for (auto wall = run.begin; wall != run.end; ++wall) {
    box.extend(wall->from_m).extend(wall->to_m);
  }
  return box;
}

/// Sorts a run about one of its walls, across the longer side of the box about all centres.
void sort_about(const Run & run, Walls middle)
{
  Box centres;
  for (auto wall = run.begin; wall != run.end; ++wall) {
    centres.extend(centre(*wall));
  }
  const Eigen::Index axis = centres.sizes().x() >= centres.sizes().y() ? 0 : 1;
  std::nth_element(run.begin, middle, run.end, [axis](const Segment & a, const Segment & b) {
    return centre(a)[axis] < centre(b)[axis];
  });
}

/// Cuts a run into pieces of `most` walls that lie together; only one may have fewer.
void cut(const Run & run, std::ptrdiff_t most, std::vector<Run> & pieces)
{
  if (run.size() <= most) {
    pieces.push_back(run);
    return;
  }
  const std::ptrdiff_t whole = (run.size() + most - 1) / most;
  const Walls middle = run.begin + whole / 2 * most;
  sort_about(run, middle);
  cut({run.begin, middle}, most, pieces);
  cut({middle, run.end}, most, pieces);
}

/// At most eight pieces, such that all below them are full but for the last.
std::vector<Run> split(const Run & all)
{
  std::ptrdiff_t most = kLanes;
  while (most * kLanes < all.size()) {
    most *= kLanes;
  }
  std::vector<Run> pieces;
  cut(all, most, pieces);
  return pieces;
}

WallBlock block_of(const Run & run)
{
  WallBlock block{};
  block.count = static_cast<std::int32_t>(run.size());
  for (int lane = 0; lane < kLanes; ++lane) {
    const Segment & wall = *(run.begin + std::min<std::ptrdiff_t>(lane, run.size() - 1));
    block.ax[lane] = wall.from_m.x();
    block.ay[lane] = wall.from_m.y();
    block.bx[lane] = wall.to_m.x();
    block.by[lane] = wall.to_m.y();
  }
  return block;
}

/// Grows nodes and blocks from runs of walls.
struct Growth
{
  std::vector<BoxNode> & nodes;
  std::vector<WallBlock> & blocks;

  /// Adds a node of these walls with all that is below it; answers where it is.
  std::int32_t add_node(const Run & run)
  {
    const auto at = static_cast<std::int32_t>(nodes.size());
    nodes.emplace_back();
    const std::vector<Run> parts = split(run);
    BoxNode node{};
    node.count = static_cast<std::int32_t>(parts.size());
    for (int lane = 0; lane < kLanes; ++lane) {
      const bool repeated = lane >= node.count;
      const Run & part = repeated ? parts.back() : parts[static_cast<std::size_t>(lane)];
      const Box box = box_about(part);
      node.min_x[lane] = box.min().x();
      node.min_y[lane] = box.min().y();
      node.max_x[lane] = box.max().x();
      node.max_y[lane] = box.max().y();
      node.child[lane] = repeated ? node.child[lane - 1] : add_child(part);
    }
    nodes[static_cast<std::size_t>(at)] = node;
    return at;
  }

  std::int32_t add_child(const Run & run)
  {
    if (run.size() > kLanes) {
      return add_node(run);
    }
    blocks.push_back(block_of(run));
    return -static_cast<std::int32_t>(blocks.size());
  }
};

}  // namespace

WallTree::WallTree(const std::vector<Segment> & walls, WallSides sides) : sides_(sides)
{
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (!walls[i].from_m.allFinite() || !walls[i].to_m.allFinite()) {
      throw std::invalid_argument(
        "wall " + std::to_string(i) + ": an end is not finite, two points wanted");
    }
  }
  if (!walls.empty()) {
    std::vector<Segment> sorted = walls;
    Growth{nodes_, blocks_}.add_node({sorted.begin(), sorted.end()});
  }
}

}  // namespace stetro_site
