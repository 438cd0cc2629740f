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

#include "stetro_localizer/fused/as_built_record.hpp"

#include <algorithm>

namespace stetro_localizer
{
namespace
{

// Who comes back to a step knows it by the site file alone at first: the better estimate stays.
void keep_better(std::optional<ScalarEstimate> & kept, const std::optional<ScalarEstimate> & found)
{
  if (found && (!kept || found->variance < kept->variance)) {
    kept = found;
  }
}

void keep_better(std::vector<StepAsBuilt> & steps, const StepAsBuilt & found)
{
  if (found.step < 1) {
    return;
  }
  StepAsBuilt & kept = steps[static_cast<std::size_t>(found.step) - 1];
  kept.step = found.step;
  keep_better(kept.tread_m, found.tread_m);
  keep_better(kept.width_m, found.width_m);
}

}  // namespace

void AsBuiltRecord::follow(const FusedCore & settled)
{
  if (settled.jumps != jumps_) {
    jumps_ = settled.jumps;
    std::fill(steps_.begin(), steps_.end(), StepAsBuilt{});
  }
  keep_better(steps_, settled.left_behind);
}

std::vector<StepAsBuilt> AsBuiltRecord::steps(const FusedCore & now, const StepAsBuilt & here) const
{
  std::vector<StepAsBuilt> steps = steps_;
  if (now.jumps != jumps_) {
    std::fill(steps.begin(), steps.end(), StepAsBuilt{});
  }
  keep_better(steps, now.left_behind);
  keep_better(steps, here);
  const auto unseen = [](const StepAsBuilt & one) { return one.step == 0; };
  steps.erase(std::remove_if(steps.begin(), steps.end(), unseen), steps.end());
  return steps;
}

}  // namespace stetro_localizer
