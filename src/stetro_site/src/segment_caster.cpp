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

#include "stetro_site/segment_caster.hpp"

#include "cast_walls.hpp"
#include "wall_tree.hpp"

namespace stetro_site
{

SegmentCaster::SegmentCaster(const std::vector<Segment> & walls)
: walls_(std::make_shared<const WallTree>(walls, WallSides::kBoth))
{
}

void SegmentCaster::cast(
  const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
  std::vector<double> & ranges_m) const
{
  cast_walls(*walls_, {from_m, fan, reach_m, 1.0}, best_instructions(), ranges_m);
}

}  // namespace stetro_site
