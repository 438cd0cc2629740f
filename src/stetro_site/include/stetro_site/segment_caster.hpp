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

#ifndef STETRO_SITE__SEGMENT_CASTER_HPP_
#define STETRO_SITE__SEGMENT_CASTER_HPP_

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

class WallTree;

/// Casts profiles on walls drawn as segments, exactly.
/**
 * A segment stops beams from both sides and its ends belong to it: a beam that touches one, within
 * 1e-12 rad, stops there. So no beam slips between two walls that share an end. A wall that a beam
 * runs along stops it at the nearer end; one without length is seen by the beam that points at it.
 * A scanner on a wall reads 0 in every direction.
 *
 * A depth buffer over the beams, filled from near to far along a tree of boxes: what is hidden is
 * left out. Preparing takes O(n log n) for n segments.
 */
class SegmentCaster : public ProfileCaster
{
public:
  /// \throws std::invalid_argument naming the first segment that is not of finite numbers
  explicit SegmentCaster(const std::vector<Segment> & walls);

  /// See `ProfileCaster::cast`. The fan may be more than a turn, of any step, either way round.
  /** Place, fan or reach that are not numbers read NaN; without a positive reach nothing is met. */
  void cast(
    const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
    std::vector<double> & ranges_m) const override;

private:
  std::shared_ptr<const WallTree> walls_;
};

}  // namespace stetro_site

#endif  // STETRO_SITE__SEGMENT_CASTER_HPP_
