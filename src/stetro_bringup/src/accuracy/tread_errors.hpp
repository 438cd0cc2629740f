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

#ifndef ACCURACY__TREAD_ERRORS_HPP_
#define ACCURACY__TREAD_ERRORS_HPP_

#include "stetro_driver/sim_robot.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_site/flight.hpp"

namespace stetro_bringup
{

/// Estimate less truth at one time; NaN where the estimate does not say.
/**
 * Tread-relative errors are against the staircase as it was built, here and now; k is the tread
 * that block 2 truly stands on, so that a wrong step costs a whole tread in x and a riser in z:
 *
 *   x        from the riser ahead, along x at the robot's y: true less estimated distance. An
 *            estimate that gives none is taken from the riser's place in the site file. On the
 *            last tread, where no riser is left, it is `x_behind`.
 *   x_behind from the riser behind, likewise: estimated less true distance
 *   y        from the right wall
 *   z        of block 2's underside above the tread, lifted or not: the estimate's less the drawn
 *            tread's, against the truth above the built one
 *   heading  in the flight frame: the yaw
 *
 * Errors in the flight frame are against the site file's drawing: what the risers and treads below
 * were built too high or too deep is in them.
 */
struct TreadErrors
{
  double x_m;
  double x_behind_m;
  double y_m;
  double z_m;
  double heading_rad;
  double heading_to_riser_rad;  ///< against the direction of the riser ahead
  double flight_x_m;
  double flight_z_m;
};

/// \param flight the site file's, as the software believes it
[[nodiscard]] TreadErrors errors_of(
  const stetro_localizer::StairEstimate & estimate, const stetro_driver::GroundTruth & truth,
  const stetro_site::Flight & flight);

/// Normalised estimation error squared e^T P^-1 e of (x, y, heading), tread-relative.
/** NaN when an error is missing or the covariance cannot be inverted. */
[[nodiscard]] double nees_of(
  const TreadErrors & errors, const stetro_site::Covariance & covariance);

}  // namespace stetro_bringup

#endif  // ACCURACY__TREAD_ERRORS_HPP_
