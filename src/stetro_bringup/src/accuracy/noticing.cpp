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

#include "accuracy/noticing.hpp"

#include <algorithm>
#include <cstddef>

namespace stetro_bringup
{
namespace
{

constexpr double kInTime_s = 1.0;

}  // namespace

FaultNoticing noticing_of(const std::vector<Detection> & detections)
{
  FaultNoticing all;
  for (const Detection & one : detections) {
    ++all.struck;
    if (!one.detected) {
      ++all.missed;
      continue;
    }
    all.in_time += one.motion_s <= kInTime_s ? 1 : 0;
    all.in_telling_time += one.telling_motion_s <= kInTime_s ? 1 : 0;
    all.latest_s = std::max(all.latest_s, one.time_s);
    all.latest_telling_s = std::max(all.latest_telling_s, one.telling_motion_s);
  }
  return all;
}

MiscountNoticing noticing_of(const std::vector<Miscount> & miscounts)
{
  MiscountNoticing all;
  for (const Miscount & one : miscounts) {
    ++all.began;
    all.corrected += one.end == MiscountEnd::kCorrected ? 1 : 0;
    all.unnoticed += one.end == MiscountEnd::kUnnoticed ? 1 : 0;
    if (one.end != MiscountEnd::kNoticed) {
      continue;
    }
    const auto climbs = static_cast<std::size_t>(one.climbs);
    all.by_climbs.resize(std::max(all.by_climbs.size(), climbs + 1), 0);
    ++all.by_climbs[climbs];
    all.before_next_climb += climbs == 0 ? 1 : 0;
    all.within_one_step += climbs <= 1 ? 1 : 0;
  }
  return all;
}

}  // namespace stetro_bringup
