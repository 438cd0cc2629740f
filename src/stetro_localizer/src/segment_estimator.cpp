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

#include "stetro_localizer/segment_estimator.hpp"

#include <stdexcept>

#include "stetro_localizer/fused_estimator.hpp"
#include "stetro_localizer/paper_estimator.hpp"

namespace stetro_localizer
{

Legacy legacy_of(
  const StairEstimate & estimate, const SourceReports & reports, const StoredState & stored)
{
  Legacy legacy;
  legacy.calibration = stored;
  legacy.calibration.step.reset();
  legacy.reset_counter = estimate.reset_counter;
  legacy.reset_cause = estimate.reset_cause;
  legacy.reset_delta = estimate.reset_delta;
  legacy.reports = reports;
  legacy.stamp = estimate.stamp;
  return legacy;
}

void take_over(StairEstimate & estimate, const Legacy & legacy)
{
  estimate = StairEstimate{};
  estimate.stamp = legacy.stamp;
  estimate.reset_counter = legacy.reset_counter;
  estimate.reset_cause = legacy.reset_cause;
  estimate.reset_delta = legacy.reset_delta;
}

std::unique_ptr<SegmentEstimator> make_estimator(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight, bool floors_drawn)
{
  if (params.estimator == "paper") {
    return std::make_unique<PaperEstimator>(params, robot, flight);
  }
  if (params.estimator == "fused") {
    return std::make_unique<FusedEstimator>(params, robot, flight, floors_drawn);
  }
  throw std::invalid_argument(
    "estimator: '" + params.estimator + "' refused, accepted: fused, paper");
}

}  // namespace stetro_localizer
