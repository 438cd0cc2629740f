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

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "random_scenes.hpp"
#include "stetro_site/segment_caster.hpp"
#include "stetro_tests/counted_allocations.hpp"

namespace stetro_site
{
namespace
{

using Eigen::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFar = 1e9;

std::vector<double> cast(
  const std::vector<Segment> & walls, const Vector2d & from_m, const BeamFan & fan,
  double reach_m = kFar)
{
  std::vector<double> ranges_m;
  SegmentCaster(walls).cast(from_m, fan, reach_m, ranges_m);
  return ranges_m;
}

double cross(const Vector2d & a, const Vector2d & b) { return a.x() * b.y() - a.y() * b.x(); }

/// Nearest hit of a beam on walls that are longer by a share of themselves at both ends.
double brute_force(
  const std::vector<Segment> & walls, const Vector2d & from, double angle_rad, double longer)
{
  const Vector2d beam(std::cos(angle_rad), std::sin(angle_rad));
  double nearest = kInfinity;
  for (const Segment & wall : walls) {
    const Vector2d along = wall.to_m - wall.from_m;
    const Vector2d to = wall.from_m - from;
    const double turn = cross(beam, along);
    const double range = cross(to, along) / turn;
    const double at = cross(to, beam) / turn;
    if (range >= 0.0 && at >= -longer && at <= 1.0 + longer) {
      nearest = std::min(nearest, range);
    }
  }
  return nearest;
}

void expect_as_brute_force(
  const std::vector<Segment> & walls, const Vector2d & from, const BeamFan & fan)
{
  const std::vector<double> ranges = cast(walls, from, fan);
  ASSERT_EQ(ranges.size(), fan.count);
  for (std::size_t i = 0; i < fan.count; ++i) {
    const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
    const double most = brute_force(walls, from, angle, -1e-9);
    if (std::isinf(most) && std::isinf(ranges[i])) {
      continue;
    }
    // A beam within a hair of an end may go either way.
    const double least = brute_force(walls, from, angle, 1e-9);
    ASSERT_GE(ranges[i], least * (1.0 - 1e-9)) << "beam " << i << " from " << from.transpose();
    ASSERT_LE(ranges[i], most * (1.0 + 1e-9)) << "beam " << i << " from " << from.transpose();
  }
}

TEST(SegmentCaster, ReadsASquareRoomFromItsMiddle)
{
  const std::vector<Segment> room = RandomRoom(4, 0, 1).walls;  // 100 x 100, no boxes
  const std::vector<double> ranges = cast(room, {50.0, 50.0}, full_turn(8));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(ranges[i], i % 2 == 0 ? 50.0 : 50.0 * std::sqrt(2.0), 1e-12) << "beam " << i;
  }
}

// Fans of every kind on rooms of every size; each reads what looking at every wall reads.
TEST(SegmentCaster, ReadsWhatEveryWallByItselfReads)
{
  const std::vector<BeamFan> fans{
    full_turn(1440),        full_turn(720, 5.0),    {-2.35, 0.00436, 1081}, {1.0, -0.01, 400},
    {3.0, -0.00873, 720},   {100.0, 0.3, 21},       {0.5, 0.0, 3},          {2.0, 1e-7, 50},
    {-3.2, 0.008726646, 1}, {0.0, 0.017453293, 800}};
  for (const std::size_t walls : {4U, 8U, 12U, 68U, 100U, 1000U, 3000U}) {
    const RandomRoom room(walls, 6, static_cast<unsigned>(walls));
    for (const Vector2d & place : room.places) {
      for (const BeamFan & fan : fans) {
        ASSERT_NO_FATAL_FAILURE(expect_as_brute_force(room.walls, place, fan));
      }
    }
  }
}

// Walls that cross one another, from places inside and outside the crowd.
TEST(SegmentCaster, ReadsCrossingWalls)
{
  std::mt19937 random{31};
  std::uniform_real_distribution<double> at{-10.0, 10.0};
  std::uniform_real_distribution<double> angle{-4.0, 4.0};
  for (int scene = 0; scene < 40; ++scene) {
    std::vector<Segment> walls;
    for (int i = 0; i < 1 + scene * 5; ++i) {
      walls.push_back({{at(random), at(random)}, {at(random), at(random)}});
    }
    for (int i = 0; i < 5; ++i) {
      const Vector2d place(1.5 * at(random), 1.5 * at(random));
      ASSERT_NO_FATAL_FAILURE(expect_as_brute_force(walls, place, full_turn(360, angle(random))));
    }
  }
}

/// Where a beam meets a wall, ends included as if they were 1e-10 wide.
double met_at(const Segment & wall, const Vector2d & from, const Vector2d & beam)
{
  const Vector2d a = wall.from_m - from;
  const Vector2d b = wall.to_m - from;
  const auto on_beam = [&](const Vector2d & end) { return std::fabs(cross(beam, end)) < 1e-10; };
  const auto ahead = [&](const Vector2d & end) {
    return beam.dot(end) > 0.0 ? end.norm() : kInfinity;
  };
  if (on_beam(a) || on_beam(b)) {
    return std::min(on_beam(a) ? ahead(a) : kInfinity, on_beam(b) ? ahead(b) : kInfinity);
  }
  if (cross(beam, a) * cross(beam, b) > 0.0) {
    return kInfinity;
  }
  const double range = cross(a, b - a) / cross(beam, b - a);
  return range > 0.0 ? range : kInfinity;
}

// On a lattice everything that is rare elsewhere is common: beams at ends and along walls, walls
// without length, on one another and in line with the scanner, or with the scanner on them.
TEST(SegmentCaster, ReadsWallsOnALattice)
{
  std::mt19937 random{99};
  std::uniform_int_distribution<int> at{-6, 6};
  std::uniform_int_distribution<int> eighths{0, 7};
  for (int scene = 0; scene < 3000; ++scene) {
    std::vector<Segment> walls;
    for (int i = 0; i < 1 + scene % 40; ++i) {
      walls.push_back({Vector2d(at(random), at(random)), Vector2d(at(random), at(random))});
    }
    const Vector2d place(at(random), at(random));
    const double step = (scene % 2 == 0 ? kTurn : -kTurn) / (scene % 3 == 0 ? 8 : 24);
    const BeamFan fan{eighths(random) * kTurn / 8, step, scene % 5 == 0 ? 7U : 27U};
    const bool on_wall = std::any_of(walls.begin(), walls.end(), [&](const Segment & wall) {
      const Vector2d a = wall.from_m - place;
      const Vector2d b = wall.to_m - place;
      return cross(a, b) == 0.0 && a.dot(b) <= 0.0;
    });
    const std::vector<double> ranges = cast(walls, place, fan);
    for (std::size_t i = 0; i < fan.count; ++i) {
      const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
      double wanted = on_wall ? 0.0 : kInfinity;
      for (const Segment & wall : walls) {
        wanted = std::min(wanted, met_at(wall, place, {std::cos(angle), std::sin(angle)}));
      }
      ASSERT_TRUE(ranges[i] == wanted || std::fabs(ranges[i] - wanted) <= 1e-9 * wanted)
        << ranges[i] << " for " << wanted << ", scene " << scene << ", beam " << i;
    }
  }
}

TEST(SegmentCaster, SeesAWallAcrossTheSeamOfTheAngles)
{
  const std::vector<Segment> wall{{{-2.0, -1.0}, {-2.0, 1.0}}};
  for (const double first : {0.0, -kTurn / 2, kTurn / 2, 3.0, -3.0, kTurn, 1000 * kTurn}) {
    const BeamFan fan = full_turn(360, first);
    const std::vector<double> ranges = cast(wall, {0.0, 0.0}, fan);
    for (std::size_t i = 0; i < fan.count; ++i) {
      const double angle = first + static_cast<double>(i) * fan.step_rad;
      const bool met = std::fabs(std::tan(angle)) <= 0.5 && std::cos(angle) < 0.0;
      EXPECT_NEAR(met ? ranges[i] : -2.0, met ? -2.0 / std::cos(angle) : -2.0, 1e-9);
      EXPECT_EQ(std::isinf(ranges[i]), !met) << "beam " << i << ", first " << first;
    }
  }
}

// The wall from 0 to 45 degrees, in fans of 45 degrees a beam: both ends are met, nothing else.
TEST(SegmentCaster, EndsOnABeamAreMet)
{
  const std::vector<Segment> wall{{{5.0, 0.0}, {5.0, 5.0}}};
  for (int turned = 0; turned < 8; ++turned) {
    for (const double step : {kTurn / 8, -kTurn / 8}) {
      const BeamFan fan{turned * kTurn / 8, step, 8};
      const std::vector<double> ranges = cast(wall, {0.0, 0.0}, fan);
      for (int i = 0; i < 8; ++i) {
        const int eighth = ((step > 0.0 ? turned + i : turned - i) + 8) % 8;
        const double wanted = eighth == 0 ? 5.0 : eighth == 1 ? 5.0 * std::sqrt(2.0) : kInfinity;
        const double range = ranges[static_cast<std::size_t>(i)];
        EXPECT_TRUE(range == wanted || std::fabs(range - wanted) < 1e-9)
          << range << " at eighth " << eighth << ", first eighth " << turned;
      }
    }
  }
}

TEST(SegmentCaster, AWallInLineWithTheBeamIsMetAtItsNearerEnd)
{
  for (int i = 0; i < 24; ++i) {
    const double angle = kTurn * i / 24;
    const Vector2d beam(std::cos(angle), std::sin(angle));
    const Vector2d place(3.0, -7.0);
    const std::vector<Segment> walls{{place + 4.0 * beam, place + 2.0 * beam}};
    const std::vector<double> ranges = cast(walls, place, full_turn(24));
    EXPECT_NEAR(ranges[static_cast<std::size_t>(i)], 2.0, 1e-9) << "angle " << angle;
    EXPECT_EQ(std::count(ranges.begin(), ranges.end(), kInfinity), 23) << "angle " << angle;
  }
}

TEST(SegmentCaster, AWallWithoutLengthIsMetByTheBeamThatPointsAtIt)
{
  const std::vector<double> ranges = cast({{{0.0, 3.0}, {0.0, 3.0}}}, {0.0, 0.0}, full_turn(4));
  EXPECT_NEAR(ranges[1], 3.0, 1e-12);
  EXPECT_EQ(std::count(ranges.begin(), ranges.end(), kInfinity), 3);
}

TEST(SegmentCaster, OnAWallEveryBeamReadsNothing)
{
  const std::vector<Segment> walls{{{-1.0, -1.0}, {3.0, 3.0}}, {{5.0, -5.0}, {5.0, 5.0}}};
  for (const Vector2d & place : {Vector2d(1.0, 1.0), Vector2d(-1.0, -1.0), Vector2d(5.0, 0.5)}) {
    EXPECT_EQ(cast(walls, place, full_turn(36)), std::vector<double>(36, 0.0));
  }
}

// Beams aimed at each corner of a closed wall: what two walls share lets nothing through.
TEST(SegmentCaster, NoBeamSlipsThroughACorner)
{
  std::mt19937 random{5};
  std::uniform_real_distribution<double> radius{1.0, 2.0};
  std::uniform_real_distribution<double> at{-0.5, 0.5};
  for (int sample = 0; sample < 2000; ++sample) {
    std::vector<Vector2d> corners;
    for (int i = 0; i < 7; ++i) {
      const double angle = kTurn * (i + 0.5 * at(random)) / 7;
      corners.push_back(radius(random) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    std::vector<Segment> walls;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
    const Vector2d place(0.5 * at(random), 0.5 * at(random));
    for (const Vector2d & corner : corners) {
      const Vector2d to = corner - place;
      const BeamFan fan{std::atan2(to.y(), to.x()) - 3 * 0.1, 0.1, 7};
      const std::vector<double> ranges = cast(walls, place, fan);
      ASSERT_LT(*std::max_element(ranges.begin(), ranges.end()), 3.0) << "sample " << sample;
      ASSERT_LE(ranges[3], to.norm() * (1.0 + 1e-9)) << "sample " << sample;
    }
  }
}

TEST(SegmentCaster, WhatIsOutOfReachIsInfinitelyFar)
{
  const std::vector<Segment> room = RandomRoom(4, 0, 1).walls;
  const std::vector<double> ranges = cast(room, {50.0, 50.0}, full_turn(8), 60.0);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(std::isinf(ranges[i]), i % 2 == 1) << "beam " << i;
  }
  // At the very reach a wall is met; beyond it by a billionth it is not.
  EXPECT_NEAR(cast(room, {50.0, 50.0}, {0.0, 0.1, 1}, 50.0)[0], 50.0, 1e-12);
  EXPECT_EQ(cast(room, {50.0, 50.0}, {0.0, 0.1, 1}, 50.0 * (1.0 - 1e-9))[0], kInfinity);
  EXPECT_EQ(cast(room, {50.0, 50.0}, {0.0, 0.1, 1}, 0.0)[0], kInfinity);
  EXPECT_NEAR(cast(room, {50.0, 50.0}, {0.0, 0.1, 1}, kInfinity)[0], 50.0, 1e-12);
}

// Property: which way round the beams or a wall are counted changes no range.
TEST(SegmentCaster, KnowsNoDirectionOfItsOwn)
{
  const RandomRoom room(400, 10, 3);
  std::vector<Segment> reversed = room.walls;
  for (Segment & wall : reversed) {
    std::swap(wall.from_m, wall.to_m);
  }
  for (const Vector2d & place : room.places) {
    const std::vector<double> ranges = cast(room.walls, place, {-1.0, 0.003, 999});
    const std::vector<double> other_walls = cast(reversed, place, {-1.0, 0.003, 999});
    std::vector<double> backwards = cast(room.walls, place, {-1.0 + 998 * 0.003, -0.003, 999});
    std::reverse(backwards.begin(), backwards.end());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_NEAR(other_walls[i], ranges[i], 1e-9 * ranges[i]) << "beam " << i;
      ASSERT_NEAR(backwards[i], ranges[i], 1e-9 * ranges[i]) << "beam " << i;
    }
  }
}

// Property: a room turned and moved with the scanner in it reads the same.
TEST(SegmentCaster, ReadsTheSameInATurnedRoom)
{
  const RandomRoom room(400, 10, 4);
  const double turn = 0.7;
  const Eigen::Rotation2Dd rotation(turn);
  const Vector2d shift(-3.0, 20.0);
  std::vector<Segment> turned;
  for (const Segment & wall : room.walls) {
    turned.push_back({rotation * wall.from_m + shift, rotation * wall.to_m + shift});
  }
  for (const Vector2d & place : room.places) {
    const std::vector<double> ranges = cast(room.walls, place, full_turn(360, 0.1));
    const std::vector<double> same =
      cast(turned, rotation * place + shift, full_turn(360, 0.1 + turn));
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_NEAR(same[i], ranges[i], 1e-9 * ranges[i]) << "beam " << i;
    }
  }
}

