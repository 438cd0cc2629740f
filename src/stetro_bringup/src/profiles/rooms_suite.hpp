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

#ifndef PROFILES__ROOMS_SUITE_HPP_
#define PROFILES__ROOMS_SUITE_HPP_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "profiles/random_room.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_bringup
{

/// What makes a table of rooms harder than the plain one.
struct RoomsKind
{
  std::string name;
  double noise_sigma = 0.0;     ///< of each range, units
  double unmapped_share = 0.0;  ///< of the beams, on boxes the map does not know
  bool heading_unknown = false;
  RoomDraw draw = RoomDraw::kListed;
};

/// rooms, rooms_noisy, rooms_unmapped, rooms_heading_unknown, and rooms_even, fuller of boxes.
[[nodiscard]] std::vector<RoomsKind> kinds_of_rooms();

/// How one way of checking did on the rooms of a table.
struct RoomsScore
{
  std::size_t cases = 0;
  std::size_t within_1 = 0;   ///< of the verdicts: error below 1 unit and 20 mrad
  std::size_t within_01 = 0;  ///< below 0.1 unit and 2 mrad
  std::size_t no_verdict = 0;
  std::size_t ambiguous = 0;        ///< several poses, and
  std::size_t ambiguous_right = 0;  ///< the truth among them, no more than the room's symmetries
  std::size_t false_accepts = 0;    ///< a verdict beyond 1 unit, 20 mrad or 5 standard deviations
  std::size_t searched = 0;         ///< cases in which all places had to be tried
  std::vector<double> us;           ///< time of each case on this thread's processor

  void add(const RoomsScore & other);
  [[nodiscard]] double median_us() const;
};

/// What a finding is worth, the truth being known.
/**
 * A heading counts as a position does that it moves as far, half the room's side away: 0.1 unit are
 * 2 mrad (0.11 degrees). An ambiguous finding is right if position and heading of the truth are
 * among its poses and these are no more than the room has symmetries, 4 without boxes.
 */
[[nodiscard]] RoomsScore rated(
  const stetro_supervisor::ProfileFinding & finding, const RandomRoom & room,
  const stetro_supervisor::ScannerPose & truth);

/// Published and trusted centre of mass on the same rooms.
struct RoomsTable
{
  RoomsKind kind;
  RoomsScore published;
  RoomsScore trusted;
};

/// Draws `rooms` cases from `seed` and solves each in both ways.
/**
 * The scans come from scanned(), the models from stetro_site::SegmentCaster. Case i of a seed is
 * the same room in every table. \param done called after each case
 */
[[nodiscard]] RoomsTable run_rooms(
  const RoomsKind & kind, std::size_t rooms, std::uint64_t seed,
  const std::function<void()> & done);

}  // namespace stetro_bringup

#endif  // PROFILES__ROOMS_SUITE_HPP_
