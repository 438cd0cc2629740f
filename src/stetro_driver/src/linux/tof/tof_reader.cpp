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

#include "linux/tof/tof_reader.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::uint64_t kFailuresBeforeReopening = 3;
// A VL53L0X measures no faster (DS11555): who answers sooner is not asked at once again.
constexpr Time kShortestPeriod = std::chrono::milliseconds{8};

/// Milliseconds in words.
std::string milliseconds_text(Time time)
{
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count()) +
         " ms";
}

/// Turns a reading into one that says nothing but when the last measurement was.
void spoil(TofLatest & latest, IoFaultKind fault) noexcept
{
  latest.reading.range_m = std::numeric_limits<double>::quiet_NaN();
  latest.reading.std_dev_m = std::numeric_limits<double>::quiet_NaN();
  latest.reading.status = RangeStatus::kFault;
  latest.fault = fault;
}

}  // namespace

void TofStatistics::add(
  const RangeReading & reading, const TofMeasurement & measurement, std::uint32_t repeats)
{
  switch (reading.status) {
    case RangeStatus::kValid:
      ++valid;
      break;
    case RangeStatus::kWeak:
      ++weak;
      break;
    case RangeStatus::kTooNear:
      ++too_near;
      break;
    case RangeStatus::kNoTarget:
      ++no_target;
      break;
    case RangeStatus::kStale:
    case RangeStatus::kFault:
      ++slow;
      break;
  }
  longest_repeats = std::max(longest_repeats, repeats);
  longest = std::max(longest, measurement.took());
  total += measurement.took();
}

TofReader::TofReader(
  std::string place, Vl53l0xChannel channel, const TofLimits & limits, const TofTiming & timing,
  const DeviceClock & clock)
: place_(std::move(place)),
  channel_(std::move(channel)),
  limits_(limits),
  timing_(timing),
  clock_(clock),
  health_(place_, timing.back_off)
{
}

TofReader::~TofReader() { stop(); }

std::optional<IoFault> TofReader::open()
{
  auto fault = channel_.open();
  const std::lock_guard lock{mutex_};
  if (fault) {
    health_.failed(clock_.now(), *fault);
  } else {
    health_.opened();
  }
  return fault;
}

void TofReader::start()
{
  stopping_ = false;
  answered_ = false;
  last_mm_ = -1;
  thread_ = std::thread{[this] { run(); }};
}

void TofReader::request_stop() noexcept
{
  const std::lock_guard lock{mutex_};
  stopping_ = true;
  changed_.notify_all();
}

void TofReader::stop() noexcept
{
  request_stop();
  if (thread_.joinable()) {
    thread_.join();
  }
  channel_.close();
}

std::optional<IoFault> TofReader::wait_for_answer(Time patience)
{
  std::unique_lock lock{mutex_};
  if (changed_.wait_for(lock, patience, [this] { return answered_; })) {
    return std::nullopt;
  }
  return health_.faulty() ? health_.last_fault()
                          : IoFault{IoFaultKind::kSilent, place_ + ": does not answer"};
}

TofLatest TofReader::latest(Time now)
{
  TofLatest latest = box_.latest().value_or(TofLatest{});
  if (!latest.fault && now - latest.answered > timing_.patience()) {
    spoil(latest, IoFaultKind::kSilent);  // its thread still waits for the kernel
  }
  return latest;
}

TofReport TofReader::report() const
{
  const std::lock_guard lock{mutex_};
  return {health_, statistics_};
}

bool TofReader::stopping() const
{
  const std::lock_guard lock{mutex_};
  return stopping_;
}

void TofReader::rest(Time duration)
{
  std::unique_lock lock{mutex_};
  changed_.wait_for(lock, clock_.real(duration), [this] { return stopping_; });
}

void TofReader::run()
{
  while (!stopping()) {
    if (channel_.is_open()) {
      measure();
    } else {
      reopen();
    }
  }
}

void TofReader::reopen()
{
  const Time now = clock_.now();
  std::optional<Time> open_at;
  {
    const std::lock_guard lock{mutex_};
    open_at = health_.open_at();
  }
  if (open_at && now < *open_at) {
    rest(*open_at - now);
    return;
  }
  if (auto fault = channel_.open()) {
    publish_fault(std::move(*fault));
    const std::lock_guard lock{mutex_};
    health_.closed(now);
    return;
  }
  const std::lock_guard lock{mutex_};
  health_.opened();
}

void TofReader::measure()
{
  const Time begun = clock_.now();
  const auto measured = channel_.measure();
  if (measured) {
    publish(measured.value());
  } else {
    publish_fault(measured.fault());
    const std::lock_guard lock{mutex_};
    if (!channel_.is_open() || health_.failures_in_a_row() >= kFailuresBeforeReopening) {
      channel_.close();
      health_.closed(clock_.now());
    }
  }
  const Time took = clock_.now() - begun;
  if (took < kShortestPeriod) {
    rest(kShortestPeriod - took);
  }
}

void TofReader::publish(const TofMeasurement & measurement)
{
  const bool slow = measurement.took() > timing_.longest;
  newest_.reading = range_reading(measurement.millimetres, limits_, measurement.stamp());
  const bool ranged = newest_.reading.status != RangeStatus::kNoTarget;
  newest_.repeats = ranged && measurement.millimetres == last_mm_ ? newest_.repeats + 1 : 1;
  last_mm_ = measurement.millimetres;
  newest_.fault.reset();
  newest_.answered = measurement.ended;
  ++newest_.number;
  if (slow) {
    newest_.reading.status = RangeStatus::kStale;
    newest_.fault = IoFaultKind::kSilent;
  }
  box_.put(newest_);
  const std::lock_guard lock{mutex_};
  statistics_.add(newest_.reading, measurement, newest_.repeats);
  if (slow) {
    health_.failed(
      measurement.ended, {IoFaultKind::kSilent,
                          place_ + ": a measurement took " + milliseconds_text(measurement.took()) +
                            ", accepted: at most " + milliseconds_text(timing_.longest)});
    return;
  }
  health_.answered();
  answered_ = true;
  changed_.notify_all();
}

void TofReader::publish_fault(IoFault fault)
{
  newest_.repeats = 0;
  last_mm_ = -1;
  spoil(newest_, fault.kind);
  box_.put(newest_);
  const std::lock_guard lock{mutex_};
  health_.failed(clock_.now(), std::move(fault));
}

}  // namespace stetro_driver::linux_io
