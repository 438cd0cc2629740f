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

#include "stetro_dds/timer.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_dds
{

Timer::Timer(
  const Clock & clock, Counts counts, std::chrono::nanoseconds period,
  std::function<void(Time)> callback)
: clock_(clock), counts_(counts), period_(period), callback_(std::move(callback))
{
  if (period_ <= Time{0}) {
    throw std::invalid_argument(
      "timer period " + std::to_string(period_.count()) + " ns: accepted is more than 0");
  }
  if (!callback_) {
    throw std::invalid_argument("timer callback: accepted is something to call");
  }
  if (!simulated()) {
    due_ = Clock::steady_now() + period_;
  }
}

bool Timer::simulated() const
{
  return counts_ == Counts::kNodeTime && clock_.source() != TimeSource::kSystem;
}

bool Timer::fire_if_due()
{
  if (cancelled_) {
    return false;
  }
  const Time now = simulated() ? clock_.now() : Clock::steady_now();
  if (!due_) {
    if (now > Time{0}) {
      due_ = now + period_;
    }
    return false;
  }
  if (now < *due_) {
    return false;
  }
  const auto missed = (now - *due_) / period_;
  skipped_ += static_cast<std::uint64_t>(missed);
  *due_ += (missed + 1) * period_;
  ++fired_;
  callback_(clock_.now());
  return true;
}

std::optional<Time> Timer::next_steady() const
{
  return simulated() || cancelled_ ? std::nullopt : due_;
}

}  // namespace stetro_dds
