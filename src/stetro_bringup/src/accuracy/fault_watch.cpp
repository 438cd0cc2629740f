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

constexpr double kRaised_m = 0.05;    // a down sensor is then beyond its nearest distance
constexpr double kCleared_m = 0.13;   // block 2 is then above what block3_front sees
constexpr double kTouches_m = 0.135;  // from the wall: 2 cm before the bumpers
constexpr double kAtRiser_m = 0.095;  // from the riser: 2 cm before the switches

constexpr double kReach_m = 1.2;  // of a ToF sensor: farther away it is not expected to see

// By division: a hundred ticks are one second exactly.
double seconds(std::uint64_t ticks) { return static_cast<double>(ticks) / 100.0; }

struct Motion
{
  bool along;
  bool across;
  bool turning;
  double block1_rose_m;  ///< so far, if it is rising
  double block2_rose_m;

  [[nodiscard]] bool any() const { return along || across || turning; }
};

Motion motion_between(
  const GroundTruth & before, const GroundTruth & now,
  const std::array<double, stetro_driver::kBlocks> & rose_from_m)
{
  const auto rose_m = [&](std::size_t block) {
    const bool rises = now.block_heights_m[block] - before.block_heights_m[block] > kMoved_m;
    return rises ? now.block_heights_m[block] - rose_from_m[block] : 0.0;
  };
  return {
    std::abs(now.x_m - before.x_m) > kMoved_m, std::abs(now.y_m - before.y_m) > kMoved_m,
    std::abs(now.yaw_rad - before.yaw_rad) > kTurned_rad, rose_m(0), rose_m(1)};
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
    case TellingMotion::kBlock1Rises:
      return motion.block1_rose_m > kRaised_m;
    case TellingMotion::kBlock2Rises:
      return motion.block2_rose_m > kRaised_m;
    case TellingMotion::kBlock2Clears:
      return motion.block2_rose_m > kCleared_m;
    case TellingMotion::kAtLeftWall:
      return motion.across && now.tread_width_m - now.y_m < kTouches_m;
    case TellingMotion::kAtRightWall:
      return motion.across && now.y_m < kTouches_m;
    case TellingMotion::kAtRiser:
      return motion.along && now.riser_ahead_m < kAtRiser_m;
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
  note_rise(now.truth);
  was_ok_ = ok;
  last_truth_ = now.truth;
}

void FaultWatch::count(const Moment & now)
{
  const Motion motion = motion_between(last_truth_.value_or(now.truth), now.truth, rose_from_m_);
  detection_.time_s = seconds(++ticks_);
  detection_.motion_s = seconds(moving_ticks_ += motion.any() ? 1 : 0);
  detection_.telling_motion_s =
    seconds(telling_ticks_ += tells(onset_.telling, motion, now.truth) ? 1 : 0);
}

void FaultWatch::note_rise(const GroundTruth & now)
{
  for (std::size_t i = 0; i < rose_from_m_.size(); ++i) {
    const double before_m = last_truth_ ? last_truth_->block_heights_m[i] : now.block_heights_m[i];
    const bool rises = now.block_heights_m[i] - before_m > kMoved_m;
    rose_from_m_[i] = rises ? rose_from_m_[i] : now.block_heights_m[i];
  }
}

}  // namespace stetro_bringup
