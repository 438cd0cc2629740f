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

#ifndef STETRO_SITE__PROFILE_CASTER_HPP_
#define STETRO_SITE__PROFILE_CASTER_HPP_

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace stetro_site
{

/// A wall, or a piece of one, between two points of the floor [m].
struct Segment
{
  Eigen::Vector2d from_m;
  Eigen::Vector2d to_m;
};

/// Directions of the beams of a scanner: beam i points along `first_rad + i * step_rad`.
struct BeamFan
{
  double first_rad = 0.0;  ///< in the floor's frame, CCW
  double step_rad = 0.0;   ///< between neighbours, CCW positive
  std::size_t count = 0;
};

/// Casts the profile of a floor: what a scanner would see from a place, were the map the world.
/** Implementations are immutable after construction: one may be shared between threads. */
class ProfileCaster
{
public:
  virtual ~ProfileCaster() = default;

  /// Range of each beam from `from_m` to the first wall [m].
  /**
   * `ranges_m` is brought to `fan.count` numbers; a beam that meets nothing within `reach_m` is
   * +inf (REP 117). No number is allocated when `ranges_m` was as long before.
   */
  virtual void cast(
    const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
    std::vector<double> & ranges_m) const = 0;

protected:
  ProfileCaster() = default;
  ProfileCaster(const ProfileCaster &) = default;
  ProfileCaster & operator=(const ProfileCaster &) = default;
};

}  // namespace stetro_site

#endif  // STETRO_SITE__PROFILE_CASTER_HPP_
