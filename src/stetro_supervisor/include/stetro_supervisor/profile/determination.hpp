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

#ifndef STETRO_SUPERVISOR__PROFILE__DETERMINATION_HPP_
#define STETRO_SUPERVISOR__PROFILE__DETERMINATION_HPP_

#include <Eigen/Core>
#include <cstddef>

#include "stetro_site/profile_caster.hpp"
#include "stetro_supervisor/profile/beam_noise.hpp"

namespace stetro_supervisor
{

/// How a place's profile is asked what it tells.
struct DeterminationParams
{
  std::size_t beams = 720;
  double reach_m = 12.0;
  BeamNoise noise{0.02, 0.015, 0.5};
  double yaw_sigma_rad = 0.0175;  ///< of the heading before the profile is looked at
  double piece_m = 0.4;           ///< of a wall, from which its direction is taken
  double bent_m = 0.025;          ///< most, root mean square off a straight line: half a cell
};

/// How well the position could be told at best, by the map alone.
struct Determination
{
  /// Bounded by the information of all straight pieces of wall, floor's axes [m^2].
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  Eigen::Vector2d worst_direction = Eigen::Vector2d::UnitX();  ///< unit vector
  double worst_sigma_m = 0.0;  ///< standard deviation along it, +inf where nothing tells
};

/// Where a profile determines the place it is seen from (Cramer and Rao's bound).
/**
 * With the walls' normals n, the information of position and heading is sum H'H / v as in
 * compare_beams(), of beams that meet a straight piece of wall: ends about them that lie on a line.
 * Legs of furniture, corners and frames have no direction that a scan would see again.
 *
 * On a map of cells a straight wall is a staircase, and the flight of its normals about the wall's
 * own looks like information along the wall. So the direction that is told worst must be told by
 * walls that stand across it: from those only with |n u| above sin 20 degrees its variance is
 * counted again.
 */
[[nodiscard]] Determination determination(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & position_m,
  const DeterminationParams & params);

/// A pose's covariance, in the floor's axes, no surer than the map along what it tells worst.
/** Left alone where the map promises the position to `determined_sigma_m`; 0: nowhere. */
[[nodiscard]] Eigen::Matrix3d widened(
  Eigen::Matrix3d covariance, const Determination & told, double determined_sigma_m);

/// A pose's covariance whose ellipse is no rounder than that of the map's bound.
/**
 * For a place that was found by coarser means than the bound is made for: how much coarser shows in
 * the direction that is told well, and in the other it is as much.
 */
[[nodiscard]] Eigen::Matrix3d stretched(Eigen::Matrix3d covariance, const Determination & told);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__DETERMINATION_HPP_
