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
#ifndef STETRO_BRINGUP__SUMMARY_HPP_
#define STETRO_BRINGUP__SUMMARY_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "stetro_bringup/climb_report.hpp"
#include "stetro_bringup/journey_report.hpp"
#include "stetro_bringup/staircase_found.hpp"

namespace stetro_bringup
{

/// How a climb ended.
struct ClimbOutcome
{
  bool completed = false;                 ///< the mission was reported finished
  std::string final_segment;              ///< last flight or floor the localizer stated
  int final_step = -1;                    ///< last step the localizer stated, -1 unknown
  std::string integrity;                  ///< last integrity: OK, DEGRADED, LOST, UNKNOWN
  std::uint64_t seed = 0;                 ///< of the simulated world and its sensors
  std::string estimator;                  ///< paper or fused
  std::string world;                      ///< as-built or site
  std::string calibration;                ///< factory or none
  bool in_process = false;                ///< one process, or three over the loopback
  double wall_time_s = 0.0;               ///< of the whole run, discovery included
  double simulated_time_s = 0.0;          ///< the same on the robot's clock
  StaircaseFound staircase;               ///< the last that the localizer said of it
  std::vector<SegmentChange> hand_overs;  ///< between floors and flights
  std::vector<Kidnap> kidnaps;
  std::vector<std::string> kidnaps_asked;  ///< floors on which one is to happen and to be seen
  int times_held = 0;                      ///< the mission, until somebody resumed it
  std::vector<std::string> faults;         ///< every fault the supervisor reported, in order
  std::vector<std::string> shortfalls;     ///< of `shortfalls()`; empty: it succeeded
};

/// The climb as `summary.json`: SI units in the key names, null for what is not known.
[[nodiscard]] std::string summary_json(const ClimbOutcome & outcome, const ClimbErrors & errors);

/// The climb for a reader.
void print_summary(std::ostream & out, const ClimbOutcome & outcome, const ClimbErrors & errors);

/// Where a run is to end: on a step of a flight, or on a floor (step 0).
struct Goal
{
  std::string segment;
  int step = 0;
};

/// What a run falls short of, in words.
/**
 * It must end at its goal, trusted and without a fault; the pose may jump by 1 cm where it passes
 * between floor and flight; a kidnap must be noticed within 5 s of motion, and the robot found.
 */
[[nodiscard]] std::vector<std::string> shortfalls(const ClimbOutcome & outcome, const Goal & goal);

/// It falls short of nothing.
[[nodiscard]] bool succeeded(const ClimbOutcome & outcome, const Goal & goal);

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__SUMMARY_HPP_
