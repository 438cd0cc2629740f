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

#ifndef STETRO_LOCALIZER__FLOOR__FLOOR_STATE_HPP_
#define STETRO_LOCALIZER__FLOOR__FLOOR_STATE_HPP_

#include <Eigen/Core>

namespace stetro_localizer
{

/// Order of the states on a floor; the first three are the pose.
enum FloorIndex : int {
  kFloorX,          ///< base_link in the floor's frame [m]
  kFloorY,          ///< [m]
  kFloorYaw,        ///< heading psi against the floor's x axis, counter-clockwise positive [rad]
  kFloorGyroBias,   ///< what the gyroscope reads too much [rad/s]
  kFloorOdomScale,  ///< what the wheels count too much, a share [-]
  kFloorCount
};

using FloorVector = Eigen::Matrix<double, kFloorCount, 1>;
using FloorMatrix = Eigen::Matrix<double, kFloorCount, kFloorCount>;

/// The covariance of a state whose position is given in axes that are turned by `angle_rad`.
/** J C J^T, J = diag(Rz(angle), 1, 1, 1) */
[[nodiscard]] FloorMatrix turned(const FloorMatrix & covariance, double angle_rad);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__FLOOR_STATE_HPP_
