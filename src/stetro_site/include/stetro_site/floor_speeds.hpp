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

#ifndef STETRO_SITE__FLOOR_SPEEDS_HPP_
#define STETRO_SITE__FLOOR_SPEEDS_HPP_

namespace stetro_site
{

/// How fast the robot drives over floors, unless the supervisor is told otherwise.
/** The localizer allows for as much motion between a correction and now. */
struct FloorSpeeds
{
  double roll_m_s = 0.3;    ///< along a leg [m/s]
  double turn_rad_s = 0.4;  ///< turning in place [rad/s]
};

}  // namespace stetro_site

#endif  // STETRO_SITE__FLOOR_SPEEDS_HPP_
