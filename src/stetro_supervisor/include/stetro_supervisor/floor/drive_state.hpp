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

#ifndef STETRO_SUPERVISOR__FLOOR__DRIVE_STATE_HPP_
#define STETRO_SUPERVISOR__FLOOR__DRIVE_STATE_HPP_

#include <cstdint>

namespace stetro_supervisor
{

/// States of driving over a floor; `drive_table.hpp` says what each does and how it is left.
enum class DriveState : std::uint8_t {
  kIdle,
  kPlan,
  kAim,
  kSteerAcross,
  kTurn,
  kSteerAlong,
  kRoll,
  kBlocked,
  kHandOver,
  // standing still
  kWaitPose,
  kHeld,
  kPaused,
  kFault,
  kAborted,
  kArrived
};
constexpr int kDriveStateCount = static_cast<int>(DriveState::kArrived) + 1;

const char * to_string(DriveState state);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__DRIVE_STATE_HPP_
