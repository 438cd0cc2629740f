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

#ifndef ACCURACY__FAULT_ONSET_HPP_
#define ACCURACY__FAULT_ONSET_HPP_

namespace stetro_bringup
{

/// The motion in which a broken sensor must contradict the others.
enum class TellingMotion {
  kNearLeftWall,   ///< along the tread with that wall in reach: what the left side sensor sees
  kNearRightWall,  ///< the same on the right
  kAlong,          ///< up the stairs or turning: what the front sensors see
  kTurning,        ///< what the gyroscope feels
  kBlock1Rises,    ///< block 1 rises, 5 cm up already: what block1_down sees
  kBlock2Rises,    ///< block 2: block2_down
  kBlock2Clears,   ///< block 2 rises, 13 cm up already: block3_front sees what is behind it
  kAtLeftWall,     ///< along the tread, less than 2 cm from touching the left wall: its bumpers
  kAtRightWall,    ///< the same on the right
  kAtRiser,        ///< up the stairs, block 2 less than 2 cm from the riser: the riser switches
  kAny,
};

/// When an injected fault begins, and what brings it to light.
struct FaultOnset
{
  double at_s = 0.0;  ///< simulated time since the start
  TellingMotion telling = TellingMotion::kAny;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__FAULT_ONSET_HPP_
