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

#ifndef WALL_TREE_HPP_
#define WALL_TREE_HPP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

/// How many walls, boxes or beams are worked on at once: what one AVX-512 register holds.
constexpr int kLanes = 8;

/// Which sides of a wall stop a beam.
enum class WallSides {
  kBoth,  ///< either
  kLeft   ///< the left of its direction only: from there it runs counter-clockwise
};

/// Up to eight walls, one a lane; lanes beyond `count` repeat the last.
struct alignas(64) WallBlock
{
  double ax[kLanes];
  double ay[kLanes];
  double bx[kLanes];
  double by[kLanes];
  std::int32_t count;
};

/// Up to eight boxes and what is in them; lanes beyond `count` repeat the last.
struct alignas(64) BoxNode
{
  double min_x[kLanes];
  double min_y[kLanes];
  double max_x[kLanes];
  double max_y[kLanes];
  std::int32_t child[kLanes];  ///< position of a node; of a block b it is -1 - b
  std::int32_t count;
};

/// Walls in a tree of boxes, eight to a node: what is near a scanner is found before what is far.
/**
 * Built from the top: the walls of a node are cut at the median of their centres, each time across
 * the longer side of the box about those, until there are eight pieces; then each piece is a node,
 * or with eight walls or fewer a block. Cuts lie where all pieces but the last become full.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class WallTree
{
public:
  /// \throws std::invalid_argument naming the first wall that is not of finite numbers
  WallTree(const std::vector<Segment> & walls, WallSides sides);

  [[nodiscard]] WallSides sides() const noexcept { return sides_; }
  [[nodiscard]] bool empty() const noexcept { return nodes_.empty(); }

  /// Nodes; the first is the root. There is none without walls.
  [[nodiscard]] const std::vector<BoxNode> & nodes() const noexcept { return nodes_; }
  [[nodiscard]] const std::vector<WallBlock> & blocks() const noexcept { return blocks_; }

  /// No tree is deeper: each level divides by eight, and positions have 32 bits.
  static constexpr int kDeepest = 12;

private:
  WallSides sides_;
  std::vector<BoxNode> nodes_;
  std::vector<WallBlock> blocks_;
};

}  // namespace stetro_site

#endif  // WALL_TREE_HPP_
