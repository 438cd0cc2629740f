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

#include "stetro_dds/clock.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace stetro_dds
{

namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr Time kUnnoticed = 1ms;          // a smaller step back is the clock being slewed
constexpr Time kForwardsStep = 1s;        // a larger one forwards is worth a word
constexpr std::int64_t kSlowness = 1000;  // an excess is lost at 1 in this many

std::string in_seconds(Time time)
{
  return std::to_string(std::chrono::duration<double>(time).count()) + " s";
}

}  // namespace

Clock::Clock(TimeSource source) : source_(source) {}

Time Clock::steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

Time Clock::now() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return source_ == TimeSource::kSystem ? system_now() : now_;
}

Time Clock::system_now() const
{
  const Time steady = steady_now();
  const Time wall = std::chrono::system_clock::now().time_since_epoch();
  if (now_ == Time{0}) {
    now_ = wall;
    steady_at_now_ = steady;
    return now_;
  }
  const Time elapsed = steady - steady_at_now_;
  const Time slowest = now_ + elapsed - elapsed / kSlowness;
  const Time behind = std::max(slowest - wall, Time{0});
  if (behind > faults_.behind + kUnnoticed) {
    ++faults_.backwards;
  }
  if (wall > now_ + elapsed + kForwardsStep) {
    ++faults_.forwards;
  }
  faults_.behind = behind;
  now_ = std::max(wall, slowest);
  steady_at_now_ = steady;
  return now_;
}

std::optional<Refusal> Clock::set(Time now)
{
  if (source_ == TimeSource::kSystem) {
    return Refusal{"the clock follows the system", ""};
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now <= Time{0}) {
    ++faults_.zero;
    return Refusal{"time zero", in_seconds(now) + ", accepted is more than 0"};
  }
  if (now < now_) {
    ++faults_.backwards;
    return Refusal{
      "time runs backwards", in_seconds(now) + ", accepted is at least " + in_seconds(now_)};
  }
  now_ = now;
  return std::nullopt;
}

ClockFaults Clock::faults() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return faults_;
}

}  // namespace stetro_dds
