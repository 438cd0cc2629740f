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

#ifndef PROFILE__EDGE_MOMENTS_HPP_
#define PROFILE__EDGE_MOMENTS_HPP_

#include <cstddef>
#include <optional>

#include "stetro_supervisor/profile/profile_moments.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{

/// Moments of a profile of such beams, the triangles of those that do not count left out.
/** \param counts whether a beam does, by its number
 *  \param range_m of a beam that counts, by its number */
template <class Counts, class Range>
[[nodiscard]] std::optional<ProfileMoments> edge_moments(
  const Beams & beams, const Counts & counts, const Range & range_m)
{
  MomentSum sum;
  const std::size_t edges = beams.closed() ? beams.size() : beams.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = i + 1 < beams.size() ? i + 1 : 0;
    if (counts(i) && counts(next)) {
      sum.add(range_m(i) * beams.directions()[i], range_m(next) * beams.directions()[next]);
    }
  }
  return sum.moments();
}

}  // namespace stetro_supervisor

#endif  // PROFILE__EDGE_MOMENTS_HPP_
