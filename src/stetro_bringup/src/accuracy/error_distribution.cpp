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

#include "accuracy/error_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace stetro_bringup
{
namespace
{

constexpr double kSmallest = 1e-9;
constexpr double kLargest = 1e3;  // and all that is larger falls into the last class
const double kWidth = std::log(1.001);

std::size_t class_of(double size)
{
  const double bounded = std::clamp(size, kSmallest, kLargest);
  return static_cast<std::size_t>(std::ceil(std::log(bounded / kSmallest) / kWidth));
}

}  // namespace

ErrorDistribution::ErrorDistribution() : classes_(class_of(kLargest) + 1, 0) {}

void ErrorDistribution::add(double error)
{
  statistics_.add(error);
  ++classes_[class_of(std::abs(error))];
}

double ErrorDistribution::percentile(double share) const
{
  if (!(share > 0.0 && share <= 1.0)) {
    throw std::invalid_argument(
      "share is " + std::to_string(share) + ", accepted: above 0 and up to 1");
  }
  if (count() == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double total = static_cast<double>(count());
  const auto rank = static_cast<std::uint64_t>(std::ceil(share * total * (1.0 - 1e-12)));
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    passed += classes_[i];
    if (passed >= rank) {
      return std::min(kSmallest * std::exp(kWidth * static_cast<double>(i)), max());
    }
  }
  return max();
}

}  // namespace stetro_bringup
