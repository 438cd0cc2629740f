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

#include "stetro_supervisor/climb_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "stetro_config/value.hpp"
#include "stetro_supervisor/climb_params.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kLiftMargin_m = 0.01;

std::string metres(double value_m) { return stetro_config::to_text(value_m) + " m"; }

void check_flight(const ClimbGeometry & g, stetro_config::Faults & faults)
{
  if (g.riser_m.empty() || g.riser_m.size() != g.tread_m.size()) {
    faults.refuse(
      "flight",
      std::to_string(g.riser_m.size()) + " risers, " + std::to_string(g.tread_m.size()) + " treads",
      "as many treads as risers, at least one");
  }
  for (const double riser : g.riser_m) {
    if (!(riser > 0.0 && riser + kLiftMargin_m <= g.stroke_m)) {
      faults.refuse(
        "riser_m", metres(riser),
        "above 0 and at most the stroke less " + metres(kLiftMargin_m) + ", " +
          metres(g.stroke_m - kLiftMargin_m));
    }
  }
}

void check_width(const ClimbGeometry & g, const ClimbParams & p, stetro_config::Faults & faults)
{
  const double least = g.contact_width_m + 2.0 * (p.wall_clearance_m + p.middle_tolerance_m);
  const double narrowest = g.width_m + std::min(0.0, g.widening_m);
  if (!(narrowest >= least)) {
    faults.refuse(
      "width_m", metres(narrowest),
      "at least " + metres(least) +
        ", the contact width, and sweep.wall_clearance_m with sweep.middle_tolerance_m either "
        "side");
  }
}

void check_threshold(
  const char * name, double gap_m, double recess_m, double minimum_m,
  stetro_config::Faults & faults)
{
  if (!(gap_m + recess_m >= minimum_m)) {
    faults.refuse(
      name, metres(gap_m),
      "with the recess of " + metres(recess_m) + " at least range_sensor.min_range_m, " +
        metres(minimum_m));
  }
}

/// A block that stands a whole riser above what is below its sensor must not pass for down.
void check_doubt(const ClimbGeometry & g, const ClimbParams & p, stetro_config::Faults & faults)
{
  const double doubt_m = g.contact_doubt_m(stetro_site::Place::kBlock2Down, p);
  for (const double riser : g.riser_m) {
    if (!(doubt_m < riser / 2.0)) {
      faults.refuse(
        "contact.doubt_sigmas", stetro_config::to_text(p.doubt_sigmas),
        "such that the gap in doubt, " + metres(doubt_m) + ", is less than half the riser of " +
          metres(riser));
    }
  }
}

}  // namespace

double ClimbGeometry::contact_doubt_m(stetro_site::Place place, const ClimbParams & params) const
{
  const double gain_m = params.gain_sigma * contact_reading(place);
  return params.doubt_sigmas * std::hypot(params.offset_sigma_m, gain_m, sensor_sigma_m);
}

double ClimbGeometry::width_at_m(int step) const
{
  const double share = steps() > 0 ? (std::max(step, 1) - 0.5) / steps() : 0.0;
  return width_m + widening_m * std::min(share, 1.0);
}

ClimbGeometry make_geometry(
  const stetro_site::Flight & flight, const stetro_site::RobotGeometry & robot)
{
  using stetro_site::Place;
  ClimbGeometry geometry;
  geometry.segment_id = flight.id();
  for (int i = 1; i <= flight.steps(); ++i) {
    geometry.riser_m.push_back(flight.riser_m(i));
    geometry.tread_m.push_back(flight.tread_m(i));
  }
  geometry.width_m = flight.spec().width_foot_m;
  geometry.widening_m = flight.spec().width_top_m - flight.spec().width_foot_m;
  geometry.contact_width_m = robot.contact_width_m;
  geometry.stroke_m = robot.stroke_m;
  for (const Place place : stetro_site::kPlaces) {
    geometry.contact_reading_m[stetro_site::index_of(place)] =
      robot.contact_reading_m(place) + robot.at(place).bias_m;
  }
  geometry.sensor_minimum_m = robot.range_sensor.min_range_m;
  geometry.sensor_sigma_m = robot.range_sensor.sigma_m;
  geometry.switch_separation_m = 2.0 * robot.switch_y_m;
  return geometry;
}

void check_climbable(const ClimbGeometry & g, const ClimbParams & p, stetro_config::Faults & faults)
{
  check_flight(g, faults);
  check_width(g, p, faults);
  check_doubt(g, p, faults);
  const double minimum = g.sensor_minimum_m;
  using stetro_site::Place;
  check_threshold(
    "contact.approach_gap_m", p.approach_gap_m, g.contact_reading(Place::kStairFront), minimum,
    faults);
  check_threshold(
    "contact.block3_gap_m", p.block3_gap_m, g.contact_reading(Place::kBlock3Front), minimum,
    faults);
  check_threshold(
    "contact.touch_down_gap_m", p.touch_down_gap_m, g.contact_reading(Place::kBlock2Down), minimum,
    faults);
  if (!(p.creep_speed_mps < p.roll_speed_mps && p.creep_speed_mps < p.sweep_speed_mps)) {
    faults.refuse(
      "speeds.creep_m_s", stetro_config::to_text(p.creep_speed_mps),
      "less than speeds.roll_m_s (" + stetro_config::to_text(p.roll_speed_mps) +
        ") and speeds.sweep_m_s (" + stetro_config::to_text(p.sweep_speed_mps) + ")");
  }
}

void check_climbable(const ClimbGeometry & geometry, const ClimbParams & params)
{
  stetro_config::Faults faults;
  check_climbable(geometry, params, faults);
  std::string all;
  for (const stetro_config::Fault & fault : faults) {
    all += stetro_config::to_string(fault) + "\n";
  }
  if (!all.empty()) {
    throw std::invalid_argument(all);
  }
}

}  // namespace stetro_supervisor
