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
#include "stetro_bringup/error_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stetro_bringup
{

void ErrorStatistics::add(double error)
{
  if (!std::isfinite(error)) {
    throw std::invalid_argument("error: a finite number is wanted");
  }
  ++count_;
  const double step = error - mean_;
  mean_ += step / static_cast<double>(count_);
  squares_ += step * (error - mean_);
  max_abs_ = std::max(max_abs_, std::abs(error));
}

double ErrorStatistics::mean() const
{
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : mean_;
}

double ErrorStatistics::standard_deviation() const
{
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN()
                     : std::sqrt(squares_ / static_cast<double>(count_));
}

double ErrorStatistics::rms() const { return std::hypot(mean(), standard_deviation()); }

double ErrorStatistics::max_abs() const
{
  return count_ == 0 ? std::numeric_limits<double>::quiet_NaN() : max_abs_;
}

}  // namespace stetro_bringup
