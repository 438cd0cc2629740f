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
#ifndef DEMO__JOURNEY_PLAN_HPP_
#define DEMO__JOURNEY_PLAN_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "stetro_site/fit.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_bringup
{

/// A stretch of a journey that is driven on a floor.
struct FloorDriving
{
  std::string floor;
  double least_s = 0.0;  ///< that the robot drives there, by the shortest way at full speed
};

/// Where a journey through a building begins, and what the robot drives on its way.
struct JourneyPlan
{
  stetro_site::Pose start;  ///< base_link in the frame of the first flight
  std::vector<FloorDriving> floors;
};

/// Draws a start on the floor below a flight, and plans the way from there to a floor.
/**
 * The start is anywhere on the drawn floor, in any heading, where the body has room to turn, clear
 * of the stairs, and from where there is a way to their foot.
 * \throws std::runtime_error if there is no way or no such place, saying so
 */
[[nodiscard]] JourneyPlan plan_journey(
  const stetro_site::Deployment & deployment, const std::string & flight, const std::string & goal,
  std::uint64_t seed);

/// `kidnap` among faults becomes one kidnap on each floor, while the robot drives there.
/** The moments are drawn from the seed, from the first to the last fifth of the least driving. */
[[nodiscard]] std::vector<std::string> with_kidnaps_on_floors(
  const std::vector<std::string> & faults, const std::vector<FloorDriving> & floors,
  std::uint64_t seed);

/// The floors that kidnaps among faults name.
[[nodiscard]] std::vector<std::string> floors_of_kidnaps(const std::vector<std::string> & faults);

}  // namespace stetro_bringup

#endif  // DEMO__JOURNEY_PLAN_HPP_
