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

#ifndef STETRO_SUPERVISOR__PROFILE__BEAM_NOISE_HPP_
#define STETRO_SUPERVISOR__PROFILE__BEAM_NOISE_HPP_

namespace stetro_supervisor
{

/// How far a measured range may be from the map's, the scanner's place being right.
/**
 * A range errs by itself, each beam anew. The map errs across its walls, by its cells if it has
 * cells, and alike for all beams that end within `wall_correlation_m` of one another: seven
 * hundred beams on four walls do not know the walls' places better than four beams would.
 */
struct BeamNoise
{
  double range_sigma_m = 0.01;      ///< of a beam, positive
  double map_sigma_m = 0.0;         ///< of a wall's place, across the wall
  double wall_correlation_m = 0.5;  ///< along a wall, the length of one and the same error
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__BEAM_NOISE_HPP_
