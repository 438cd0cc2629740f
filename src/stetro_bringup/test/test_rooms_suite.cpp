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

#include <cmath>
#include <limits>
#include <random>

#include "profiles/room_scanner.hpp"
#include "profiles/rooms_suite.hpp"
#include "stetro_site/segment_caster.hpp"

namespace stetro_bringup
{
namespace
{

constexpr std::size_t kRooms = 200;
constexpr std::uint64_t kSeed = 20260101;

RoomsTable table_of(const char * name)
{
  for (const RoomsKind & kind : kinds_of_rooms()) {
    if (kind.name == name) {
      return run_rooms(kind, kRooms, kSeed, [] {});
    }
  }
  ADD_FAILURE() << "no table " << name;
  return {};
}

constexpr double kQuarterTurn = 1.5707963267948966;

/// A pose of a room and a verdict that is off it.
stetro_supervisor::ProfileFinding verdict_off(
  const stetro_supervisor::ScannerPose & truth, const Eigen::Vector2d & units, double yaw_rad)
{
  stetro_supervisor::ProfileFinding finding;
  finding.verdict = stetro_supervisor::Verdict::kCorrected;
  finding.best.pose = {truth.position_m + units, truth.yaw_rad + yaw_rad};
  finding.best.covariance = Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 1e-3 * 1e-3).asDiagonal();
  return finding;
}

TEST(RoomsScore, ARightPlaceAtAWrongHeadingIsNotSolved)
{
  const RandomRoom room;
  const stetro_supervisor::ScannerPose truth{{50.0, 50.0}, 3.1};
  const auto right = rated(verdict_off(truth, {0.05, 0.0}, 0.001), room, truth);
  EXPECT_EQ(right.within_01, 1u);
  EXPECT_EQ(right.false_accepts, 0u);
  const auto coarse = rated(verdict_off(truth, {0.05, 0.0}, 0.004), room, truth);
  EXPECT_EQ(coarse.within_01, 0u) << "0.2 unit half the room away";
  EXPECT_EQ(coarse.within_1, 1u);
  EXPECT_EQ(coarse.false_accepts, 0u);
  const auto claimed = rated(verdict_off(truth, {0.05, 0.0}, 0.006), room, truth);
  EXPECT_EQ(claimed.false_accepts, 1u) << "six of its own standard deviations";
  const auto turned = rated(verdict_off(truth, {0.05, 0.0}, kQuarterTurn), room, truth);
  EXPECT_EQ(turned.within_1, 0u);
  EXPECT_EQ(turned.false_accepts, 1u) << "one pose was told where four look alike";
}

TEST(RoomsScore, AnAmbiguousAnswerHoldsTheHeadingOfTheTruth)
{
  RandomRoom room;
  const stetro_supervisor::ScannerPose truth{{50.0, 50.0}, 3.1};
  auto finding = verdict_off(truth, {0.0, 0.0}, kQuarterTurn);
  finding.verdict = stetro_supervisor::Verdict::kAmbiguous;
  finding.alternatives = {{truth.position_m, truth.yaw_rad + 2.0 * kQuarterTurn}};
  EXPECT_EQ(rated(finding, room, truth).ambiguous_right, 0u) << "the place is, the heading is not";
  finding.alternatives.push_back({truth.position_m, truth.yaw_rad - 4.0 * kQuarterTurn});
  EXPECT_EQ(rated(finding, room, truth).ambiguous_right, 1u) << "a whole turn off is not off";
  room.boxes.push_back({{10.0, 10.0}, {20.0, 25.0}});
  EXPECT_EQ(rated(finding, room, truth).ambiguous_right, 0u)
    << "a room with a box is not symmetric";
}

TEST(RoomsSuite, PublishedSearchFailsInARoomOfFour)
{
  const RoomsTable table = table_of("rooms");
  EXPECT_EQ(table.published.cases, kRooms);
  EXPECT_GT(table.published.within_1, kRooms * 6 / 10);
  EXPECT_LT(table.published.within_1, kRooms * 9 / 10) << "it does not always converge (D5-9)";
}

TEST(RoomsSuite, TrustedSearchSolvesTheRoomsAndIsNeverWrong)
{
  const RoomsTable table = table_of("rooms");
  EXPECT_GE(table.trusted.within_01, kRooms * 99 / 100);
  EXPECT_EQ(table.trusted.false_accepts, 0u);
  EXPECT_EQ(table.trusted.within_01 + table.trusted.no_verdict + table.trusted.ambiguous, kRooms);
}

TEST(RoomsSuite, NoiseDoesNotMakeItWrong)
{
  const RoomsTable table = table_of("rooms_noisy");
  EXPECT_GE(table.trusted.within_01, kRooms * 99 / 100);
  EXPECT_EQ(table.trusted.false_accepts, 0u);
}

TEST(RoomsSuite, UnmappedBoxesDoNotMakeItWrong)
{
  const RoomsTable table = table_of("rooms_unmapped");
  EXPECT_GE(table.trusted.within_01, kRooms * 97 / 100);
  EXPECT_EQ(table.trusted.false_accepts, 0u);
}

TEST(RoomsSuite, HeadingIsFoundOrTheSymmetryTold)
{
  const RoomsTable table = table_of("rooms_heading_unknown");
  EXPECT_GE(table.trusted.within_01 + table.trusted.ambiguous_right, kRooms * 97 / 100);
  EXPECT_GT(table.trusted.ambiguous_right, 0u) << "an empty square looks alike from four sides";
  EXPECT_EQ(table.trusted.false_accepts, 0u);
}

TEST(RoomsSuite, ScannerAndCasterAgreeWithoutSharingCode)
{
  std::mt19937_64 random(5);
  for (int i = 0; i < 20; ++i) {
    const RandomRoom room = draw_room(random, RoomDraw::kEven);
    const auto walls = room.map_walls();
    const auto scan = scanned(walls, {room.truth, 0.4}, 720);
    std::vector<double> model;
    stetro_site::SegmentCaster(walls).cast(
      room.truth, {0.4, scan.fan.step_rad, 720}, std::numeric_limits<double>::infinity(), model);
    for (std::size_t beam = 0; beam < 720; ++beam) {
      EXPECT_NEAR(scan.ranges_m[beam], model[beam], 1e-6) << "room " << i << ", beam " << beam;
    }
  }
}

}  // namespace
}  // namespace stetro_bringup
