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

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace stetro_dds
{

namespace
{

constexpr Time kLongestStep = std::chrono::seconds{10};
constexpr int kAgreement = 10;  // settings in a row that make a jump believed

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
  return source_ == TimeSource::kSystem
           ? system_.advance(std::chrono::system_clock::now().time_since_epoch(), steady_now())
           : simulated_;
}

std::optional<Refusal> Clock::set(Time now)
{
  if (source_ == TimeSource::kSystem) {
    return Refusal{"the clock follows the system", ""};
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now <= Time{0}) {
    ++simulated_faults_.zero;
    return Refusal{"time zero", in_seconds(now) + ", accepted is more than 0"};
  }
  if (now < simulated_) {
    ++simulated_faults_.backwards;
    return Refusal{
      "time runs backwards", in_seconds(now) + ", accepted is at least " + in_seconds(simulated_)};
  }
  if (is_stray_jump(now)) {
    ++simulated_faults_.forwards;
    return Refusal{
      "time jumps", in_seconds(now) + ", accepted is at most " +
                      in_seconds(simulated_ + kLongestStep) + " or several that agree"};
  }
  simulated_ = now;
  return std::nullopt;
}

bool Clock::is_stray_jump(Time now)
{
  if (simulated_ == Time{0} || now - simulated_ <= kLongestStep) {
    agreeing_ = 0;
    return false;
  }
  const bool agrees = agreeing_ > 0 && now >= jumped_to_ && now - jumped_to_ <= kLongestStep;
  agreeing_ = agrees ? agreeing_ + 1 : 1;
  jumped_to_ = now;
  if (agreeing_ < kAgreement) {
    return true;
  }
  agreeing_ = 0;
  return false;
}

ClockFaults Clock::faults() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return source_ == TimeSource::kSystem ? system_.faults() : simulated_faults_;
}

}  // namespace stetro_dds
