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

#include "capped_profile.hpp"

#include <algorithm>
#include <cmath>

#include "edge_moments.hpp"

namespace stetro_supervisor
{

double median_range(const Beams & scan)
{
  std::vector<double> known;
  for (double range : scan.ranges_m()) {
    if (std::isfinite(range)) {
      known.push_back(range);
    }
  }
  if (known.empty()) {
    return 0.0;
  }
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return *middle;
}

std::optional<ProfileMoments> capped_moments(
  const Beams & scan, const std::vector<double> & ranges_m, double cap_m)
{
  return edge_moments(
    scan, [&](std::size_t i) { return std::isfinite(scan.ranges_m()[i]); },
    [&](std::size_t i) { return std::min(ranges_m[i], cap_m); });
}

std::optional<ProfileMoments> agreeing_moments(
  const Beams & scan, const std::vector<double> & ranges_m,
  const std::vector<BeamOutcome> & outcomes)
{
  return edge_moments(
    scan, [&](std::size_t i) { return outcomes[i] == BeamOutcome::kAgrees; },
    [&](std::size_t i) { return ranges_m[i]; });
}

}  // namespace stetro_supervisor
