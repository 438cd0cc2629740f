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

#include "sim/sim_ranges.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace stetro_driver::sim
{
namespace
{

constexpr double kCycle = 1.0 / 30.0;  // [s]
constexpr double kTick = 0.01;         // [s]
constexpr std::uint64_t kLatencyTicks = 2;
constexpr Time kLatency = std::chrono::milliseconds{20};

}  // namespace

SimRanges::SimRanges(
  const BodyShape & shape, const SimErrors & errors, std::uint64_t seed, bool at_once)
: at_once_(at_once), minimum_m_(errors.tof_minimum_m), random_(seed, "range_faults")
{
  for (std::size_t place = 0; place < kRangePlaces; ++place) {
    sensors_.emplace_back(shape.tof[place], errors, seed, kRangeNames[place]);
  }
}

/// 30 Hz out of 100 Hz: every third or fourth tick.
bool SimRanges::cycle_ends(std::uint64_t tick) const
{
  return at_once_ || tick * 3 / 10 != (tick - 1) * 3 / 10;
}

void SimRanges::observe(
  const SimBody & body, std::uint64_t tick, Time now, const FaultInjector & faults)
{
  if (!cycle_ends(tick)) {
    return;
  }
  const std::size_t next = (newest_ + 1) % kRemembered;
  for (std::size_t place = 0; place < kRangePlaces; ++place) {
    const double cycle_s = at_once_ ? kTick : kCycle;
    history_[place][next] = corrupted(place, sensors_[place].measure(body, now, cycle_s), faults);
  }
  newest_ = next;
}

// What has a distance keeps one, unless it falls below what the sensor can measure.
RangeReading SimRanges::bent(
  RangeReading reading, std::string_view name, const FaultInjector & faults) const
{
  if (!std::isfinite(reading.range_m)) {
    return reading;
  }
  double range_m = reading.range_m;
  if (const SimFault * gain = faults.acting(SimFaultKind::kGainChange, name)) {
    range_m *= 1.0 + gain->value;
  }
  if (const SimFault * offset = faults.acting(SimFaultKind::kOffsetJump, name)) {
    range_m += offset->value;
  }
  if (const SimFault * drift = faults.acting(SimFaultKind::kDrift, name)) {
    range_m += drift->value * faults.acting_for_s(*drift);
  }
  if (range_m == reading.range_m) {
    return reading;
  }
  reading.range_m = std::round(range_m * 1000.0) / 1000.0;
  if (reading.range_m < minimum_m_) {
    reading.range_m = -std::numeric_limits<double>::infinity();
    reading.status = RangeStatus::kTooNear;
  }
  return reading;
}

RangeReading SimRanges::corrupted(
  std::size_t place, RangeReading reading, const FaultInjector & faults)
{
  const std::string_view name = kRangeNames[place];
  const RangeReading & last = history_[place][newest_];
  if (place == static_cast<std::size_t>(RangePlace::kBlock3Front) && feigned_m_ > 0.0) {
    reading.range_m = std::round((feigned_m_ + random_.normal(0.002)) * 1000.0) / 1000.0;
    reading.std_dev_m = 0.002;
    reading.status = RangeStatus::kValid;
  }
  reading = bent(reading, name, faults);
  if (faults.acting(SimFaultKind::kDead, name)) {
    RangeReading dead;
    dead.stamp = last.stamp;
    return dead;
  }
  if (faults.acting(SimFaultKind::kStuck, name) && last.stamp > Time::zero()) {
    const Time stamp = reading.stamp;
    reading = last;
    reading.stamp = stamp;
  }
  if (const SimFault * spike = faults.acting(SimFaultKind::kSpike, name)) {
    if (random_.uniform() < spike->value) {
      reading.range_m = std::round(random_.uniform(0.05, 1.2) * 1000.0) / 1000.0;
      reading.std_dev_m = std::hypot(0.0021, 0.015 * reading.range_m);
      reading.status = RangeStatus::kValid;
    }
  }
  return reading;
}

bool SimRanges::deliver(
  std::uint64_t tick, Time now, const FaultInjector & faults,
  std::array<RangeReading, kRangePlaces> & readings) const
{
  for (std::size_t place = 0; place < kRangePlaces; ++place) {
    const SimFault * late = faults.acting(SimFaultKind::kLate, kRangeNames[place]);
    const Time latency = at_once_ ? Time::zero() : kLatency;
    const Time delay = latency + (late ? seconds_to_time(late->value) : Time::zero());
    for (std::size_t age = 0; age < kRemembered; ++age) {
      const RangeReading & reading = history_[place][(newest_ + kRemembered - age) % kRemembered];
      if (reading.stamp > Time::zero() && reading.stamp + delay <= now) {
        readings[place] = reading;
        break;
      }
    }
  }
  return at_once_ || (tick > kLatencyTicks && cycle_ends(tick - kLatencyTicks));
}

void SimRanges::feign_block3_front(std::optional<double> range_m)
{
  feigned_m_ = range_m.value_or(0.0);
}

}  // namespace stetro_driver::sim
