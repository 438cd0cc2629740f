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

#include "stetro_supervisor/floor/floor_params.hpp"

#include <string>

#include "stetro_config/value.hpp"

namespace stetro_supervisor
{

void check(const FloorParams & p, stetro_config::Faults & faults)
{
  const auto at_most =
    [&faults](const std::string & name, double value, double limit, const std::string & other) {
      if (!(value <= limit)) {
        faults.refuse(
          name, stetro_config::to_text(value),
          "at most " + other + " (" + stetro_config::to_text(limit) + ")");
      }
    };
  at_most("floor.creep_m_s", p.creep_m_s, p.speed_m_s, "floor.speed_m_s");
  at_most("floor.roll_off_m_s", p.roll_off_m_s, p.speed_m_s, "floor.speed_m_s");
  at_most("floor.aim_rad", p.aim_rad, p.heading_rad, "floor.heading_rad");
  at_most("floor.wait_s", p.wait_s, p.blocked_limit_s, "floor.limit.blocked_s");
  // What is driven round is kept off by the margin; what is left of it must cover the leg's error.
  at_most("floor.cross_track_m", p.cross_track_m, p.margin_m, "floor.margin_m");
}

}  // namespace stetro_supervisor
