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
#ifndef STETRO_SUPERVISOR__SWEEP_HPP_
#define STETRO_SUPERVISOR__SWEEP_HPP_

#include <optional>

#include "stetro_supervisor/motion_command.hpp"
#include "stetro_supervisor/situation.hpp"

namespace stetro_supervisor
{

/// The state that sweeps a leg: left, right, middle or right, left, middle (D1-15); kSquare when
/// the tread is done.
State state_of(Leg leg, const ClimbParams & params);

/// Way of travel in a sweeping state: +1 left, -1 right. To the middle by y (D3-12).
int sweep_direction(const Situation & situation);

/// Distance from the bumpers to the wall on a side, +1 left, -1 right, by the pose alone [m].
double wall_gap_m(const Situation & situation, int side);

/// Travel and heading correction of a sweeping state. Falls to creep within the slow zone of the
/// wall, as the pose or the side range says, whichever is nearer; only turns while the heading is
/// beyond the alignment limit.
MotionCommand sweep_command(const Situation & situation);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__SWEEP_HPP_
