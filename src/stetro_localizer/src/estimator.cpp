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

#include "stetro_localizer/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "stetro_localizer/fused_estimator.hpp"
#include "stetro_localizer/paper_estimator.hpp"

namespace stetro_localizer
{

std::optional<std::string> implausible(
  const stetro_site::Pose & pose, const stetro_site::Flight & flight, double most_yaw_rad)
{
  if (!std::isfinite(pose.x_m + pose.y_m + pose.z_m + pose.yaw_rad)) {
    return "a number of the pose is not finite";
  }
  const int step = flight.step_at(pose.x_m);
  const double half_riser_m = flight.riser_m(std::max(step, 1)) / 2.0;
  if (std::abs(pose.z_m - flight.tread_z_m(step)) > half_riser_m) {
    return "its height is not that of step " + std::to_string(step) + ", which is under its x";
  }
  const double width_m = flight.width_m(std::clamp(pose.x_m, 0.0, flight.total_run_m()));
  if (pose.y_m < 0.0 || pose.y_m > width_m) {
    return "its y is not between the walls";
  }
  if (std::abs(pose.yaw_rad) > most_yaw_rad) {
    return "its heading does not face the stairs";
  }
  return std::nullopt;
}

double told_variance(const stetro_site::Covariance & covariance, int i)
{
  constexpr double kLeast = 0.01 * 0.01;
  constexpr double kNotGiven = 0.1 * 0.1;
  const double given = covariance(i, i);
  return std::isfinite(given) ? std::max(given, kLeast) : kNotGiven;
}

std::unique_ptr<Estimator> make_estimator(
  const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
  const stetro_site::Flight & flight)
{
  if (params.estimator == "paper") {
    return std::make_unique<PaperEstimator>(params, robot, flight);
  }
  if (params.estimator == "fused") {
    return std::make_unique<FusedEstimator>(params, robot, flight);
  }
  throw std::invalid_argument(
    "estimator: '" + params.estimator + "' refused, accepted: fused, paper");
}

}  // namespace stetro_localizer
