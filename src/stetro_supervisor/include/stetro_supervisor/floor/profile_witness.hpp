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

#ifndef STETRO_SUPERVISOR__FLOOR__PROFILE_WITNESS_HPP_
#define STETRO_SUPERVISOR__FLOOR__PROFILE_WITNESS_HPP_

#include <memory>
#include <optional>

#include "stetro_site/robot_geometry.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"
#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/floor/heading_tables.hpp"
#include "stetro_supervisor/floor/scan.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"

namespace stetro_supervisor
{

/// What the profile says of a place of the robot.
struct Testimony
{
  ProfileFinding finding;           ///< of the scanner
  std::optional<FloorPlace> found;  ///< base_link, where there is a verdict on one place
  Eigen::Vector2d expected_centroid_m{0.0, 0.0};  ///< of the map's profile, in the floor's frame
  Eigen::Vector2d measured_centroid_m{0.0, 0.0};  ///< of the scan, at the best place
  double residual_m = 0.0;       ///< root mean square of the agreeing beams, at the best place [m]
  double spectral_radius = 0.0;  ///< of the centroid's steps there; 1 and more: worth nothing
};

/// Asks the trusted centre of mass where on one floor the robot is.
/**
 * What it tells is base_link's place, with a covariance that holds
 *   - what the beams leave open, and the strangers among them, or where the floor has changed too
 *     much for the profiles what the ends of the beams leave open; and never less than the map
 *     promises of the place (`ScanCheck`);
 *   - `floor.pose_sigma_m` and `floor.pose_sigma_rad`: stamp, tilt and mounting of the scanner;
 *   - where the map alone says that the centroid contracts by less than a half, as much more as it
 *     contracts less: its steps then had no say, and the beams alone must be right. It is asked
 *     of the very place that was found, as `UsabilityLayer` asks it of a grid of places.
 *
 * Keeps its memory from scan to scan; for one thread.
 */
class ProfileWitness
{
public:
  /// \param floor outlives the witness
  ProfileWitness(
    const DrawnFloor & floor, const stetro_site::Lidar & lidar, const FloorParams & params);
  ~ProfileWitness();
  ProfileWitness(ProfileWitness &&) noexcept;

  /// Is the robot about there? Looks `floor.check_radius_m` around, at about that heading.
  [[nodiscard]] Testimony about(const Scan & scan, const FloorPlace & place);

  /// The same for a place that was guessed: near it or not at all, without trying places between.
  [[nodiscard]] Testimony at(const Scan & scan, const FloorPlace & guess);

  /// Mean capped difference between a scan of few beams and the map, from a place [m].
  [[nodiscard]] double misfit_m(const Beams & few, const FloorPlace & place);

  [[nodiscard]] const DrawnFloor & floor() const noexcept;

  /// For the four-beam search on this floor.
  [[nodiscard]] HeadingTables & headings() noexcept;

private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// The scanner's pose for a place of base_link, and back.
[[nodiscard]] ScannerPose scanner_at(const FloorPlace & place, const stetro_site::Lidar & lidar);
[[nodiscard]] FloorPlace base_at(const ScannerPose & scanner, const stetro_site::Lidar & lidar);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__PROFILE_WITNESS_HPP_
