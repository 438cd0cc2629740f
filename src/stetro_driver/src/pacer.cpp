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

#include "stetro_driver/pacer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stetro_driver
{
namespace
{

constexpr double kSlowest = 0.1;
constexpr double kFastest = 1000.0;
constexpr int kCaughtUp = 4;  // ticks

Time period(Time tick, double speed)
{
  return Time{static_cast<Time::rep>(static_cast<double>(tick.count()) / speed)};
}

}  // namespace

Pacer::Pacer(const PacerLimits & limits, Time tick) : limits_(limits), tick_(tick)
{
  if (!(limits.speed >= kSlowest && limits.speed <= kFastest)) {
    throw std::invalid_argument(
      "speed is " + std::to_string(limits.speed) + ", accepted: 0.1 to 1000");
  }
}

void Pacer::hear(Peer peer, Time stamp, Time now)
{
  Watch & watch = watches_[static_cast<std::size_t>(peer)];
  if (stamp <= now) {
    watch.newest = std::max(watch.newest, stamp);
  }
  if (now - watch.newest > limits_.lag_limit) {
    return;  // far behind: it gets its chance when it catches up
  }
  watch.heard = true;
  watch.lost = false;
  watch.awaited = false;
}

Time Pacer::wait(Time now, Time steady)
{
  Time left{0};
  bool lost = false;
  for (Watch & watch : watches_) {
    left = std::max(left, patience_left(watch, now, steady));
    lost = lost || watch.lost;
  }
  if (left > Time::zero()) {
    return left;
  }
  // Somebody is missing: as fast as the speed allows, but no faster than the world outside.
  const Time due = lost ? std::max(due_, last_tick_ + tick_) : due_;
  return std::max(Time::zero(), due - steady);
}

Time Pacer::patience_left(Watch & watch, Time now, Time steady)
{
  const bool behind = watch.heard && !watch.lost && now - watch.newest > limits_.lag_limit;
  if (!limits_.throttle || !behind) {
    watch.awaited = false;
    return Time::zero();
  }
  if (!watch.awaited) {
    watch.awaited = true;
    watch.awaited_since = steady;
    ++waits_;
  }
  const Time left = watch.awaited_since + limits_.patience - steady;
  if (left > Time::zero()) {
    return left;
  }
  watch.lost = true;
  watch.awaited = false;
  ++losses_;
  return Time::zero();
}

void Pacer::ticked(Time steady)
{
  last_tick_ = steady;
  // A short sleep that lasted too long is caught up, a wait is not: a burst would outrun the peers.
  const Time tick = period(tick_, limits_.speed);
  due_ = std::max(due_ + tick, steady - kCaughtUp * tick);
}

}  // namespace stetro_driver
