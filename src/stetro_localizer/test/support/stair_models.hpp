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

#ifndef SUPPORT__STAIR_MODELS_HPP_
#define SUPPORT__STAIR_MODELS_HPP_

#include <utility>
#include <vector>

#include "stetro_localizer/step_model.hpp"

namespace stetro_localizer
{

constexpr double kRiser = 0.14;
constexpr double kTread = 0.32;
constexpr int kSteps = 16;

inline stetro_site::Flight flight_of(std::vector<stetro_site::Step> steps)
{
  stetro_site::FlightSpec spec;
  spec.id = "flight";
  spec.steps = std::move(steps);
  spec.width_foot_m = spec.width_top_m = 2.05;
  return stetro_site::Flight(spec);
}

inline StepModel model_of(std::vector<stetro_site::Step> steps)
{
  return {flight_of(std::move(steps)), stetro_site::RobotGeometry{}, StepFilterParams{}};
}

inline const StepModel & papers()
{
  static const StepModel kModel = model_of(stetro_site::equal_steps(kSteps, kRiser, kTread));
  return kModel;
}

}  // namespace stetro_localizer

#endif  // SUPPORT__STAIR_MODELS_HPP_
