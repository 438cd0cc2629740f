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

#include "stetro_supervisor/robot_health.hpp"

#include <algorithm>

namespace stetro_supervisor
{
namespace
{

bool unusable(const Contact & contact)
{
  return contact.fault || contact.state == ContactState::kUnknown;
}

}  // namespace

bool is_driver_silent(const Observation & seen, Time now, double limit_s)
{
  const bool ranges_silent = std::all_of(
    seen.ranges.begin(), seen.ranges.end(),
    [&](const std::optional<Range> & range) { return older_than(range, now, limit_s); });
  return ranges_silent || older_than(seen.contacts, now, limit_s) ||
         older_than(seen.blocks, now, limit_s) || older_than(seen.odometry, now, limit_s);
}

bool is_emergency_stop_closed(const Observation & seen)
{
  return seen.contacts && seen.contacts->emergency_stop.state == ContactState::kClosed;
}

bool is_block_broken(const Observation & seen)
{
  return seen.blocks && std::any_of(
                          seen.blocks->block.begin(), seen.blocks->block.end(),
                          [](const Block & block) { return block.fault; });
}

bool is_switch_broken(const Observation & seen)
{
  if (!seen.contacts) {
    return false;
  }
  const Contacts & c = *seen.contacts;
  return std::any_of(c.left.begin(), c.left.end(), unusable) ||
         std::any_of(c.right.begin(), c.right.end(), unusable) || unusable(c.riser_left) ||
         unusable(c.riser_right) || unusable(c.emergency_stop);
}

bool is_level(const Observation & seen, double tolerance_m)
{
  return seen.blocks &&
         std::all_of(
           seen.blocks->block.begin(), seen.blocks->block.end(),
           [&](const Block & block) { return !block.moving && block.height_m <= tolerance_m; });
}

}  // namespace stetro_supervisor
