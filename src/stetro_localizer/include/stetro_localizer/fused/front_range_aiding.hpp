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

#ifndef STETRO_LOCALIZER__FUSED__FRONT_RANGE_AIDING_HPP_
#define STETRO_LOCALIZER__FUSED__FRONT_RANGE_AIDING_HPP_

#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/expectation.hpp"

namespace stetro_localizer
{

/// Which riser a front beam strikes, counted from block 2.
/// Its value is the number of the riser less that of the riser ahead.
enum class SeenRiser : int {
  kBehind = -1,  ///< block 2 stands above it: what block 3, still below, has before it
  kAhead,        ///< the one block 2 stands before
  kNext,         ///< one tread beyond: block 1 stands on the tread ahead
  kAfterNext     ///< two treads beyond: block 1 looks over the next one
};

/// One range of the front pair: x within the tread, and with its twin the heading.
/**
 * The beam starts at p = (x + l cos psi - m sin psi, y + l sin psi + m cos psi) along
 * (cos psi, sin psi) and strikes the face x = X + (y - W/2) tan rho of the riser seen, at the
 * incidence psi + rho:
 *
 *   D = (X + (p_y - W/2) tan rho - p_x) cos rho
 *   reading = (1 + g) f(psi + rho) D + b
 *
 * X is 0 for the riser ahead, the depth of the tread ahead for the next, less the depth of the
 * tread here for the one behind. The difference of the two
 * readings is S-A and S-B eq. (2) with the signs of D1-6; here each counts by itself, so that one
 * alone still tells x.
 */
class FrontRangeAiding
{
public:
  /// \param mount_x_m l, \param mount_y_m m of the beam's origin in `base_link` [m]
  FrontRangeAiding(Ranger ranger, double mount_x_m, double mount_y_m, const ConeOnWall & cone);

  /// \param beyond_m depth of the tread after the next, by the site file; for `kAfterNext` [m]
  [[nodiscard]] Expectation expect(
    const StateVector & state, SeenRiser seen, double beyond_m = 0.0) const;
  [[nodiscard]] Ranger ranger() const { return ranger_; }

private:
  Ranger ranger_;
  double mount_x_m_;
  double mount_y_m_;
  ConeOnWall cone_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__FRONT_RANGE_AIDING_HPP_
