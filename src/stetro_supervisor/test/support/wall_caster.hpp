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

#ifndef SUPPORT__WALL_CASTER_HPP_
#define SUPPORT__WALL_CASTER_HPP_

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "stetro_site/profile_caster.hpp"

namespace stetro_supervisor
{

/// The simplest caster there is: each wall shortens the beams that its ends enclose.
class WallCaster : public stetro_site::ProfileCaster
{
public:
  explicit WallCaster(std::vector<stetro_site::Segment> walls) : walls_(std::move(walls)) {}

  void cast(
    const Eigen::Vector2d & from_m, const stetro_site::BeamFan & fan, double reach_m,
    std::vector<double> & ranges_m) const override;

private:
  std::vector<stetro_site::Segment> walls_;
};

/// Walls of a rectangle with sides along the axes.
[[nodiscard]] std::vector<stetro_site::Segment> rectangle(
  const Eigen::Vector2d & low_m, const Eigen::Vector2d & high_m);

}  // namespace stetro_supervisor

#endif  // SUPPORT__WALL_CASTER_HPP_
