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

#include "accuracy/sigma_tally.hpp"

#include <cmath>
#include <limits>

namespace stetro_bringup
{
namespace
{

constexpr double kNormal95 = 1.959964;  // two-sided, standard deviations

}  // namespace

void SigmaTally::add(double error, double sigma)
{
  const double ratio = error / sigma;
  if (!std::isfinite(ratio)) {
    return;
  }
  ++count_;
  inside_ += std::abs(ratio) <= kNormal95 ? 1 : 0;
  squares_ += ratio * ratio;
}

double SigmaTally::inside_95() const
{
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                     : static_cast<double>(inside_) / static_cast<double>(count_);
}

double SigmaTally::mean_square() const
{
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                     : squares_ / static_cast<double>(count_);
}

}  // namespace stetro_bringup
