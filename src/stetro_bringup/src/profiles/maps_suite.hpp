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

#ifndef PROFILES__MAPS_SUITE_HPP_
#define PROFILES__MAPS_SUITE_HPP_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "profiles/recorded_floor.hpp"
#include "stetro_supervisor/profile/determination.hpp"

namespace stetro_bringup
{

/// A position is determined where the map alone promises it to this standard deviation [m].
constexpr double kDeterminedSigma = 0.0125;  // 5 cm are four of them

/// How one way of checking did on a map.
struct MapsScore
{
  std::size_t cases = 0;
  std::size_t solved = 0;  ///< a verdict within 5 cm
  std::size_t no_verdict = 0;
  std::size_t ambiguous = 0;
  std::size_t free_direction_shown = 0;  ///< a verdict whose covariance has a free direction
  std::size_t by_ends = 0;               ///< a verdict by the ends of the beams, not by profiles
  /// A verdict off by more than 25 cm, in a direction that the map determines or its covariance
  /// claims to know.
  std::size_t false_accepts = 0;
  std::map<std::string, std::size_t> reasons;  ///< of no verdict
  std::vector<double> us;

  void add(const MapsScore & other);
};

/// Whether a covariance shows the direction that the map tells worst, where it is not determined.
/** Along that direction it says more than the determined, and more than across it: 1.5 times, or as
 *  much as the map where that tells both about as badly. */
[[nodiscard]] bool shows_free_direction(
  const Eigen::Matrix2d & covariance, const stetro_supervisor::Determination & told);

/// Spectral radii of a floor's places, see Contraction.
struct RadiusFigures
{
  double median = 0.0;
  double share_below_1 = 0.0;  ///< of the area: a step makes a small error smaller
};

/// Spectral radii of a published step: below 0.5, to 1, above.
constexpr std::size_t kRadiusClasses = 3;
/// Steps of the published search that are drawn, the belief for the first.
constexpr std::size_t kDrawnSteps = 11;

/// One map: how much of it tells where one is, and how the checks did there and elsewhere.
struct MapsTable
{
  std::string name;
  double free_area_m2 = 0.0;      ///< where the body fits
  double determined_share = 0.0;  ///< of that area
  RadiusFigures guarded_radius;   ///< of the steps that run
  RadiusFigures published_radius;
  MapsScore determined;        ///< trusted, where the profile determines the pose
  MapsScore elsewhere;         ///< trusted
  MapsScore rough_determined;  ///< the same in a world with other cells along its walls
  MapsScore rough_elsewhere;
  MapsScore published;  ///< where the profile determines the pose
  /// Of the published search after each step, by the spectral radius at the true place.
  std::array<std::array<std::vector<double>, kDrawnSteps>, kRadiusClasses> published_errors_m;
};

/// Puts a scanner on each floor at poses drawn evenly over free space, and checks beliefs of it.
/**
 * 720 beams to 12 m, noise of 2 cm, one beam in ten without an echo; the belief is off by up to 1 m
 * and 1 degree (one standard deviation). Floors of one name share a table, and the poses of a table
 * by their area. \param done called after each case
 */
[[nodiscard]] std::vector<MapsTable> run_maps(
  const std::vector<RecordedFloor> & floors, std::size_t cases, std::uint64_t seed,
  const std::function<void()> & done);

}  // namespace stetro_bringup

#endif  // PROFILES__MAPS_SUITE_HPP_
