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

#ifndef STETRO_SUPERVISOR__FLOOR__RANGE_SEARCH_HPP_
#define STETRO_SUPERVISOR__FLOOR__RANGE_SEARCH_HPP_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stetro_site/robot_geometry.hpp"
#include "stetro_supervisor/floor/profile_witness.hpp"
#include "stetro_supervisor/four_beams/heading_search.hpp"
#include "stetro_supervisor/observation.hpp"

namespace stetro_supervisor
{

/// The side and front range sensors, as the four beams of S-G.
struct RangeBeams
{
  std::vector<RangeBeam> beams;  ///< from base_link; those that say something
  std::vector<double> ranges_m;  ///< of each, as REP 117: +inf nothing in range, -inf too near
};

/// What the sensors read, those that are heard and healthy.
[[nodiscard]] RangeBeams range_beams_of(
  const Observation & seen, Time now, const stetro_site::RobotGeometry & robot,
  const FloorParams & params);

/// What they say of where the robot is.
struct RangeAnswer
{
  Verdict verdict = Verdict::kNoVerdict;  ///< kCorrected: one place; kAmbiguous, kNoVerdict
  std::string reason;                     ///< in words
  std::optional<FloorPlace> found;        ///< the one place, with its covariance
  double area_m2 = 0.0;                   ///< of all cells where it may be, however it faces
};

/// Finds where a robot without a lidar may be: on some floors, whichever way it faces.
/**
 * For every heading, `floor.search_heading_rad` apart, the cells of base_link that all ranges agree
 * with (`Reach`, (1)): they hold the truth if every range is within `floor.beam_error_m`. Short
 * ranges leave much: mostly the answer is ambiguous and says how much of the floors is left. It is
 * one place if all that is left lies within decimetres and in one direction.
 *
 * Work is cut into steps that fit a tick, as in `FloorSearch`. For one thread.
 */
class RangeSearch
{
public:
  /// \param witnesses of the floors; outlive the search
  RangeSearch(std::vector<ProfileWitness *> witnesses, RangeBeams beams);

  /// Works for a tick. \return the answer, once, when all is done
  [[nodiscard]] std::optional<RangeAnswer> step();

private:
  std::size_t go_on(std::size_t work);
  std::size_t look_up(std::size_t work);
  [[nodiscard]] bool fits(
    const DrawnFloor & floor, const Eigen::Vector2d & base_m, double yaw_rad) const;
  void note(const DrawnFloor & floor, std::size_t offset, double yaw_rad);
  void end_floor();
  [[nodiscard]] RangeAnswer answer() const;

  std::vector<ProfileWitness *> witnesses_;
  RangeBeams beams_;
  std::size_t floor_ = 0;    // that is looked through
  std::size_t heading_ = 0;  // of base_link
  std::size_t next_ = 0;     // cell
  std::vector<bool> cells_;  // of the present floor, where the robot may be
  double area_m2_ = 0.0;     // of those of the floors before
  double free_m2_ = 0.0;
  std::vector<std::string> on_;  // floors where it may be
  Eigen::Vector2d lowest_m_;     // of the places
  Eigen::Vector2d highest_m_;
  Eigen::Vector2d sum_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d facing_ = Eigen::Vector2d::Zero();  // sum of directions
  std::size_t places_ = 0;                            // cells and headings
  double cell_m_ = 0.0;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__RANGE_SEARCH_HPP_
