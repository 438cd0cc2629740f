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

#ifndef CAST_WALLS_HPP_
#define CAST_WALLS_HPP_

#include <Eigen/Core>
#include <vector>

#include "stetro_site/profile_caster.hpp"
#include "wall_tree.hpp"

namespace stetro_site
{

/// What the machine's vector unit understands.
enum class Instructions { kPlain, kAvx2, kAvx512 };

/// Whether this machine has them.
[[nodiscard]] bool available(Instructions instructions);

/// The widest that this machine has.
[[nodiscard]] Instructions best_instructions();

/// A fan of beams and where it starts from, in the axes and the unit of length of the walls.
struct Scanner
{
  Eigen::Vector2d from;
  BeamFan fan;
  double reach = 0.0;   ///< in the walls' unit
  double metres = 1.0;  ///< the walls' unit of length [m]
};

/// Whether all of it are numbers; the reach may be infinite.
[[nodiscard]] bool is_number(const Scanner & scanner);

/// Casts the profile of the walls of a tree, see `ProfileCaster::cast`.
/**
 * A depth buffer over the beams holds q, the inverse of the range. With a wall's end a and its
 * direction e, both seen from the scanner, beam d meets the wall's line at
 *
 *   1 / r = q = A d_x + B d_y,   (A, B) = (e_y, -e_x) / (a x e)                              (1)
 *
 * so that a wall costs one bearing an end, and then a beam in between two products and a maximum.
 * The tree is walked from near to far; a box whose beams have all met something nearer than the
 * box is left out with all that is in it.
 *
 * A wall reaches from beam to beam inclusive, and kAngleSlack further at both ends. The end that
 * two walls share is the same bearing for both: no beam passes between them. All instructions
 * give the same bits. The buffer is kept, one for each thread that casts.
 *
 * What is not a number reads NaN.
 */
void cast_walls(
  const WallTree & walls, const Scanner & scanner, Instructions instructions,
  std::vector<double> & ranges_m);

/// A beam that misses a wall's end by no more than this meets it [rad].
constexpr double kAngleSlack = 1e-12;

}  // namespace stetro_site

#endif  // CAST_WALLS_HPP_
