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

#ifndef PROFILES__ROOM_SCANNER_HPP_
#define PROFILES__ROOM_SCANNER_HPP_

#include <Eigen/Core>
#include <random>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_bringup
{

/// Ranges of a scanner in a world of walls, each beam against each wall by Cramer's rule.
/** It shares no code with the casters of stetro_site: what they get wrong shows. */
[[nodiscard]] stetro_supervisor::RangeProfile scanned(
  const std::vector<stetro_site::Segment> & walls, const stetro_supervisor::ScannerPose & pose,
  std::size_t beams);

/// White noise on every range, independent from beam to beam; what is left of zero is too near.
void add_noise(stetro_supervisor::RangeProfile & scan, double sigma, std::mt19937_64 & random);

/// Takes the echo from a share of the beams, each by its own lot.
void drop_out(stetro_supervisor::RangeProfile & scan, double share, std::mt19937_64 & random);

}  // namespace stetro_bringup

#endif  // PROFILES__ROOM_SCANNER_HPP_
