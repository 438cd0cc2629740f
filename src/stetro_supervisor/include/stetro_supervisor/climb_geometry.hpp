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

#ifndef STETRO_SUPERVISOR__CLIMB_GEOMETRY_HPP_
#define STETRO_SUPERVISOR__CLIMB_GEOMETRY_HPP_

#include <array>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot_geometry.hpp"
#include "stetro_site/sensor_place.hpp"

namespace stetro_supervisor
{

struct ClimbParams;

/// What the climb needs to know of one flight and of the body.
/**
 * Flight frame: x up the stairs from the foot of the first riser, y to the left from the
 * right-hand wall. Risers and treads are counted from 1, as the steps are.
 */
struct ClimbGeometry
{
  std::string segment_id = "flight";
  std::vector<double> riser_m;  ///< height of riser 1..N [m]
  std::vector<double> tread_m;  ///< depth of tread 1..N [m]
  double width_m = 0.0;         ///< between the walls at the foot [m]
  double widening_m = 0.0;      ///< how much wider the flight is at its top [m]

  double contact_width_m = 0.23;  ///< bumper to bumper (D1-1) [m]
  double stroke_m = 0.18;         ///< lift of a block [m]
  /// What each sensor reads, bias included, when its block touches what it looks at [m].
  std::array<double, stetro_site::kPlaces.size()> contact_reading_m{0.035, 0.035, 0.035, 0.065,
                                                                    0.065, 0.035, 0.035, 0.035};
  double switch_separation_m = 0.16;  ///< between the riser switches [m]
  double sensor_minimum_m = 0.03;     ///< shortest range the sensors resolve [m]
  double sensor_sigma_m = 0.0021;     ///< noise of one reading at contact [m]

  double contact_reading(stetro_site::Place place) const
  {
    return contact_reading_m[stetro_site::index_of(place)];
  }

  /// The gap that a sensor of this place, never calibrated, may still show in contact [m].
  /** The noise of one reading, the offset and the gain error at the contact reading, added in
   *  squares, times `contact.doubt_sigmas`. A calibrated sensor shows far less. */
  double contact_doubt_m(stetro_site::Place place, const ClimbParams & params) const;

  int steps() const { return static_cast<int>(riser_m.size()); }

  /// Depth of tread `step`, 1..N [m].
  double tread(int step) const { return tread_m.at(static_cast<std::size_t>(step - 1)); }

  /// Height of riser `step`, 1..N [m].
  double riser(int step) const { return riser_m.at(static_cast<std::size_t>(step - 1)); }

  /// Between the walls in the middle of tread `step`, as far up as that is [m].
  double width_at_m(int step) const;

  /// base_link's distance from the right wall in the middle of tread `step` [m].
  double middle_y_m(int step) const { return width_at_m(step) / 2.0; }
};

/// The flight as the site file has it, and the body as the robot file has it.
ClimbGeometry make_geometry(
  const stetro_site::Flight & flight, const stetro_site::RobotGeometry & robot);

/// Adds a fault for every number that cannot be climbed: no step, a riser within 1 cm of the
/// stroke, a width that leaves no clearance in the middle (D3-12), a threshold that the recessed
/// sensor cannot resolve (D2), a doubt of the ranges that could hide a riser, a creep that is no
/// slower than other speeds.
void check_climbable(
  const ClimbGeometry & geometry, const ClimbParams & params, stetro_config::Faults & faults);

/// The same. \throws std::invalid_argument with every fault
void check_climbable(const ClimbGeometry & geometry, const ClimbParams & params);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__CLIMB_GEOMETRY_HPP_
