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

#ifndef STETRO_SUPERVISOR__CLIMB_STATE_HPP_
#define STETRO_SUPERVISOR__CLIMB_STATE_HPP_

#include <cstdint>
#include <optional>
#include <string>

namespace stetro_supervisor
{

/// States of the climb; `transition_table.hpp` says what each does and how it is left.
enum class State : std::uint8_t {
  kIdle,
  kRejoin,
  // to the first riser
  kSteerToFind,
  kFindStairs,
  kAlignToStairs,
  kSteerToApproach,
  kApproach,
  // blocks 1 and 3 follow block 2
  kLiftBlock3,
  kLiftBlock1,
  kSteerToRiser,
  kRollToRiser,
  kRealignBackOff,
  kRealignSteer,
  kRealignTurn,
  kLowerBlock1,
  kLowerBlock3,
  // sweeping a tread
  kBackOff,
  kSteerAcross,
  kSweepLeft,
  kSweepRight,
  kSweepToMiddle,
  kSteerToTrim,
  kTrimAlong,
  kCheckTop,
  // block 2 steps up
  kSquare,
  kSteerAlong,
  kLiftBlock2,
  kRollBlock3ToRiser,
  kLowerBlock2,
  kConfirmStep,
  // standing still
  kHeld,
  kWaitPose,
  kPaused,
  kFault,
  kAborted,
  kFinished
};
constexpr int kStateCount = static_cast<int>(State::kFinished) + 1;

/// Why the robot stopped for good; left only by clearing the fault.
enum class Fault : std::uint8_t {
  kNone,
  kEmergencyStop,
  kBlockFault,
  kContactFault,    ///< a switch is broken or unknown
  kCommandRefused,  ///< the driver kept refusing
  kSteerTimeout,
  kStairNotFound,
  kMisaligned,  ///< could not be turned square
  kApproachTimeout,
  kLiftTimeout,
  kRollTimeout,
  kRiserMissing,  ///< rolled or looked where a riser should be, and there was none
  kSkewed,        ///< the second riser switch would not close
  kTouchDownUnconfirmed,
  kSwitchStuck,    ///< a riser switch stays closed away from the riser
  kBumperStuck,    ///< a bumper is closed away from its wall
  kNoWallContact,  ///< travelled more than the width without a bumper closing
  kSweepTimeout,
  kTooManyTrims,
  kTopBlocked,           ///< on the last tread, and the front is not seen to be free
  kStepContradiction,    ///< what was felt and the localizer's step do not agree
  kEvidenceContradicts,  ///< no state to go on from fits what is seen
  kPoseLost,
  kHeldTooLong,
  // on floors
  kNoWay,         ///< the map shows no way to where the robot is to go
  kWayBlocked,    ///< something that is not on the map stood in the way for too long
  kLegTimeout,    ///< a leg took too long
  kNotHandedOver  ///< the localizer did not follow from floor to flight, or back
};
constexpr int kFaultCount = static_cast<int>(Fault::kNotHandedOver) + 1;

/// The parts of the climb: what a persisted state must share with what is seen after a restart.
enum class Phase : std::uint8_t { kNone, kFloor, kFollowing, kSweeping, kStepping, kStanding };

/// Which part of the sweep of a tread is next.
enum class Leg : std::uint8_t { kFirst, kSecond, kMiddle, kDone };

const char * to_string(State state);
const char * to_string(Fault fault);
const char * to_string(Leg leg);
Phase phase_of(State state);

/// The inverse of `to_string`; nothing if no state, no leg is called so.
std::optional<State> state_named(const std::string & name);
std::optional<Leg> leg_named(const std::string & name);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__CLIMB_STATE_HPP_
