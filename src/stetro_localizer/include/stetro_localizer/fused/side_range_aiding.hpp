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

#ifndef STETRO_LOCALIZER__FUSED__SIDE_RANGE_AIDING_HPP_
#define STETRO_LOCALIZER__FUSED__SIDE_RANGE_AIDING_HPP_

#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/expectation.hpp"
#include "stetro_localizer/measurement/side_range.hpp"

namespace stetro_localizer
{

/// A range to a side wall: distance from it, and the sensor's own errors.
/**
 * With the beam's origin at (l, m) in `base_link`, heading psi and the cone's stretch f:
 *
 *   right:  D = y + l sin psi + m cos psi
 *   left:   D = W - y - l sin psi - m cos psi
 *   reading = (1 + g) f(psi) D + b
 */
class SideRangeAiding
{
public:
  SideRangeAiding(Side side, const SideRangeParams & mount, const ConeOnWall & cone);

  [[nodiscard]] Expectation expect(const StateVector & state) const;
  [[nodiscard]] Ranger ranger() const { return ranger_; }

private:
  bool left_;
  Ranger ranger_;
  SideRangeParams mount_;
  ConeOnWall cone_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__SIDE_RANGE_AIDING_HPP_
