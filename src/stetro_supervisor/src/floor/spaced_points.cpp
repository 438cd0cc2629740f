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

#include "stetro_supervisor/floor/spaced_points.hpp"

#include <cmath>

namespace stetro_supervisor
{

SpacedPoints::SpacedPoints(double spacing_m)
: spacing_m_(spacing_m), side_m_(std::sqrt(0.5) * spacing_m)
{
}

std::uint64_t SpacedPoints::key(std::int64_t column, std::int64_t row)
{
  return static_cast<std::uint64_t>(column) << 32U ^ (static_cast<std::uint64_t>(row) & 0xFFFFFFFF);
}

bool SpacedPoints::take(const Eigen::Vector2d & point_m)
{
  const std::int64_t column = std::llround(std::floor(point_m.x() / side_m_));
  const std::int64_t row = std::llround(std::floor(point_m.y() / side_m_));
  for (std::int64_t c = column - 2; c <= column + 2; ++c) {
    for (std::int64_t r = row - 2; r <= row + 2; ++r) {
      const auto near = taken_m_.find(key(c, r));
      if (near != taken_m_.end() && (near->second - point_m).norm() < spacing_m_) {
        return false;
      }
    }
  }
  taken_m_.emplace(key(column, row), point_m);
  return true;
}

}  // namespace stetro_supervisor
