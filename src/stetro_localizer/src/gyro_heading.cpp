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

#include "stetro_localizer/gyro_heading.hpp"

#include <cmath>

namespace stetro_localizer
{

GyroHeading::GyroHeading(const GyroParams & params)
: params_(params), bias_{0.0, params.bias_sigma_radps * params.bias_sigma_radps}
{
}

bool GyroHeading::add(const GyroSample & sample, bool standing)
{
  const bool first = last_ == Nanoseconds{0};
  const double dt_s = first ? 0.0 : seconds(sample.stamp - last_);
  last_ = sample.stamp;
  bias_.grow(params_.bias_walk * params_.bias_walk * dt_s);
  if (standing && std::abs(sample.rate_radps) < params_.still_limit_radps) {
    bias_.update(sample.rate_radps, params_.white_radps * params_.white_radps);
  }
  time_since_mark_s_ += dt_s;
  if (dt_s > params_.longest_gap_s) {
    const double turn_rad = params_.gap_rate_radps * dt_s;
    white_since_mark_ += turn_rad * turn_rad;
    return false;
  }
  angle_rad_ += (sample.rate_radps - bias_.value) * dt_s;
  const double noise_rad = params_.white_radps * dt_s;
  white_since_mark_ += noise_rad * noise_rad;
  return true;
}

void GyroHeading::mark()
{
  time_since_mark_s_ = 0.0;
  white_since_mark_ = 0.0;
}

double GyroHeading::variance_since_mark() const
{
  return white_since_mark_ + bias_.variance * time_since_mark_s_ * time_since_mark_s_;
}

}  // namespace stetro_localizer
