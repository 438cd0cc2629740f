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

#ifndef STETRO_LOCALIZER__FUSED__STANDING_GYRO_AIDING_HPP_
#define STETRO_LOCALIZER__FUSED__STANDING_GYRO_AIDING_HPP_

#include "stetro_localizer/fused/expectation.hpp"

namespace stetro_localizer
{

/// What the gyroscope reads while the robot stands: its bias [rad/s].
[[nodiscard]] inline Expectation expect_standing_gyro(const StateVector & state)
{
  Expectation rate(state[kStateGyroBias]);
  rate.depends_on(kStateGyroBias, 1.0);
  return rate;
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__STANDING_GYRO_AIDING_HPP_
