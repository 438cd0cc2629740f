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

#ifndef STETRO_SUPERVISOR__FLOOR__SPACED_POINTS_HPP_
#define STETRO_SUPERVISOR__FLOOR__SPACED_POINTS_HPP_

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>

namespace stetro_supervisor
{

/// Of many points as many as are a spacing apart, first come, first served.
/** It takes the same time for each point, however many have been taken. */
class SpacedPoints
{
public:
  /// \param spacing_m positive
  explicit SpacedPoints(double spacing_m);

  /// Takes a point unless one that was taken is nearer than the spacing. \return whether it did
  bool take(const Eigen::Vector2d & point_m);

private:
  [[nodiscard]] static std::uint64_t key(std::int64_t column, std::int64_t row);

  double spacing_m_;
  double side_m_;  // of a square in which no two points are a spacing apart
  std::unordered_map<std::uint64_t, Eigen::Vector2d> taken_m_;  // by square
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__SPACED_POINTS_HPP_
