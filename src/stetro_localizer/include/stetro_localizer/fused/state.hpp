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

#ifndef STETRO_LOCALIZER__FUSED__STATE_HPP_
#define STETRO_LOCALIZER__FUSED__STATE_HPP_

#include <Eigen/Core>
#include <cstddef>

namespace stetro_localizer
{

/// The range sensors whose offset and gain are states.
enum class Ranger { kSideLeft, kSideRight, kFrontLeft, kFrontRight, kBlock3Front };
constexpr std::size_t kRangerCount = 5;
/// The first of them have something in sight nearly always; block3_front only during a step.
constexpr std::size_t kWatchedCount = 4;

/// Order of the states.
/**
 * Lengths along the stairs count from the riser ahead of block 2 (riser i + 1 on tread i; on the
 * last tread its far end), for that is what the robot touches and sees: the staircase as built
 * differs from its drawing, and no sum of treads enters what is measured.
 */
enum StateIndex : int {
  kStateX,    ///< base_link past the face of the riser ahead, at mid width; negative before [m]
  kStateY,    ///< base_link from the right wall [m]
  kStateYaw,  ///< heading psi against the flight's x axis, counter-clockwise positive [rad]
  kStateVx,   ///< speed of base_link, in base_link [m/s]
  kStateVy,   ///< [m/s]
  kStateGyroBias,    ///< what the gyroscope reads too much [rad/s]
  kStateOdomScale,   ///< what the wheels count too much, a share [-]
  kStateWidth,       ///< W between the walls here [m]
  kStateTreadHere,   ///< depth of the tread of block 2 [m]
  kStateTreadAhead,  ///< depth of the next one [m]
  kStateRiserAhead,  ///< direction rho of the riser ahead: its face is x = X + (y - W/2) tan rho
  kStateRiserNext,   ///< rho of the riser beyond that [rad]
  kStateFirstCalibration,  ///< offset [m], gain [-] of each `Ranger` in turn
  kStateCount = kStateFirstCalibration + 2 * static_cast<int>(kRangerCount)
};

using StateVector = Eigen::Matrix<double, kStateCount, 1>;
using StateMatrix = Eigen::Matrix<double, kStateCount, kStateCount>;

/// Index of the offset b of a sensor: it reads (1 + g) d + b.
[[nodiscard]] constexpr int offset_index(Ranger ranger)
{
  return kStateFirstCalibration + 2 * static_cast<int>(ranger);
}

/// Index of the gain error g.
[[nodiscard]] constexpr int gain_index(Ranger ranger) { return offset_index(ranger) + 1; }

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__STATE_HPP_
