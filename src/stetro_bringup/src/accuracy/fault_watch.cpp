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

#include "accuracy/fault_watch.hpp"

#include <cmath>

namespace stetro_bringup
{
namespace
{

using stetro_driver::GroundTruth;
using stetro_localizer::Integrity;

// A tenth of what the slowest motion, 2 cm/s and 0.1 rad/s, makes of a tick.
constexpr double kMoved_m = 2e-5;
constexpr double kTurned_rad = 1e-4;

constexpr double kReach_m = 1.2;  // of a ToF sensor: farther away it is not expected to see

// By division: a hundred ticks are one second exactly.
double seconds(std::uint64_t ticks) { return static_cast<double>(ticks) / 100.0; }

struct Motion
{
  bool along;
  bool across;
  bool turning;

  [[nodiscard]] bool any() const { return along || across || turning; }
};

Motion motion_between(const GroundTruth & before, const GroundTruth & now)
{
  return {
    std::abs(now.x_m - before.x_m) > kMoved_m, std::abs(now.y_m - before.y_m) > kMoved_m,
    std::abs(now.yaw_rad - before.yaw_rad) > kTurned_rad};
}

bool tells(TellingMotion telling, const Motion & motion, const GroundTruth & now)
{
  switch (telling) {
    case TellingMotion::kNearLeftWall:
      return motion.across && now.tread_width_m - now.y_m < kReach_m;
    case TellingMotion::kNearRightWall:
      return motion.across && now.y_m < kReach_m;
    case TellingMotion::kAlong:
      return motion.along || motion.turning;
    case TellingMotion::kTurning:
      return motion.turning;
    case TellingMotion::kAny:
      break;
  }
  return motion.any();
}

}  // namespace

void FaultWatch::watch(const Moment & now)
{
  const bool ok = now.estimate.integrity == Integrity::kOk;
  if (now.accepted && now.elapsed_s >= onset_.at_s && !detection_.detected) {
    detection_.never_ok = !was_ok_ && !ok && (detection_.never_ok || !detection_.struck);
    detection_.struck = true;
    detection_.detected = was_ok_ && !ok;
    if (ok) {
      count(now);
    }
  }
  was_ok_ = ok;
  last_truth_ = now.truth;
}

void FaultWatch::count(const Moment & now)
{
  const Motion motion = motion_between(last_truth_.value_or(now.truth), now.truth);
  detection_.time_s = seconds(++ticks_);
  detection_.motion_s = seconds(moving_ticks_ += motion.any() ? 1 : 0);
  detection_.telling_motion_s =
    seconds(telling_ticks_ += tells(onset_.telling, motion, now.truth) ? 1 : 0);
}

}  // namespace stetro_bringup
