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

#ifndef ACCURACY__ACCURACY_REPORT_HPP_
#define ACCURACY__ACCURACY_REPORT_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "accuracy/climb.hpp"
#include "accuracy/estimator_totals.hpp"

namespace stetro_bringup
{

/// A climb that did not reach its end, and why.
struct Unfinished
{
  std::uint64_t seed = 0;
  std::string faults;
  ClimbEnd end{};
  std::string detail;
  int last_step = 0;
};

/// All climbs of one scenario, or of all of them.
struct ScenarioTotals
{
  ScenarioTotals(std::string name, int steps, std::size_t estimators);

  void add(const ClimbRecord & record);

  std::string name;
  std::uint64_t climbs = 0;
  std::uint64_t finished = 0;
  std::uint64_t steps_climbed = 0;
  double simulated_s = 0.0;
  std::vector<Unfinished> unfinished;
  std::vector<EstimatorTotals> estimators;  ///< in the order of AccuracyReport::estimators
};

/// What a run of stetro_accuracy found.
struct AccuracyReport
{
  std::uint64_t runs = 0;
  std::uint64_t first_seed = 0;
  std::string world;
  std::string calibration;
  std::string flight;
  int steps = 0;
  std::vector<std::string> estimators;  ///< by name; the first drove
  ScenarioTotals overall;
  std::vector<ScenarioTotals> scenarios;  ///< empty: fault-free
};

/// `summary.json`, as docs/accuracy.md explains it. SI units; what is not known is null.
/** It holds nothing of the clock on the wall: the same climbs give the same bytes. */
[[nodiscard]] std::string summary_json(const AccuracyReport & report);

/// The main figures for a reader: millimetres and degrees.
[[nodiscard]] std::string summary_table(const AccuracyReport & report);

}  // namespace stetro_bringup

#endif  // ACCURACY__ACCURACY_REPORT_HPP_
