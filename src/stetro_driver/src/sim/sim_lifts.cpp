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

#include "sim/sim_lifts.hpp"

#include <algorithm>

namespace stetro_driver::sim
{
namespace
{

// A doubled touch-down lets go half a second after the true one, and comes again 0.3 s later.
constexpr std::uint64_t kDoubleAfterTicks = 50;
constexpr std::uint64_t kDoubleForTicks = 30;

}  // namespace

SimLifts::SimLifts(const SimErrors & errors, std::uint64_t seed)
{
  RandomStream random{seed, "lifts"};
  for (std::size_t i = 0; i < kBlocks; ++i) {
    lock_error_m_[i] = random.uniform(-errors.lift_height_max_m, errors.lift_height_max_m);
    height_error_m_[i] = random.uniform(-errors.lift_height_max_m, errors.lift_height_max_m);
  }
}

void SimLifts::observe(const SimBody & body, std::uint64_t tick, FaultInjector & faults)
{
  for (int block = 1; block <= 3; ++block) {
    const auto i = static_cast<std::size_t>(block - 1);
    const bool stands = body.standing(block);
    const bool touched_down = stands && !stood_[i];
    if (touched_down && faults.strike(SimFaultKind::kMissedTouchdown)) {
      hidden_[i] = true;
    }
    if (touched_down && block == 2 && faults.strike(SimFaultKind::kDoubleTouchdown)) {
      doubled_from_tick_ = tick + kDoubleAfterTicks;
    }
    hidden_[i] = hidden_[i] && stands;
    stood_[i] = stands;
  }
}

bool SimLifts::shows_standing(const SimBody & body, int block, std::uint64_t tick) const
{
  const bool let_go = block == 2 && doubled_from_tick_ > 0 && tick >= doubled_from_tick_ &&
                      tick < doubled_from_tick_ + kDoubleForTicks;
  return body.standing(block) && !hidden_[static_cast<std::size_t>(block - 1)] && !let_go;
}

std::array<BlockReading, kBlocks> SimLifts::measure(
  const SimBody & body, const JointCommand & command, std::uint64_t tick,
  const std::array<bool, kBlocks> & moved) const
{
  std::array<double, kBlocks> seen_m{};
  for (int block = 1; block <= 3; ++block) {
    const auto i = static_cast<std::size_t>(block - 1);
    seen_m[i] = body.underside_m(block) + height_error_m_[i];
  }
  const double lowest_m = *std::min_element(seen_m.begin(), seen_m.end());
  std::array<BlockReading, kBlocks> readings{};
  for (int block = 1; block <= 3; ++block) {
    const auto i = static_cast<std::size_t>(block - 1);
    BlockReading & reading = readings[i];
    reading.height_m = seen_m[i] - lowest_m;
    reading.target_m = reading.height_m;
    if (command.block == block && command.kind == MotionKind::kLift) {
      reading.target_m = body.upper_lock_m(block) + height_error_m_[i] - lowest_m;
    } else if (command.block == block && command.kind == MotionKind::kLower) {
      reading.target_m = std::max(0.0, reading.height_m - body.shape().stroke_m);
    }
    reading.moving = moved[i];
    reading.at_lower_lock = shows_standing(body, block, tick);
    reading.at_upper_lock = body.at_upper_lock(block);
    reading.load = reading.at_lower_lock ? body.load(block) : 0.0;
    reading.fault = body.fall() != Fall::kNone;
  }
  return readings;
}

}  // namespace stetro_driver::sim
