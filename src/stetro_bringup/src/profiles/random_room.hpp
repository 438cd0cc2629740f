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

#ifndef PROFILES__RANDOM_ROOM_HPP_
#define PROFILES__RANDOM_ROOM_HPP_

#include <Eigen/Core>
#include <random>
#include <vector>

#include "stetro_site/profile_caster.hpp"

namespace stetro_bringup
{

/// A box with its sides along the axes.
struct Box
{
  Eigen::Vector2d low;
  Eigen::Vector2d high;

  [[nodiscard]] bool contains(const Eigen::Vector2d & p) const
  {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
};

/// A square room of 100 units a side with boxes that may overlap, and one case to solve in it.
struct RandomRoom
{
  static constexpr double kSide = 100.0;

  std::vector<Box> boxes;     ///< on the map
  std::vector<Box> unmapped;  ///< in the world only
  Eigen::Vector2d truth = Eigen::Vector2d::Zero();
  Eigen::Vector2d believed = Eigen::Vector2d::Zero();

  /// Inside the room and in no box of the map.
  [[nodiscard]] bool is_free(const Eigen::Vector2d & p) const;

  [[nodiscard]] std::vector<stetro_site::Segment> map_walls() const;
  [[nodiscard]] std::vector<stetro_site::Segment> world_walls() const;
};

/// How the number of boxes, 0 to 25, and the displacement, 2 to 40 units, are drawn.
enum class RoomDraw {
  kListed,  ///< 0, 1, 3, 6, 12 or 25 boxes, displaced by 2, 5, 10, 20 or 40: as in the figures
            ///< by which the published search was judged before
  kEven     ///< evenly between the ends: more rooms are full
};

/// Boxes of 3 to 18 units, a free pose, and a free belief at a distance from it.
[[nodiscard]] RandomRoom draw_room(std::mt19937_64 & random, RoomDraw draw);

/// A box of the same sizes that holds neither place.
[[nodiscard]] Box draw_box(std::mt19937_64 & random, const RandomRoom & room);

}  // namespace stetro_bringup

#endif  // PROFILES__RANDOM_ROOM_HPP_
