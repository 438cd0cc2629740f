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

#ifndef ACCURACY__CLIMB_SCORE_HPP_
#define ACCURACY__CLIMB_SCORE_HPP_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/closed_loop.hpp"
#include "accuracy/fault_watch.hpp"
#include "accuracy/protection.hpp"
#include "accuracy/staircase_watch.hpp"
#include "accuracy/step_watch.hpp"
#include "accuracy/tread_errors.hpp"

namespace stetro_bringup
{

/// One estimate of a working robot beside the truth of its time.
struct ScoredEstimate
{
  int step = 0;              ///< true tread of block 2
  bool first_tread = false;  ///< before block 2 was first lifted on the stairs
  bool after_onset = false;  ///< the injected fault has begun
  bool confirming = false;   ///< block 2 has just come down and the step is not counted yet
  stetro_localizer::Integrity integrity{};
  TreadErrors errors{};
  double nees = 0.0;
  Protection protection;
  double sigma_x_m = 0.0;
  double sigma_y_m = 0.0;
  double sigma_heading_rad = 0.0;
  double sigma_flight_x_m = 0.0;
  double sigma_flight_z_m = 0.0;
};

/// What the estimate jumped beside the truth when the set of used sensors changed.
struct HandOver
{
  double x_m = 0.0;
  double y_m = 0.0;
};

/// One estimator in one climb.
struct ClimbScore
{
  std::vector<ScoredEstimate> samples;
  std::vector<HandOver> hand_overs;
  std::vector<double> closures_m;  ///< eq. (3) of each tread but the first
  std::vector<double> first_closures_m;
  std::uint64_t ticks_ok = 0;  ///< from the climb's acceptance on
  std::uint64_t ticks_degraded = 0;
  std::uint64_t ticks_lost = 0;
  std::uint64_t treads = 0;             ///< stood on while the integrity was watched
  std::uint64_t treads_alarmed = 0;     ///< of these, with integrity other than OK at any time
  std::uint64_t treads_exceeded = 0;    ///< of these, with an error beyond its level while OK
  std::uint64_t treads_misled = 0;      ///< of these, for longer than the time to alert
  double longest_confirmation_s = 0.0;  ///< from a touch-down to its being counted
  std::uint64_t resets = 0;             ///< jumps that the estimate declared
  std::uint64_t without_value = 0;      ///< estimates that lack x, y, z or the heading
  std::uint64_t out_of_truth = 0;       ///< estimates stamped outside the kept truth
  std::uint64_t alarms = 0;             ///< times integrity left OK after the first tread
  StepTally steps;
  double longest_exceedance_s = 0.0;  ///< error beyond the protection level while OK
  double stated_risk = std::numeric_limits<double>::quiet_NaN();  ///< integrity risk, per step
  StaircaseScore staircase;            ///< as found by the end of the climb
  std::optional<Detection> detection;  ///< only when a fault was injected
};

/// One climb.
struct ClimbRecord
{
  std::uint64_t seed = 0;
  std::string faults;  ///< as the simulator was told
  ClimbEnd end = ClimbEnd::kRunning;
  std::string detail;
  double simulated_s = 0.0;
  int last_step = 0;               ///< true tread at the end
  std::vector<ClimbScore> scores;  ///< by estimator
};

}  // namespace stetro_bringup

#endif  // ACCURACY__CLIMB_SCORE_HPP_
