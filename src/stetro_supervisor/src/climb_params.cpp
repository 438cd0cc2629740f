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

#include "stetro_supervisor/climb_params.hpp"

#include <string>

#include "stetro_config/value.hpp"

namespace stetro_supervisor
{

void check(const ClimbParams & p, stetro_config::Faults & faults)
{
  const auto ordered =
    [&faults](const std::string & name, double value, double limit, const std::string & other) {
      if (!(value < limit)) {
        faults.refuse(
          name, stetro_config::to_text(value),
          "less than " + other + " (" + stetro_config::to_text(limit) + ")");
      }
    };
  ordered("heading.hysteresis_rad", p.hysteresis_rad, p.dead_band_rad, "heading.dead_band_rad");
  ordered(
    "heading.dead_band_rad", p.dead_band_rad, p.alignment_limit_rad, "heading.alignment_limit_rad");
  ordered("heading.square_rad", p.square_rad, p.dead_band_rad, "heading.dead_band_rad");
  ordered("drift.heading_rad", p.drift_heading_rad, p.dead_band_rad, "heading.dead_band_rad");
  ordered("drift.window_m", p.drift_window_m, p.trim_window_m, "drift.trim_window_m");
  ordered("roll.top_m", p.top_roll_m, p.max_roll_m, "roll.max_m");
  ordered("contact.block3_gap_m", p.block3_gap_m, p.stall_zone_m, "contact.stall_zone_m");
  ordered("ahead.front_free_s", p.front_free_s, p.top_limit_s, "limit.top_s");
  ordered("silence.pose_settle_s", p.pose_settle_s, p.pose_limit_s, "limit.pose_s");
}

}  // namespace stetro_supervisor
