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

#include "accuracy/truth_ring.hpp"

#include <algorithm>

namespace stetro_bringup
{
namespace
{

using stetro_driver::GroundTruth;
using stetro_driver::Time;

GroundTruth between(const GroundTruth & before, const GroundTruth & after, Time time)
{
  const double share = static_cast<double>((time - before.time).count()) /
                       static_cast<double>((after.time - before.time).count());
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  GroundTruth truth = before;
  truth.time = time;
  truth.x_m = mix(before.x_m, after.x_m);
  truth.y_m = mix(before.y_m, after.y_m);
  truth.yaw_rad = mix(before.yaw_rad, after.yaw_rad);
  if (before.step == after.step) {
    truth.tread_x_m = mix(before.tread_x_m, after.tread_x_m);
    truth.riser_ahead_m = mix(before.riser_ahead_m, after.riser_ahead_m);
    truth.heading_rad = mix(before.heading_rad, after.heading_rad);
  }
  return truth;
}

}  // namespace

void TruthRing::add(const GroundTruth & truth)
{
  newest_ = (newest_ + 1) % kKept;
  ring_[newest_] = truth;
  count_ = std::min(count_ + 1, kKept);
}

std::optional<GroundTruth> TruthRing::at(Time time) const
{
  if (count_ == 0 || time > back(0).time) {
    return std::nullopt;
  }
  for (std::size_t age = 0; age < count_; ++age) {
    if (back(age).time == time) {
      return back(age);
    }
    if (back(age).time < time) {
      return between(back(age), back(age - 1), time);
    }
  }
  return std::nullopt;
}

}  // namespace stetro_bringup
