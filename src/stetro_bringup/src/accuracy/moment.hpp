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

#ifndef ACCURACY__MOMENT_HPP_
#define ACCURACY__MOMENT_HPP_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "stetro_driver/sim_robot.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_supervisor/climb_state.hpp"

namespace stetro_bringup
{

class ClosedLoop;

/// One tick of a climb, as one estimator is judged by it.
struct Moment
{
  stetro_driver::Time time{0};
  double elapsed_s = 0.0;  ///< simulated, since the start
  bool accepted = false;   ///< the climb is under way
  stetro_supervisor::State state = stetro_supervisor::State::kIdle;
  stetro_driver::GroundTruth truth;  ///< now
  stetro_localizer::StairEstimate estimate;
  bool refreshed = false;      ///< the tick gave a new estimate
  std::uint32_t in_sight = 0;  ///< a bit for each side and front sensor, see in_sight_of()
  std::optional<stetro_driver::GroundTruth> truth_at_stamp;  ///< of a new estimate, if still kept
};

/// The loop after a tick, by the estimator of that number.
[[nodiscard]] Moment moment_of(const ClosedLoop & loop, std::size_t estimator);

/// Which of the side and front sensors have their target in sight, believed or not: a bit for each.
[[nodiscard]] std::uint32_t in_sight_of(const stetro_localizer::SourceReports & reports);

}  // namespace stetro_bringup

#endif  // ACCURACY__MOMENT_HPP_
