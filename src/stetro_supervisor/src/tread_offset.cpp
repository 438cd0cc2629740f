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
#include "stetro_supervisor/tread_offset.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{
namespace
{

constexpr int kReferenceReadings = 10;
constexpr double kBlend_s = 0.5;  // time constant: 15 readings at 30 Hz
constexpr double kGate_m = 0.05;  // a jump that no drift explains is another surface

}  // namespace

void TreadOffset::zero() { *this = TreadOffset{}; }

void TreadOffset::see(double front_m, double dt_s)
{
  if (!reference_m_) {
    sum_m_ += front_m + offset_m_;
    ++count_;
    if (count_ == kReferenceReadings) {
      reference_m_ = sum_m_ / count_;
    }
    return;
  }
  const double innovation_m = (*reference_m_ - front_m) - offset_m_;
  if (std::abs(innovation_m) < kGate_m) {
    offset_m_ += std::min(dt_s / kBlend_s, 1.0) * innovation_m;
  }
}

}  // namespace stetro_supervisor
