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

#ifndef STETRO_LOCALIZER__FLOOR__PASSAGE_HPP_
#define STETRO_LOCALIZER__FLOOR__PASSAGE_HPP_

#include "stetro_localizer/floor/floor_params.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_site/flight.hpp"

namespace stetro_localizer
{

/// Where a flight ends for the localizer, and the floor begins.
/**
 * In the flight's frame, with the approach a, the retreat b and the run L of the flight:
 *
 *   floor below -> flight   -a <= x < 0, between the walls, facing the stairs, known well enough
 *   flight -> floor below   on step 0 and x < -(a + b), or turned away
 *   flight -> floor above   on the last step and x >= L - top, the blocks level and at rest
 *
 * The first and the second leave room between them, so that nothing flutters.
 */
class Passage
{
public:
  Passage(const FloorParams & params, const stetro_site::Flight & flight)
  : params_(params), flight_(&flight)
  {
  }

  /// The robot on the floor below has come to the foot of the flight.
  /** \param in_map the pose \param covariance of it */
  [[nodiscard]] bool enters(
    const stetro_site::Pose & in_map, const stetro_site::Covariance & covariance) const;

  /// The robot on step 0 has turned to the floor below. \param pose in the flight's frame
  [[nodiscard]] bool retreats(int step, const stetro_site::Pose & pose) const;

  /// The robot on the last step stands level, as it may at its end.
  [[nodiscard]] bool may_leave(int step, const BlockSample & blocks) const;
  /// And it is at its end. \param in_map the pose in `map`
  [[nodiscard]] bool leaves(const stetro_site::Pose & in_map) const;

private:
  FloorParams params_;
  const stetro_site::Flight * flight_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__PASSAGE_HPP_
