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

#include "accuracy/accuracy_report.hpp"

#include <utility>

namespace stetro_bringup
{

ScenarioTotals::ScenarioTotals(std::string scenario, int steps, std::size_t count)
: name(std::move(scenario)), estimators(count, EstimatorTotals(steps))
{
}

void ScenarioTotals::add(const ClimbRecord & record)
{
  ++climbs;
  steps_climbed += static_cast<std::uint64_t>(record.last_step);
  simulated_s += record.simulated_s;
  if (record.end == ClimbEnd::kFinished) {
    ++finished;
  } else {
    unfinished.push_back({record.seed, record.faults, record.end, record.detail, record.last_step});
  }
  for (std::size_t i = 0; i < estimators.size(); ++i) {
    estimators[i].add(record.scores.at(i));
  }
}

}  // namespace stetro_bringup
