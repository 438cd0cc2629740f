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

#include "stetro_supervisor/profile/usability_layer.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace stetro_supervisor
{
namespace
{

double radius_at(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & at,
  const ContractionParams & params)
{
  const auto steps = contraction(map, at, params);
  return steps ? steps->spectral_radius : std::numeric_limits<double>::infinity();
}

}  // namespace

UsabilityLayer::UsabilityLayer(
  const stetro_site::ProfileCaster & map, const stetro_site::FreeSpace & free,
  const Eigen::Vector2d & low_m, const Eigen::Vector2d & high_m, const UsabilityParams & params)
: low_m_(low_m), spacing_m_(params.spacing_m)
{
  const Eigen::Vector2d size = high_m - low_m;
  if (!(spacing_m_ > 0.0) || !(size.minCoeff() >= 0.0)) {
    throw std::invalid_argument(
      "usability layer: spacing must be positive and the corners in order");
  }
  columns_ = static_cast<int>(size.x() / spacing_m_) + 1;
  rows_ = static_cast<int>(size.y() / spacing_m_) + 1;
  places_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d at = place_m(column, row);
      Usability place;
      place.spectral_radius = std::numeric_limits<double>::quiet_NaN();
      if (free.clearance_m(at) >= params.clearance_m) {
        const auto told = determination(map, at, params.determination);
        place.spectral_radius = radius_at(map, at, params.contraction);
        place.published_radius = radius_at(map, at, as_published(params.contraction));
        place.worst_sigma_m = told.worst_sigma_m;
        place.worst_direction = told.worst_direction;
      }
      places_.push_back(place);
    }
  }
}

Eigen::Vector2d UsabilityLayer::place_m(int column, int row) const
{
  return low_m_ + spacing_m_ * Eigen::Vector2d(column, row);
}

const Usability & UsabilityLayer::of(int column, int row) const
{
  return places_.at(
    static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
    static_cast<std::size_t>(column));
}

const Usability * UsabilityLayer::at(const Eigen::Vector2d & point_m) const
{
  const Eigen::Vector2d at = (point_m - low_m_) / spacing_m_;
  const Usability * worst = nullptr;
  for (int corner = 0; corner < 4; ++corner) {
    const double column = std::floor(at.x()) + (corner & 1);
    const double row = std::floor(at.y()) + (corner >> 1);
    if (!(column >= 0.0) || !(row >= 0.0) || !(column < columns_) || !(row < rows_)) {
      continue;
    }
    const Usability & place = of(static_cast<int>(column), static_cast<int>(row));
    const bool asked = !std::isnan(place.spectral_radius);
    if (asked && (worst == nullptr || place.spectral_radius > worst->spectral_radius)) {
      worst = &place;
    }
  }
  return worst;
}

}  // namespace stetro_supervisor
