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

#include "stetro_supervisor/profile/profile_moments.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{
namespace
{

/// A profile this thin beside its length has no centre worth the name.
constexpr double kThinnest = 1e-9;

}  // namespace

std::optional<ProfileMoments> MomentSum::moments() const
{
  const double area = 0.5 * std::abs(twice_area_);
  const Eigen::Vector2d centroid = first_ / (3.0 * twice_area_);
  if (!(area > 0.0) || !centroid.allFinite() || area < kThinnest * centroid.squaredNorm()) {
    return std::nullopt;
  }
  return ProfileMoments{area, centroid};
}

std::optional<ProfileMoments> profile_moments(const std::vector<Eigen::Vector2d> & outline)
{
  const std::size_t n = outline.size();
  if (n < 3 || !std::all_of(outline.begin(), outline.end(), [](const Eigen::Vector2d & p) {
        return p.allFinite();
      })) {
    return std::nullopt;
  }
  MomentSum sum;
  for (std::size_t i = 0; i < n; ++i) {
    sum.add(outline[i], outline[(i + 1) % n]);
  }
  return sum.moments();
}

}  // namespace stetro_supervisor
