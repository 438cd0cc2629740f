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

#ifndef STETRO_LOCALIZER__FRONT_REFERENCE_HPP_
#define STETRO_LOCALIZER__FRONT_REFERENCE_HPP_

#include <optional>

#include "stetro_site/flight.hpp"

namespace stetro_localizer
{

/// Which riser the front pair sees: the lowest one that rises above its beams.
/**
 * The beams are level. From a height h above the flight's zero they pass over every nosing at or
 * below h and strike the next riser k, z_(k-1) < h < z_k. Block 1 on tread j sees riser j + 1;
 * lifted by 0.18 m it looks over that one and sees riser j + 2. Tread N is flush with the landing:
 * from there nothing is seen that could be a riser, whatever the ranges say, so a person or a wall
 * on the landing gives no heading.
 *
 * \param beam_z_m height of the beams in the flight frame [m]
 * \param margin_m how close to a nosing the beams, which are cones, are not trusted [m]
 * \return the riser, 1..N; nothing above the flight or close to a nosing
 */
[[nodiscard]] inline std::optional<int> riser_ahead(
  const stetro_site::Flight & flight, double beam_z_m, double margin_m)
{
  for (int k = 1; k <= flight.steps(); ++k) {
    const double nosing_m = flight.tread_z_m(k);
    if (nosing_m > beam_z_m) {
      const bool clear =
        beam_z_m < nosing_m - margin_m && beam_z_m > flight.tread_z_m(k - 1) + margin_m;
      return clear ? std::optional<int>(k) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FRONT_REFERENCE_HPP_
