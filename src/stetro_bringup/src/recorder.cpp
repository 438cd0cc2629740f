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
#include "stetro_bringup/recorder.hpp"

#include <cmath>
#include <utility>

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

constexpr std::chrono::nanoseconds kPatience = 200ms;
/// Truth comes each 10 ms: what is further away belongs to another estimate.
constexpr std::chrono::nanoseconds kSameTime = 6ms;
constexpr double kSameHeightM = 0.02;

/// The entry nearest to `stamp` if it is of the same time, else end().
template <class Value>
typename std::map<std::chrono::nanoseconds, Value>::const_iterator nearest(
  const std::map<std::chrono::nanoseconds, Value> & entries, std::chrono::nanoseconds stamp)
{
  auto best = entries.lower_bound(stamp);
  if (best != entries.begin()) {
    const auto before = std::prev(best);
    if (best == entries.end() || stamp - before->first < best->first - stamp) {
      best = before;
    }
  }
  if (best == entries.end() || std::chrono::abs(best->first - stamp) > kSameTime) {
    return entries.end();
  }
  return best;
}

// While the robot sweeps, blocks 2 and 3 stand on one tread.
bool stands(const Estimate & estimate)
{
  return std::abs(estimate.block_heights_m[1] - estimate.block_heights_m[2]) < kSameHeightM;
}

}  // namespace

Recorder::Recorder(Sink sink) : sink_(std::move(sink)) {}

void Recorder::add_estimate(const Estimate & estimate)
{
  waiting_[estimate.sample.stamp] = estimate;
  release(estimate.sample.stamp - kPatience);
}

void Recorder::add_truth(const StairSample & truth) { truths_[truth.stamp] = truth; }

void Recorder::add_range(Time stamp, const std::string & sensor, double range_m)
{
  sensors_[stamp][sensor].range_m = range_m;
}

void Recorder::add_outcome(Time stamp, const std::string & sensor, const std::string & outcome)
{
  sensors_[stamp][sensor].outcome = outcome;
}

void Recorder::flush() { release(Time::max()); }

void Recorder::release(Time until)
{
  while (!waiting_.empty() && waiting_.begin()->first <= until) {
    const Estimate & estimate = waiting_.begin()->second;
    sink_(joined(estimate), stands(estimate));
    forget(estimate.sample.stamp - kPatience);
    waiting_.erase(waiting_.begin());
  }
}

TraceRow Recorder::joined(const Estimate & estimate) const
{
  TraceRow row;
  row.estimate = estimate.sample;
  row.sigma = estimate.sigma;
  row.integrity = estimate.integrity;
  row.reasons = estimate.reasons;
  if (const auto truth = nearest(truths_, estimate.sample.stamp); truth != truths_.end()) {
    row.truth = truth->second;
  }
  if (const auto sensors = nearest(sensors_, estimate.sample.stamp); sensors != sensors_.end()) {
    row.sensors = sensors->second;
  }
  return row;
}

void Recorder::forget(Time before)
{
  truths_.erase(truths_.begin(), truths_.lower_bound(before));
  sensors_.erase(sensors_.begin(), sensors_.lower_bound(before));
}

}  // namespace stetro_bringup
