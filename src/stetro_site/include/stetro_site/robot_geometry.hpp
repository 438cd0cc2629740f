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

#ifndef STETRO_SITE__ROBOT_GEOMETRY_HPP_
#define STETRO_SITE__ROBOT_GEOMETRY_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_site/sensor_place.hpp"

namespace stetro_site
{

/// Where a range sensor sits and how far it is out.
struct Mounting
{
  double x_m;           ///< in `base_link` [m]
  double y_m;           ///< in `base_link` [m]
  double height_m;      ///< above the underside of its own block [m]
  double bias_m = 0.0;  ///< it reads this much too far, by calibration [m]
};

/// What the range sensors, all of one type, can do.
struct RangeSensor
{
  double min_range_m = 0.03;       ///< nearer is not resolved (D3-7) [m]
  double reliable_range_m = 1.20;  ///< farther is not trusted (S-B, Algorithm I) [m]
  double cone_rad = 0.4363;        ///< full angle of the beam, 25 deg [rad]
  double sigma_m = 0.0021;         ///< standard deviation at zero range [m]
  double sigma_per_m = 0.015;      ///< its part that grows with range, added in squares [m/m]

  /// Standard deviation of one reading [m].
  [[nodiscard]] double sigma_at_m(double range_m) const;
};

/// The lidar on block 2: a full turn of beams in one level plane.
struct Lidar
{
  double x_m = 0.0;           ///< in `base_link` [m]
  double y_m = 0.0;           ///< in `base_link` [m]
  double height_m = 0.45;     ///< above block 2's underside [m]
  double yaw_rad = 0.0;       ///< of its own x axis in `base_link`, CCW [rad]
  double min_range_m = 0.15;  ///< nearer is not resolved [m]
  double max_range_m = 12.0;  ///< farther returns nothing [m]
  std::int64_t beams = 720;   ///< of one turn, evenly; the first at -pi, counter-clockwise
  double rate_hz = 10.0;      ///< turns a second [Hz]
  double sigma_m = 0.01;      ///< standard deviation of one range [m]
};

template <class Visitor>
void visit(Lidar & p, Visitor && each)
{
  using stetro_config::Within;
  each("x_m", p.x_m, Within{-1.0, 1.0}, "in base_link [m]");
  each("y_m", p.y_m, Within{-0.5, 0.5}, "in base_link [m]");
  each("height_m", p.height_m, Within{0.0, 2.0}, "above block 2's underside [m]");
  each("yaw_rad", p.yaw_rad, Within{-3.1416, 3.1416}, "of its x axis in base_link [rad]");
  each("min_range_m", p.min_range_m, Within{0.0, 1.0}, "nearest it resolves [m]");
  each("max_range_m", p.max_range_m, Within{0.5, 100.0}, "farther returns nothing [m]");
  each("beams", p.beams, Within{4, 8192}, "of one turn");
  each("rate_hz", p.rate_hz, Within{1.0, 50.0}, "turns a second [Hz]");
  each("sigma_m", p.sigma_m, Within{1e-4, 0.2}, "standard deviation of one range [m]");
}

/// The body of the robot and where things sit on it.
/**
 * Three equal blocks in a row, 1 in front, each free to slide up and down. `base_link` is the
 * centre of block 2's footprint; x forward, y left, z up. The papers give no drawing: the defaults
 * are a body that agrees with their figures and with the pseudocode of S-P.
 */
struct RobotGeometry
{
  double block_length_m = 0.15;   ///< of each block, along x [m]
  double body_width_m = 0.20;     ///< of each block, along y [m]
  double body_height_m = 0.40;    ///< of each block [m]
  double contact_width_m = 0.23;  ///< bumper to bumper, not the body's width (D1-1) [m]
  double stroke_m = 0.18;         ///< lift of a block [m]
  double stroke_margin_m = 0.02;  ///< the stroke must exceed a riser by this [m]
  double switch_x_m = 0.075;      ///< riser switches in `base_link` [m]
  double switch_y_m = 0.08;       ///< left one at +y, right one at -y [m]
  RangeSensor range_sensor;
  std::array<Mounting, kPlaces.size()> mountings{{
    {0.19, 0.10, 0.07},   // front_left
    {0.19, -0.10, 0.07},  // front_right
    {0.19, 0.0, 0.07},    // stair_front
    {0.0, 0.05, 0.33},    // side_left
    {0.0, -0.05, 0.33},   // side_right
    {0.15, 0.0, 0.035},   // block1_down
    {0.0, 0.0, 0.035},    // block2_down
    {-0.11, 0.0, 0.07},   // block3_front
  }};
  Lidar lidar;

