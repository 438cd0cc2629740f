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
#include "stetro_supervisor/rejoin.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stetro_supervisor
{
namespace
{

enum class StepRule { kFloor, kBelowTop, kTop, kTread, kStepping };

struct EntryRow
{
  Posture posture;
  Phase phase;
  StepRule step;
  State entry;
};

// The table of the header; a new mission has phase kNone.
const std::vector<EntryRow> & entry_table()
{
  static const std::vector<EntryRow> kTable{
    {Posture::kLevel, Phase::kNone, StepRule::kFloor, State::kSteerToFind},
    {Posture::kLevel, Phase::kFloor, StepRule::kFloor, State::kSteerToFind},
    {Posture::kLevel, Phase::kFollowing, StepRule::kFloor, State::kSteerToFind},
    {Posture::kBlock1Raised, Phase::kFollowing, StepRule::kFloor, State::kLiftBlock1},
    {Posture::kStride, Phase::kFollowing, StepRule::kFloor, State::kLowerBlock1},
    {Posture::kStride, Phase::kNone, StepRule::kBelowTop, State::kSteerAcross},
    {Posture::kStride, Phase::kSweeping, StepRule::kBelowTop, State::kSteerToTrim},
    {Posture::kStride, Phase::kStepping, StepRule::kBelowTop, State::kSteerAcross},
    {Posture::kLevel, Phase::kSweeping, StepRule::kTop, State::kSteerAcross},
    {Posture::kBlock2Raised, Phase::kStepping, StepRule::kBelowTop, State::kLiftBlock2},
    {Posture::kStraddle, Phase::kStepping, StepRule::kStepping, State::kConfirmStep},
    {Posture::kStraddle, Phase::kFollowing, StepRule::kTread, State::kLiftBlock3},
    {Posture::kLevel, Phase::kFollowing, StepRule::kTread, State::kLiftBlock3},
    {Posture::kBlock3Raised, Phase::kFollowing, StepRule::kTread, State::kLiftBlock3},
    {Posture::kStride, Phase::kFollowing, StepRule::kTread, State::kLowerBlock3},
  };
  return kTable;
}

bool step_fits(const Situation & s, StepRule rule)
{
  const int p = s.seen.pose->step;
  const int k = s.step();
  const int top = s.geometry.steps();
  switch (rule) {
    case StepRule::kFloor:
      return p == k && k == 0;
    case StepRule::kBelowTop:
      return p == k && k < top;
    case StepRule::kTop:
      return p == k && k == top;
    case StepRule::kTread:
      return p == k && k > 0 && k <= top;
    case StepRule::kStepping:
      return (p == k || p == k + 1) && p <= top;
  }
  return false;
}

/// Two entries depend on one thing more.
State refine(const Situation & s, State entry)
{
  if (entry == State::kSteerToTrim && !any_switch(s)) {
    return State::kSteerAcross;
  }
  const bool lowering = s.memory.record.state == State::kLowerBlock3;
  if (entry == State::kLiftBlock3 && lowering && posture_of(s) == Posture::kLevel) {
    return State::kLowerBlock3;
  }
  return entry;
}

std::string contradiction(const Situation & s, Posture posture)
{
  const MissionRecord & record = s.memory.record;
  return std::string("the blocks stand as '") + to_string(posture) + "', the localizer says step " +
         std::to_string(s.seen.pose->step) + ", the mission was at step " +
         std::to_string(record.step) + " in '" + to_string(record.state) +
         "': these contradict each other";
}

bool close_to(double value, double target, double tolerance)
{
  return std::abs(value - target) <= tolerance;
}

/// The riser block 1 stands on while block 2 stands on the localizer's step.
double riser_ahead_m(const Situation & s)
{
  const int next = s.seen.pose ? s.seen.pose->step + 1 : 0;
  return next >= 1 && next <= s.geometry.steps() ? s.geometry.riser(next) : kNan;
}

}  // namespace

const char * to_string(Posture posture)
{
  switch (posture) {
    case Posture::kLevel:
      return "level";
    case Posture::kStride:
      return "stride";
    case Posture::kBlock1Raised:
      return "block 1 raised";
    case Posture::kBlock2Raised:
      return "block 2 raised";
    case Posture::kStraddle:
      return "straddle";
    case Posture::kBlock3Raised:
      return "block 3 raised";
    default:
      return "unknown";
  }
}

Posture posture_of(const Situation & s)
{
  const double tolerance = s.params.height_tolerance_m;
  const double front = s.height_m(1) - s.height_m(2);
  const double rear = s.height_m(3) - s.height_m(2);
  if (!std::isfinite(front) || !std::isfinite(rear)) {
    return Posture::kUnknown;
  }
  if (rear > tolerance) {
    return Posture::kBlock3Raised;
  }
  if (rear < -tolerance) {
    const auto below = s.gap_m(Place::kBlock2Down);
    const double doubt_m = s.geometry.contact_doubt_m(Place::kBlock2Down, s.params);
    const double zone_m =
      s.bears(2) ? std::max(s.params.stall_zone_m, doubt_m) : s.params.stall_zone_m;
    const bool down = below && *below <= zone_m;
    return close_to(front, 0.0, tolerance) && down ? Posture::kStraddle : Posture::kBlock2Raised;
  }
  if (close_to(front, 0.0, tolerance)) {
    return Posture::kLevel;
  }
  const bool one_riser = close_to(front, riser_ahead_m(s), tolerance) && !s.block(1).at_upper_lock;
  return one_riser ? Posture::kStride : Posture::kBlock1Raised;
}

RejoinChoice choose_entry(const Situation & s)
{
  if (!s.pose_lets_approach()) {
    return {std::nullopt, s.pose_doubt()};
  }
  if (s.driver_silent()) {
    return {std::nullopt, "the driver is silent"};
  }
  const Posture posture = posture_of(s);
  const Phase phase = phase_of(s.memory.record.state);
  for (const EntryRow & row : entry_table()) {
    if (row.posture == posture && row.phase == phase && step_fits(s, row.step)) {
      const State entry = refine(s, row.entry);
      const bool may = s.pose_sound() || entry == State::kSteerToFind;
      return may ? RejoinChoice{entry, ""} : RejoinChoice{std::nullopt, s.pose_doubt()};
    }
  }
  return {std::nullopt, contradiction(s, posture)};
}

}  // namespace stetro_supervisor
