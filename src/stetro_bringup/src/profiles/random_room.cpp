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

#include "profiles/random_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stetro_bringup
{
namespace
{

constexpr double kSmallest = 3.0;
constexpr double kLargest = 18.0;
constexpr std::array<int, 6> kBoxes{0, 1, 3, 6, 12, 25};
constexpr std::array<double, 5> kDisplacements{2.0, 5.0, 10.0, 20.0, 40.0};
constexpr int kTries = 200;
constexpr double kTurn = 6.283185307179586;

double uniform(std::mt19937_64 & random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

void add_walls(const Box & box, std::vector<stetro_site::Segment> & walls)
{
  const Eigen::Vector2d right(box.high.x(), box.low.y());
  const Eigen::Vector2d left(box.low.x(), box.high.y());
  walls.push_back({box.low, right});
  walls.push_back({right, box.high});
  walls.push_back({box.high, left});
  walls.push_back({left, box.low});
}

template <class Numbers>
auto one_of(std::mt19937_64 & random, const Numbers & numbers)
{
  return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random)];
}

int boxes_of(std::mt19937_64 & random, RoomDraw draw)
{
  return draw == RoomDraw::kListed
           ? one_of(random, kBoxes)
           : std::uniform_int_distribution<int>(kBoxes.front(), kBoxes.back())(random);
}

double displacement_of(std::mt19937_64 & random, RoomDraw draw)
{
  return draw == RoomDraw::kListed ? one_of(random, kDisplacements)
                                   : uniform(random, kDisplacements.front(), kDisplacements.back());
}

Box any_box(std::mt19937_64 & random)
{
  const Eigen::Vector2d size(
    uniform(random, kSmallest, kLargest), uniform(random, kSmallest, kLargest));
  const Eigen::Vector2d low(
    uniform(random, 0.0, RandomRoom::kSide - size.x()),
    uniform(random, 0.0, RandomRoom::kSide - size.y()));
  return {low, low + size};
}

}  // namespace

bool RandomRoom::is_free(const Eigen::Vector2d & p) const
{
  return p.minCoeff() > 0.0 && p.maxCoeff() < kSide &&
         std::none_of(
           boxes.begin(), boxes.end(), [&p](const Box & box) { return box.contains(p); });
}

std::vector<stetro_site::Segment> RandomRoom::map_walls() const
{
  std::vector<stetro_site::Segment> walls;
  add_walls({{0.0, 0.0}, {kSide, kSide}}, walls);
  for (const Box & box : boxes) {
    add_walls(box, walls);
  }
  return walls;
}

std::vector<stetro_site::Segment> RandomRoom::world_walls() const
{
  auto walls = map_walls();
  for (const Box & box : unmapped) {
    add_walls(box, walls);
  }
  return walls;
}

RandomRoom draw_room(std::mt19937_64 & random, RoomDraw draw)
{
  for (;;) {
    RandomRoom room;
    const int boxes = boxes_of(random, draw);
    for (int i = 0; i < boxes; ++i) {
      room.boxes.push_back(any_box(random));
    }
    // A place with no free place at the drawn distance is given up, and the room with it.
    for (int i = 0; i < kTries; ++i) {
      room.truth = {
        uniform(random, 0.0, RandomRoom::kSide), uniform(random, 0.0, RandomRoom::kSide)};
      const double distance = displacement_of(random, draw);
      const double direction = uniform(random, 0.0, kTurn);
      room.believed =
        room.truth + distance * Eigen::Vector2d(std::cos(direction), std::sin(direction));
      if (room.is_free(room.truth) && room.is_free(room.believed)) {
        return room;
      }
    }
  }
}

Box draw_box(std::mt19937_64 & random, const RandomRoom & room)
{
  for (;;) {
    const Box box = any_box(random);
    if (!box.contains(room.truth) && !box.contains(room.believed)) {
      return box;
    }
  }
}

}  // namespace stetro_bringup
