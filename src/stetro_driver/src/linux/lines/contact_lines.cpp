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

#include "linux/lines/contact_lines.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr auto kStop = static_cast<std::size_t>(ContactPlace::kEmergencyStop);
const char * const kDevice = "contacts";

IoFault named(const IoFault & fault)
{
  return {fault.kind, std::string(kDevice) + ": " + fault.detail};
}

}  // namespace

ContactLines::ContactLines(
  const ContactLinesConfig & config, LinePort & port, const DeviceClock & clock)
: port_(port), clock_(clock), poll_(seconds_to_time(config.poll_s)), health_(kDevice)
{
  limits_.release = seconds_to_time(config.release_s);
  limits_.most_edges = static_cast<std::uint64_t>(config.most_edges_per_s);
  contacts_.fill(ContactDebounce{limits_});
  if (!config.lines[kStop].fitted()) {
    throw HardwareError("contacts: emergency_stop.chip is none, accepted: a chip");
  }
  std::set<std::pair<std::string, std::int64_t>> taken;
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    const ContactLineConfig & line = config.lines[i];
    if (!line.fitted()) {
      continue;
    }
    if (!taken.emplace(line.chip, line.line).second) {
      throw HardwareError(
        "contacts: " + std::string(kContactNames[i]) + " is line " + std::to_string(line.line) +
        " of " + line.chip + " as another contact is, accepted: a line of its own");
    }
    requests_.push_back(line.request());
    places_.push_back(i);
  }
}

ContactLines::~ContactLines() { stop(); }

void ContactLines::start()
{
  stop();
  if (const auto fault = port_.open(requests_)) {
    throw HardwareError(named(*fault).detail);
  }
  const auto levels = port_.levels();
  const std::string wrong = levels ? begin(levels.value()) : named(levels.fault()).detail;
  if (!wrong.empty()) {
    port_.close();
    throw HardwareError(wrong);
  }
  stopping_ = false;
  thread_ = std::thread{[this] { run(); }};
}

std::string ContactLines::begin(const LineLevels & levels)
{
  const Lock lock{mutex_};
  std::size_t closed = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    contacts_[places_[i]].begin(levels[i], places_[i] == kStop);
    closed += places_[i] != kStop && levels[i] ? 1 : 0;
  }
  const std::size_t switches = places_.size() - 1;
  if (switches > 1 && closed == switches) {
    return "contacts: all " + std::to_string(switches) +
           " bumpers and riser switches are closed, accepted: some open; look at their common wire";
  }
  if (contacts_[kStop].closed()) {
    latched_ = true;
  }
  health_.opened();
  health_.answered();
  publish(clock_.now(), std::nullopt);
  return "";
}

void ContactLines::stop() noexcept
{
  {
    const Lock lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
  port_.close();
}

ContactLatest ContactLines::latest(Time now)
{
  ContactLatest latest = box_.latest().value_or(ContactLatest{});
  if (!latest.fault && now - latest.read > 3 * poll_) {
    latest.fault = IoFaultKind::kSilent;  // its thread hangs
  }
  if (latest.fault) {
    for (ContactReading & contact : latest.contacts) {
      contact.fault = true;
    }
  }
  latest.emergency_stop_latched = latched_ || latest.fault == IoFaultKind::kNotConfigured;
  return latest;
}

std::optional<IoFault> ContactLines::reset_emergency_stop()
{
  const Lock lock{mutex_};
  if (health_.faulty() || contacts_[kStop].trouble() != ContactTrouble::kNone) {
    return IoFault{
      IoFaultKind::kEmergencyStop, "the emergency stop cannot be read, accepted: after its repair"};
  }
  if (contacts_[kStop].closed()) {
    return IoFault{
      IoFaultKind::kEmergencyStop, "the emergency stop is pressed, accepted: after its release"};
  }
  latched_ = false;
  return std::nullopt;
}

ContactReport ContactLines::report() const
{
  const Lock lock{mutex_};
  ContactReport report{health_, {}, {}};
  report.troubles.fill(ContactTrouble::kNotFitted);
  for (const std::size_t place : places_) {
    report.troubles[place] = contacts_[place].trouble();
    report.statistics[place] = contacts_[place].statistics();
  }
  return report;
}

bool ContactLines::stopping() const
{
  const Lock lock{mutex_};
  return stopping_;
}

void ContactLines::rest(Time duration)
{
  std::unique_lock lock{mutex_};
  changed_.wait_for(lock, clock_.real(duration), [this] { return stopping_; });
}

void ContactLines::run()
{
  while (!stopping()) {
    bool closed = false;
    {
      const Lock lock{mutex_};
      closed = health_.is_closed();
    }
    if (closed) {
      reopen();
    } else {
      watch();
    }
  }
}

void ContactLines::watch()
{
  if (const auto fault = port_.wait(clock_.real(patience()), edges_)) {
    lose(*fault);
    return;
  }
  const auto levels = port_.levels();
  if (!levels) {
    lose(levels.fault());
    return;
  }
  take(levels.value());
}

Time ContactLines::patience() const
{
  const Lock lock{mutex_};
  const bool settling = std::any_of(
    contacts_.begin(), contacts_.end(), [](const ContactDebounce & c) { return c.settling(); });
  return settling ? std::min(poll_, limits_.release) : poll_;
}

void ContactLines::take(const LineLevels & levels)
{
  const Time now = clock_.now();
  const Lock lock{mutex_};
  const std::uint64_t stop_presses = contacts_[kStop].statistics().presses;
  for (const LineEdge & edge : edges_) {
    contacts_[places_[edge.line]].edge(edge.active, clock_.at(edge.stamp));
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    contacts_[places_[i]].level(levels[i], now);
  }
  if (contacts_[kStop].closed() || contacts_[kStop].statistics().presses != stop_presses) {
    latched_ = true;
  }
  health_.answered();
  publish(now, std::nullopt);
}

void ContactLines::lose(const IoFault & fault)
{
  const Time now = clock_.now();
  port_.close();
  const Lock lock{mutex_};
  for (const std::size_t place : places_) {
    contacts_[place].lose();
  }
  latched_ = true;  // nobody knows whether it is pressed
  health_.failed(now, named(fault));
  health_.closed(now);
  publish(now, fault.kind);
}

void ContactLines::reopen()
{
  std::optional<Time> open_at;
  {
    const Lock lock{mutex_};
    open_at = health_.open_at();
  }
  const Time now = clock_.now();
  if (open_at && now < *open_at) {
    rest(*open_at - now);
    return;
  }
  if (const auto fault = port_.open(requests_)) {
    lose(*fault);
    return;
  }
  const Lock lock{mutex_};
  health_.opened();
}

void ContactLines::publish(Time now, std::optional<IoFaultKind> fault)
{
  ContactLatest latest;
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    latest.contacts[i].fault = true;  // not fitted
  }
  for (const std::size_t place : places_) {
    latest.contacts[place] = contacts_[place].reading();
  }
  latest.fault = fault;
  latest.read = now;
  box_.put(latest);
}

}  // namespace stetro_driver::linux_io
