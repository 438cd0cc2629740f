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

#ifndef SUPPORT__BIAS_NAMED_HPP_
#define SUPPORT__BIAS_NAMED_HPP_

#include <gtest/gtest.h>

#include <string>

#include "stetro_localizer/estimator.hpp"

namespace stetro_localizer
{

/// What an estimator has learnt under that name; fails without one.
inline ScalarEstimate bias_named(const Estimator & estimator, const std::string & name)
{
  for (const Bias & bias : estimator.biases()) {
    if (bias.name == name) {
      return bias.estimate;
    }
  }
  ADD_FAILURE() << "nothing is learnt under the name " << name;
  return {};
}

}  // namespace stetro_localizer

#endif  // SUPPORT__BIAS_NAMED_HPP_
