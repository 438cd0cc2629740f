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
#ifndef STETRO_SUPERVISOR__REJOIN_HPP_
#define STETRO_SUPERVISOR__REJOIN_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "stetro_supervisor/climb_state.hpp"
#include "stetro_supervisor/situation.hpp"

namespace stetro_supervisor
{

/// How the blocks stand to each other, by their heights above the lowest underside.
enum class Posture : std::uint8_t {
  kUnknown,       ///< no fresh heights, or none of the below
  kLevel,         ///< all level: the floor or the landing
  kStride,        ///< block 1 one riser up: a tread is being swept
  kBlock1Raised,  ///< only block 1 up, not by a riser
  kBlock2Raised,  ///< block 3 lowest, block 2 in the air
  kStraddle,      ///< block 3 lowest, blocks 1 and 2 level
  kBlock3Raised   ///< block 3 above block 2
};

const char * to_string(Posture posture);

/// Classifies by h1 - h2 and h3 - h2 within the height tolerance.
Posture posture_of(const Situation & situation);

struct RejoinChoice
{
  std::optional<State> entry;  ///< where to go on
  std::string refusal;         ///< or why not, in words
};

/// Where to go on after a stop, a silence or a restart (D3-15).
/**
 * By the posture, the localizer's step p and the mission's phase and step k; each entry may be
 * taken again without harm (a lift to a lock that is reached ends at once, so does a roll to a
 * contact that is closed).
 *
 *   posture        phase       step          entry
 *   Level          new         p = 0         SteerToFind
 *   Level          Floor       p = k = 0     SteerToFind
 *   Level          Following   p = k = 0     SteerToFind
 *   Block1Raised   Following   p = k = 0     LiftBlock1
 *   Stride         Following   p = k = 0     LowerBlock1
 *   Stride         new         p < N         SteerAcross
 *   Stride         Sweeping    p = k < N     SteerToTrim at the riser, else SteerAcross
 *   Stride         Stepping    p = k < N     SteerAcross
 *   Level          Sweeping    p = k = N     SteerAcross
 *   Block2Raised   Stepping    p = k         LiftBlock2
 *   Straddle       Stepping    p = k, k + 1  ConfirmStep
 *   Straddle       Following   p = k > 0     LiftBlock3
 *   Level          Following   p = k > 0     LiftBlock3; from LowerBlock3 that
 *   Block3Raised   Following   p = k > 0     LiftBlock3
 *   Stride         Following   p = k > 0     LowerBlock3
 *
 * Everything else contradicts itself and is refused: the robot never goes on with a wrong step.
 * "New" is a mission that has not moved yet. A pose that is not sound is refused, but for the
 * approach from afar: see `Situation::pose_lets_approach`.
 */
RejoinChoice choose_entry(const Situation & situation);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__REJOIN_HPP_
