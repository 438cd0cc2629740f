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

#include "stetro_localizer/fused/tread_gauge.hpp"

#include <cmath>

namespace stetro_localizer
{
namespace
{

constexpr double kMostTravel = 0.005;  // the wheels, and slips, are trusted for so long [m]
constexpr int kEnough = 10;            // readings
constexpr double kTouch = 0.002;  // of x after a touch: switch, wheels, a riser not quite true [m]

}  // namespace

void TreadGauge::touch(double x_m, double travel_m)
{
  if (count_ >= kEnough) {
    return;
  }
  *this = TreadGauge();
  touched_ = true;
  touched_x_m_ = x_m;
  touched_travel_m_ = travel_m;
}

std::optional<double> TreadGauge::x_m(double travel_m) const
{
  const double way_m = travel_m - touched_travel_m_;
  return touched_ && std::abs(way_m) < kMostTravel ? std::optional<double>(touched_x_m_ + way_m)
                                                   : std::nullopt;
}

void TreadGauge::add(double depth_m, double noise_variance)
{
  ++count_;
  sum_m_ += depth_m;
  noise_sum_ += noise_variance;
}

std::optional<ScalarEstimate> TreadGauge::depth_m(double calibration_variance) const
{
  if (count_ < kEnough) {
    return std::nullopt;
  }
  const double noise = noise_sum_ / count_ / count_;
  return ScalarEstimate{sum_m_ / count_, calibration_variance + noise + kTouch * kTouch};
}

}  // namespace stetro_localizer
