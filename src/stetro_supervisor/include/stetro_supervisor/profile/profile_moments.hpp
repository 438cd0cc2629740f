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

#ifndef STETRO_SUPERVISOR__PROFILE__PROFILE_MOMENTS_HPP_
#define STETRO_SUPERVISOR__PROFILE__PROFILE_MOMENTS_HPP_

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace stetro_supervisor
{

/// Area and centre of mass of an even plate of the profile's shape.
struct ProfileMoments
{
  double area_m2 = 0.0;                                  ///< M of S-C eq. (5), positive
  Eigen::Vector2d centroid_m = Eigen::Vector2d::Zero();  ///< eq. (6), (7)
};

/// Adds up the triangles (0, p, q) that a profile consists of, seen from the scanner.
/**
 * With the cross product x of an edge's ends, S-C eq. (5) to (7) read
 *
 *   M = 1/2 sum p x q,    c = 1/(6 M) sum (p + q) (p x q).
 *
 * A triangle left out is a sector left out: of the scan and of the model alike, or the centroids
 * do not compare.
 */
class MomentSum
{
public:
  void add(const Eigen::Vector2d & p, const Eigen::Vector2d & q)
  {
    const double cross = p.x() * q.y() - q.x() * p.y();
    const Eigen::Vector2d both = p + q;
    twice_area_ += cross;
    first_ += cross * both;
  }

  /// Nothing where the area is so small beside the profile's length that M divides noise.
  [[nodiscard]] std::optional<ProfileMoments> moments() const;

private:
  double twice_area_ = 0.0;
  Eigen::Vector2d first_ = Eigen::Vector2d::Zero();
};

/// Moments of a closed outline; its last point joins its first (the index runs modulo n, D5-5).
/**
 * Either way round: sums and M change their signs together, the area is told positive.
 * \return nothing with fewer than three points, a point that is not finite, or no area
 */
[[nodiscard]] std::optional<ProfileMoments> profile_moments(
  const std::vector<Eigen::Vector2d> & outline);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__PROFILE_MOMENTS_HPP_
