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

#ifndef SUPPORT__JACOBIAN_HPP_
#define SUPPORT__JACOBIAN_HPP_

#include <gtest/gtest.h>

#include <random>

#include "stetro_localizer/fused/expectation.hpp"

namespace stetro_localizer
{

/// A state as it may be on a tread: every number away from zero, so that no term hides.
inline StateVector some_state(unsigned seed)
{
  std::mt19937 random(seed);
  const auto within = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  StateVector state;
  state[kStateX] = within(-0.3, -0.05);
  state[kStateY] = within(0.2, 1.8);
  state[kStateYaw] = within(-0.15, 0.15);
  state[kStateVx] = within(-0.1, 0.1);
  state[kStateVy] = within(-0.2, 0.2);
  state[kStateGyroBias] = within(-0.01, 0.01);
  state[kStateOdomScale] = within(-0.05, 0.05);
  state[kStateWidth] = within(2.0, 2.1);
  state[kStateTreadHere] = within(0.3, 0.34);
  state[kStateTreadAhead] = within(0.3, 0.34);
  state[kStateRiserAhead] = within(-0.02, 0.02);
  state[kStateRiserNext] = within(-0.02, 0.02);
  for (int i = kStateFirstCalibration; i < kStateCount; i += 2) {
    state[i] = within(-0.02, 0.02);
    state[i + 1] = within(-0.05, 0.05);
  }
  return state;
}

/// Holds a model's Jacobian against central differences at twenty states.
template <class Model>
void expect_jacobian_holds(const Model & model)
{
  constexpr double kStep = 1e-6;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const StateVector state = some_state(seed);
    StateVector slopes = StateVector::Zero();
    for (const auto & entry : model(state)) {
      EXPECT_EQ(slopes[entry.index], 0.0) << "index " << entry.index << " is given twice";
      slopes[entry.index] = entry.slope;
    }
    for (int i = 0; i < kStateCount; ++i) {
      StateVector more = state;
      StateVector less = state;
      more[i] += kStep;
      less[i] -= kStep;
      const double difference = (model(more).value() - model(less).value()) / (2.0 * kStep);
      EXPECT_NEAR(slopes[i], difference, 1e-7) << "state " << i << ", seed " << seed;
    }
  }
}

}  // namespace stetro_localizer

#endif  // SUPPORT__JACOBIAN_HPP_