  [[nodiscard]] const Mounting & at(Place place) const { return mountings[index_of(place)]; }
  [[nodiscard]] Mounting & at(Place place) { return mountings[index_of(place)]; }

  [[nodiscard]] double length_m() const { return 3.0 * block_length_m; }
  /// Centre of block 1, 2 or 3 in `base_link` [m].
  [[nodiscard]] double block_x_m(int block) const { return (2 - block) * block_length_m; }
  /// Farthest point of the bumpers from `base_link` along x: their longest lever arm [m].
  [[nodiscard]] double bumper_lever_m() const { return 0.5 * length_m(); }
  /// D of S-B eq. (2): between the beams of the front pair, not the body's width (D1-7) [m].
  [[nodiscard]] double front_baseline_m() const;
  /// s: between the origins of the side beams [m].
  [[nodiscard]] double side_separation_m() const;
  /// What a sensor reads when its block touches what it looks at: its recess [m].
  /** For the sides the touching part is the bumper, for the others the block. Without bias. */
  [[nodiscard]] double contact_reading_m(Place place) const;
};

/// Every contradiction among the robot's own numbers (D1-7, D2, D3-7), by the names of `visit`.
void check(const RobotGeometry & robot, stetro_config::Faults & faults);

/// Declares the robot's numbers; see `stetro_config/field.hpp`.
template <class Visitor>
void visit(RobotGeometry & p, Visitor && each)
{
  using stetro_config::Within;
  each("body.block_length_m", p.block_length_m, Within{0.05, 0.5}, "length of each block [m]");
  each("body.width_m", p.body_width_m, Within{0.05, 1.0}, "width of the blocks [m]");
  each("body.height_m", p.body_height_m, Within{0.05, 1.5}, "height of each block [m]");
  each("body.contact_width_m", p.contact_width_m, Within{0.05, 1.0}, "bumper to bumper [m]");
  each("lift.stroke_m", p.stroke_m, Within{0.05, 0.5}, "lift of a block [m]");
  each("lift.margin_m", p.stroke_margin_m, Within{0.0, 0.1}, "stroke beyond a riser [m]");
  each("riser_switches.x_m", p.switch_x_m, Within{-1.0, 1.0}, "in base_link [m]");
  each("riser_switches.y_m", p.switch_y_m, Within{0.0, 0.5}, "left at +y, right at -y [m]");
  RangeSensor & range = p.range_sensor;
  each("range_sensor.min_range_m", range.min_range_m, Within{0.0, 0.5}, "nearest it resolves [m]");
  each(
    "range_sensor.reliable_range_m", range.reliable_range_m, Within{0.1, 10.0},
    "farthest to be trusted [m]");
  each("range_sensor.cone_rad", range.cone_rad, Within{0.0, 1.0}, "full angle of the beam [rad]");
  each("range_sensor.sigma_m", range.sigma_m, Within{1e-4, 0.1}, "noise at zero range [m]");
  each(
    "range_sensor.sigma_per_m", range.sigma_per_m, Within{0.0, 0.2},
    "noise that grows with range, added in squares [m/m]");
  for (const Place place : kPlaces) {
    Mounting & mounting = p.at(place);
    const std::string name = "sensors." + name_of(place);
    each(name + ".x_m", mounting.x_m, Within{-1.0, 1.0}, "in base_link [m]");
    each(name + ".y_m", mounting.y_m, Within{-0.5, 0.5}, "in base_link [m]");
    each(
      name + ".height_m", mounting.height_m, Within{0.0, 1.5}, "above its block's underside [m]");
    each(name + ".bias_m", mounting.bias_m, Within{-0.1, 0.1}, "reads this much too far [m]");
  }
  visit(p.lidar, stetro_config::Group{"lidar", each});
}

}  // namespace stetro_site

#endif  // STETRO_SITE__ROBOT_GEOMETRY_HPP_
