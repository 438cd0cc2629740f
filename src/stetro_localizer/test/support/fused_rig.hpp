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

#ifndef SUPPORT__FUSED_RIG_HPP_
#define SUPPORT__FUSED_RIG_HPP_

#include <algorithm>

#include "stetro_localizer/fused_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{

inline LocalizerParams params_with(int initial_step)
{
  LocalizerParams params;
  params.estimator = "fused";
  params.initial_step = initial_step;
  return params;
}

/// Sensors as they leave the shelf: offsets of a centimetre, gains of a few percent.
inline SensorErrors uncalibrated()
{
  SensorErrors errors;
  errors.offset_m = {0.009, -0.007, 0.0, 0.012, -0.008, 0.0, 0.0, 0.0};
  errors.gain = {0.02, -0.01, 0.0, 0.025, -0.02, 0.0, 0.0, 0.0};
  errors.white_m = 0.0021;
  errors.white_per_m = 0.015;
  errors.gyro_bias_radps = 0.004;
  errors.gyro_white_radps = 0.0017;
  errors.wheel_scale = 0.02;
  return errors;
}

/// The estimator and a robot that has rested on its step for a second; -1: nobody told the step.
struct Rig
{
  explicit Rig(int step, const SensorErrors & errors = {})
  : estimator(params_with(step), stetro_site::RobotGeometry{}, papers_flight()),
    robot(estimator, errors)
  {
    estimator.begin(StateReading{});
    robot.stand_on(std::max(step, 0));
    robot.rest(1.0);
  }

  [[nodiscard]] const StairEstimate & estimate() const { return estimator.estimate(); }
  [[nodiscard]] double y_error_m() const { return estimate().pose.y_m - robot.y_m; }

  void sweep()
  {
    robot.sweep_left();
    robot.sweep_right();
  }

  FusedEstimator estimator;
  StairRobot robot;
};

}  // namespace stetro_localizer

#endif  // SUPPORT__FUSED_RIG_HPP_
