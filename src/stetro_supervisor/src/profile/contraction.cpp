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

#include "stetro_supervisor/profile/contraction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "capped_profile.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn = 6.283185307179586;

}  // namespace

std::optional<Contraction> contraction(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & position_m,
  const ContractionParams & params)
{
  const stetro_site::BeamFan fan{0.0, kTurn / static_cast<double>(params.beams), params.beams};
  std::vector<double> ranges_m;
  map.cast(position_m, fan, params.reach_m, ranges_m);
  const Beams here(RangeProfile{fan, ranges_m});
  const double cap_m = std::min(params.reach_m, params.cap_medians * median_range(here));
  const bool published = std::isinf(params.cap_medians);
  const auto centroid_from = [&](const Eigen::Vector2d & at) -> std::optional<Eigen::Vector2d> {
    map.cast(at, fan, params.reach_m, ranges_m);
    const auto moments =
      published ? moments_of(here, ranges_m) : capped_moments(here, ranges_m, cap_m);
    return moments ? std::optional<Eigen::Vector2d>(at + moments->centroid_m) : std::nullopt;
  };
  Contraction found;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = params.step_m * Eigen::Vector2d::Unit(axis);
    const auto ahead = centroid_from(position_m + step);
    const auto behind = centroid_from(position_m - step);
    if (!ahead || !behind) {
      return std::nullopt;
    }
    found.jacobian.col(axis) = (*ahead - *behind) / (2.0 * params.step_m);
  }
  found.spectral_radius = found.jacobian.eigenvalues().cwiseAbs().maxCoeff();
  return found;
}

}  // namespace stetro_supervisor
