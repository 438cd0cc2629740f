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

#include "accuracy/climb.hpp"

#include "accuracy/closed_loop.hpp"
#include "accuracy/estimate_scorer.hpp"
#include "accuracy/moment.hpp"
#include "accuracy/staircase_watch.hpp"

namespace stetro_bringup
{
namespace
{

stetro_driver::SimOptions sim_options(const RobotSetup & setup, const ClimbOrder & order)
{
  stetro_driver::DriverParams params = setup.driver.params;
  params.sim.seed = static_cast<std::int64_t>(order.seed);
  params.sim.world = order.world;
  params.sim.errors.calibration = order.calibration;
  params.sim.faults = order.faults;
  return stetro_driver::sim_options(params);
}

}  // namespace

ClimbRecord climb(const RobotSetup & setup, const ClimbOrder & order)
{
  ClosedLoop loop(setup, sim_options(setup, order), order.estimators);
  std::vector<EstimateScorer> scorers;
  for (std::size_t i = 0; i < loop.estimators(); ++i) {
    scorers.emplace_back(setup.flight(), order.onset);
  }
  StaircaseWatch stairs;
  while (loop.end() == ClimbEnd::kRunning) {
    loop.tick();
    stairs.watch(loop.truth());
    for (std::size_t i = 0; i < scorers.size(); ++i) {
      scorers[i].watch(moment_of(loop, i));
    }
  }
  ClimbRecord record;
  record.seed = order.seed;
  record.faults = order.faults;
  record.end = loop.end();
  record.detail = loop.detail();
  record.simulated_s = loop.elapsed_s();
  record.last_step = loop.truth().step;
  for (std::size_t i = 0; i < scorers.size(); ++i) {
    record.scores.push_back(scorers[i].take());
    record.scores.back().staircase = stairs.score(
      loop.estimator(i).staircase_as_built(), setup.flight(),
      setup.localizer.params.fused.alerts.as_built_m);
  }
  return record;
}

}  // namespace stetro_bringup
