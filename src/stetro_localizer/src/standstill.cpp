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

#include "stetro_localizer/standstill.hpp"

#include <cmath>

namespace stetro_localizer
{

void Standstill::note(const OdometrySample & sample)
{
  const bool still = std::hypot(sample.vx_mps, sample.vy_mps) < params_.speed_mps &&
                     std::abs(sample.wz_radps) < params_.rate_radps;
  if (!still) {
    first_still_ = Nanoseconds{0};
  } else if (first_still_ == Nanoseconds{0}) {
    first_still_ = sample.stamp;
  }
  last_ = sample.stamp;
}

bool Standstill::standing() const
{
  return first_still_ != Nanoseconds{0} && seconds(last_ - first_still_) >= params_.settle_s;
}

}  // namespace stetro_localizer
