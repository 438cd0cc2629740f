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

#include "stetro_localizer/floor/correction_gate.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{

const char * to_string(CorrectionOutcome outcome)
{
  switch (outcome) {
    case CorrectionOutcome::kNone:
      return "none";
    case CorrectionOutcome::kFused:
      return "fused";
    case CorrectionOutcome::kReset:
      return "reset";
    case CorrectionOutcome::kAwaited:
      return "awaits_another";
    case CorrectionOutcome::kGated:
      return "gated";
    case CorrectionOutcome::kGatedLost:
      return "gated_pose_lost";
    case CorrectionOutcome::kNotOnFloor:
      return "not_on_a_floor";
    case CorrectionOutcome::kOtherFloor:
      return "other_floor";
    case CorrectionOutcome::kStaleCounter:
      return "stale_reset_counter";
    case CorrectionOutcome::kTooOld:
      return "too_old";
    case CorrectionOutcome::kOutOfOrder:
      return "out_of_order";
    case CorrectionOutcome::kFuture:
      return "future";
    case CorrectionOutcome::kUnfit:
      return "unfit";
  }
  return "unknown";
}

CorrectionOutcome CorrectionGate::judge(FloorFilter & filter, const PoseFix & fix, int floor)
{
  if (trust_ != Trust::kKnown) {
    return find(filter, fix, floor);
  }
  const bool here = floor == floor_;
  if (here && filter.innovation(fix).nis() <= limits_.nis) {
    filter.correct(fix);
    trust(floor);
    return CorrectionOutcome::kFused;
  }
  ++refused_;
  if (agrees(fix, floor)) {
    rival_.correct(fix);
    ++agreeing_;
  } else {
    keep(filter, fix, floor);
  }
  if (agreeing_ < limits_.lost_streak) {
    return here ? CorrectionOutcome::kGated : CorrectionOutcome::kOtherFloor;
  }
  distrust(Trust::kLost, floor_);
  return CorrectionOutcome::kGatedLost;
}

CorrectionOutcome CorrectionGate::find(FloorFilter & filter, const PoseFix & fix, int floor)
{
  if (!agrees(fix, floor)) {
    keep(filter, fix, floor);
    return CorrectionOutcome::kAwaited;
  }
  rival_.correct(fix);
  ++agreeing_;
  if (!rival_is_sure()) {
    return CorrectionOutcome::kAwaited;
  }
  filter = rival_;
  trust(floor);
  return CorrectionOutcome::kReset;
}

bool CorrectionGate::agrees(const PoseFix & fix, int floor) const
{
  return has_rival_ && rival_floor_ == floor && rival_.innovation(fix).nis() <= limits_.nis;
}

// Corrections that know little agree with anything.
bool CorrectionGate::rival_is_sure() const
{
  const double position_m = std::sqrt(std::max(rival_.variance(kFloorX), rival_.variance(kFloorY)));
  return position_m <= limits_.reset_sigma_m &&
         std::sqrt(rival_.variance(kFloorYaw)) <= limits_.reset_sigma_rad;
}

void CorrectionGate::keep(const FloorFilter & filter, const PoseFix & fix, int floor)
{
  rival_ = filter;
  rival_.set_pose(fix);
  rival_floor_ = floor;
  has_rival_ = true;
  agreeing_ = 1;
}

void CorrectionGate::trust(int floor) { distrust(Trust::kKnown, floor); }

void CorrectionGate::distrust(Trust trust, int floor)
{
  trust_ = trust;
  floor_ = floor;
  refused_ = 0;
  agreeing_ = 0;
  has_rival_ = false;
}

}  // namespace stetro_localizer
