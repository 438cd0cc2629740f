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
#include "stetro_supervisor/heading_correction.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_supervisor/climb_params.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurnGain_per_s = 1.5;
constexpr double kLeastTurnShare = 0.2;       // of the yaw rate, so that wheels do not stall
constexpr double kLeanTolerance_rad = 0.005;  // 0.3 deg, about the noise of the heading
constexpr double kLeanEnd = 0.3;              // of the drift window

}  // namespace

double HeadingCorrection::turn_rate_rps(const ClimbParams & p, double error_rad)
{
  const double least = kLeastTurnShare * p.yaw_rate_rps;
  const double size = std::clamp(kTurnGain_per_s * std::abs(error_rad), least, p.yaw_rate_rps);
  return -std::copysign(size, error_rad);
}

void HeadingCorrection::update(
  const ClimbParams & p, double heading_rad, int direction, double offset_m)
{
  const double size = std::abs(heading_rad);
  correcting_ = correcting_ ? size > p.dead_band_rad - p.hysteresis_rad : size > p.dead_band_rad;
  leaning_ = direction != 0 && p.drift_heading_rad > 0.0 &&
             std::abs(offset_m) > p.drift_window_m * (leaning_ ? kLeanEnd : 1.0);
}

double HeadingCorrection::rate_rps(
  const ClimbParams & p, double heading_rad, int direction, double offset_m) const
{
  if (correcting_) {
    return -std::copysign(p.yaw_rate_rps, heading_rad);
  }
  if (!leaning_) {
    return 0.0;
  }
  const double lean_rad = direction * std::copysign(p.drift_heading_rad, offset_m);
  const double error_rad = heading_rad - lean_rad;
  return std::abs(error_rad) > kLeanTolerance_rad ? turn_rate_rps(p, error_rad) : 0.0;
}

}  // namespace stetro_supervisor
