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
#include "stetro_supervisor/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_supervisor
{
namespace
{

/// What is left to travel in the way of travel [m].
double to_go_m(const Situation & s, int direction)
{
  if (s.state == State::kSweepToMiddle) {
    return s.pose_usable() ? std::abs(s.geometry.middle_y_m(s.step()) - s.seen.pose->y_m) : 0.0;
  }
  const double by_pose = wall_gap_m(s, direction);
  const auto by_range = s.gap_m(direction > 0 ? Place::kSideLeft : Place::kSideRight);
  return by_range ? std::min(by_pose, *by_range) : by_pose;
}

}  // namespace

State state_of(Leg leg, const ClimbParams & params)
{
  const bool left_first = params.sweep_order == "left_first";
  switch (leg) {
    case Leg::kFirst:
      return left_first ? State::kSweepLeft : State::kSweepRight;
    case Leg::kSecond:
      return left_first ? State::kSweepRight : State::kSweepLeft;
    case Leg::kMiddle:
      return State::kSweepToMiddle;
    default:
      return State::kSquare;
  }
}

int sweep_direction(const Situation & s)
{
  if (s.state == State::kSweepToMiddle) {
    return s.pose_usable() && s.seen.pose->y_m > s.geometry.middle_y_m(s.step()) ? -1 : +1;
  }
  return s.state == State::kSweepLeft ? +1 : -1;
}

double wall_gap_m(const Situation & s, int side)
{
  if (!s.pose_usable()) {
    return 0.0;
  }
  const double y = s.seen.pose->y_m;
  return (side > 0 ? s.geometry.width_at_m(s.step()) - y : y) - s.geometry.contact_width_m / 2.0;
}

MotionCommand sweep_command(const Situation & s)
{
  const ClimbParams & p = s.params;
  const int direction = sweep_direction(s);
  const double psi = s.heading_rad();
  const double wz = s.memory.heading.rate_rps(p, psi, direction, s.memory.offset.value_m());
  if (std::abs(psi) > p.alignment_limit_rad) {
    return traverse(0.0, wz);
  }
  const double share =
    p.slow_zone_m > 0.0 ? std::clamp(to_go_m(s, direction) / p.slow_zone_m, 0.0, 1.0) : 1.0;
  const double speed = p.creep_speed_mps + share * (p.sweep_speed_mps - p.creep_speed_mps);
  return traverse(direction * speed, wz);
}

}  // namespace stetro_supervisor
