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

#include "accuracy/staircase_watch.hpp"

#include <cmath>

namespace stetro_bringup
{

using stetro_localizer::Deviation;
using stetro_localizer::StepMeasure;

void StaircaseWatch::watch(const stetro_driver::GroundTruth & truth)
{
  if (truth.step < 1) {
    return;
  }
  const double off_middle_m = std::abs(truth.y_m - truth.tread_width_m / 2.0);
  const auto known = steps_.find(truth.step);
  if (known == steps_.end() || off_middle_m < known->second.off_middle_m) {
    steps_[truth.step] = {off_middle_m, truth.tread_x_m + truth.riser_ahead_m, truth.tread_width_m};
  }
}

StaircaseScore StaircaseWatch::score(
  const std::vector<stetro_localizer::StepAsBuilt> & found, const stetro_site::Flight & site,
  double bound_m) const
{
  StaircaseScore score;
  for (const Deviation & one : stetro_localizer::deviations(found, site)) {
    score.reported += one.exceeds(bound_m) ? 1 : 0;
    const auto seen = steps_.find(one.step);
    const bool tread = one.measure == StepMeasure::kTread;
    if (seen == steps_.end()) {
      continue;
    }
    const double true_m = tread ? seen->second.tread_m : seen->second.width_m;
    if (std::isfinite(true_m)) {
      (tread ? score.treads : score.widths)
        .push_back(
          {one.step, one.found_m.value - true_m, std::sqrt(one.found_m.variance),
           one.site_m - true_m});
    }
  }
  return score;
}

}  // namespace stetro_bringup