TEST(SegmentCaster, WithoutWallsThereIsNothing)
{
  EXPECT_EQ(cast({}, {1.0, 2.0}, full_turn(12)), std::vector<double>(12, kInfinity));
  EXPECT_TRUE(cast({}, {1.0, 2.0}, {0.0, 0.1, 0}).empty());
}

TEST(SegmentCaster, WhatIsNoNumberReadsNoNumber)
{
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Segment> walls{{{5.0, -5.0}, {5.0, 5.0}}};
  EXPECT_TRUE(std::isnan(cast(walls, {kNan, 0.0}, full_turn(4))[0]));
  EXPECT_TRUE(std::isnan(cast(walls, {0.0, 0.0}, {kInfinity, 0.1, 4})[3]));
  EXPECT_TRUE(std::isnan(cast(walls, {0.0, 0.0}, full_turn(4), kNan)[0]));
  EXPECT_THROW(SegmentCaster({{{0.0, kNan}, {1.0, 1.0}}}), std::invalid_argument);
}

TEST(SegmentCaster, AllocatesNothingTheSecondTime)
{
  const RandomRoom room(1000, 20, 6);
  const SegmentCaster caster(room.walls);
  std::vector<double> ranges_m;
  caster.cast(room.places[0], full_turn(1440), kFar, ranges_m);
  const std::size_t before = allocations;
  for (const Vector2d & place : room.places) {
    caster.cast(place, full_turn(1440), kFar, ranges_m);
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace stetro_site
