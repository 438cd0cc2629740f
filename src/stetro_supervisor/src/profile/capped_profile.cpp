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
  MomentSum sum;
  const auto known = [&scan](std::size_t i) { return scan.ranges_m()[i] > 0.0; };
  const std::size_t edges = scan.closed() ? scan.size() : scan.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = i + 1 < scan.size() ? i + 1 : 0;
    if (known(i) && known(next)) {
      sum.add(
        std::min(ranges_m[i], cap_m) * scan.directions()[i],
        std::min(ranges_m[next], cap_m) * scan.directions()[next]);
    }
  }
  return sum.moments();
}

std::optional<ProfileMoments> agreeing_moments(
  const Beams & scan, const std::vector<double> & ranges_m,
  const std::vector<BeamOutcome> & outcomes)
{
  MomentSum sum;
  const std::size_t edges = scan.closed() ? scan.size() : scan.size() - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = i + 1 < scan.size() ? i + 1 : 0;
    if (outcomes[i] == BeamOutcome::kAgrees && outcomes[next] == BeamOutcome::kAgrees) {
      sum.add(ranges_m[i] * scan.directions()[i], ranges_m[next] * scan.directions()[next]);
    }
  }
  return sum.moments();
}

}  // namespace stetro_supervisor
