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

#ifndef PROFILE__CAPPED_PROFILE_HPP_
#define PROFILE__CAPPED_PROFILE_HPP_

#include <optional>
#include <vector>

#include "stetro_supervisor/profile/beam_comparison.hpp"
#include "stetro_supervisor/profile/profile_moments.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// Of the ranges that are numbers; zero if there are none [m].
[[nodiscard]] double median_range(const Beams & scan);

/// Moments of a profile of the scan's beams with the ranges cut off at `cap_m`.
/** Beams without an echo in the scan are left out, of the scan's profile and of the model's: at the
 *  cap they would stand where the map has a wall. */
[[nodiscard]] std::optional<ProfileMoments> capped_moments(
  const Beams & scan, const std::vector<double> & ranges_m, double cap_m);

/// Moments of a profile of the beams that agree; the triangles of the others are left out.
[[nodiscard]] std::optional<ProfileMoments> agreeing_moments(
  const Beams & scan, const std::vector<double> & ranges_m,
  const std::vector<BeamOutcome> & outcomes);

}  // namespace stetro_supervisor

#endif  // PROFILE__CAPPED_PROFILE_HPP_
