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

#include "emulator/emulated_lines.hpp"

#include <algorithm>
#include <chrono>

namespace stetro_driver::emulator
{
namespace
{

using linux_io::LineBias;
using linux_io::LineEdge;
using linux_io::LineLevels;
using linux_io::LineRequest;

constexpr std::size_t kKernelsQueue = 16;
constexpr Time kBounce = std::chrono::microseconds{200};
constexpr Time kChatter = std::chrono::milliseconds{1};

Time monotonic()
{
  return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now().time_since_epoch());
}

std::chrono::steady_clock::time_point moment(Time monotonic_time)
{
  return std::chrono::steady_clock::time_point{
    std::chrono::duration_cast<std::chrono::steady_clock::duration>(monotonic_time)};
}

LineName name_of(const LineRequest & request) { return {request.chip, request.offset}; }

}  // namespace

EmulatedLines::EmulatedLines(const linux_io::DeviceClock & clock) : clock_(clock) {}

bool EmulatedLines::rest_level(const LineName & name, const Wire & wire) const
{
  if (wire.stuck) {
    return *wire.stuck;
  }
  if (wire.driven) {
    return *wire.driven;
  }
  const auto asked = std::find_if(
    requested_.begin(), requested_.end(),
    [&](const Requested & line) { return name_of(line.request) == name; });
  return asked != requested_.end() && asked->request.bias == LineBias::kPullUp;
}

void EmulatedLines::change(const LineName & name, bool bounce)
{
  Time now = monotonic();
  advance(now);
  Wire & wire = wires_[name];
  const bool target = rest_level(name, wire);
  wire.coming.clear();
  if (target != wire.high) {
    for (int i = 0; bounce && i < bounces_; ++i) {
      wire.coming.push_back({now, target});
      wire.coming.push_back({now + clock_.real(kBounce), !target});
      now += 2 * clock_.real(kBounce);
    }
    wire.coming.push_back({now, target});
  }
  changed_.notify_all();
}

void EmulatedLines::drive(const LineName & line, bool high)
{
  const Lock lock{mutex_};
  wires_[line].driven = high;
  change(line, true);
}

void EmulatedLines::release(const LineName & line)
{
  const Lock lock{mutex_};
  wires_[line].driven.reset();
  change(line, true);
}

void EmulatedLines::set_bounces(int bounces)
{
  const Lock lock{mutex_};
  bounces_ = bounces;
}

void EmulatedLines::lose_edges(const LineName & line, bool lost)
{
  const Lock lock{mutex_};
  wires_[line].edges_lost = lost;
}

void EmulatedLines::stick(const LineName & line, std::optional<bool> high)
{
  const Lock lock{mutex_};
  wires_[line].stuck = high;
  change(line, false);
}

void EmulatedLines::set_chatter(const LineName & line, bool chatters)
{
  const Lock lock{mutex_};
  wires_[line].chatters = chatters;
  if (chatters) {
    wires_[line].coming.push_back({monotonic(), !wires_[line].high});
    changed_.notify_all();
  } else {
    change(line, false);
  }
}

void EmulatedLines::set_plugged(const std::string & chip, bool plugged)
{
  const Lock lock{mutex_};
  if (plugged) {
    unplugged_.erase(chip);
  } else {
    unplug(chip);
    unplugged_.insert(chip);
  }
}

void EmulatedLines::replace(const std::string & chip, unsigned int lines)
{
  const Lock lock{mutex_};
  unplug(chip);
  sizes_[chip] = lines;
}

void EmulatedLines::unplug(const std::string & chip)
{
  for (const Requested & line : requested_) {
    if (line.request.chip == chip) {
      lost_ = chip;
    }
  }
  changed_.notify_all();
}

void EmulatedLines::set_taken(const LineName & line, bool taken)
{
  const Lock lock{mutex_};
  if (taken) {
    taken_.insert(line);
  } else {
    taken_.erase(line);
  }
}

void EmulatedLines::set_hanging(bool hanging)
{
  const Lock lock{mutex_};
  hanging_ = hanging;
  changed_.notify_all();
}

void EmulatedLines::advance(Time now)
{
  for (auto & [name, wire] : wires_) {
    while (!wire.coming.empty() && wire.coming.front().at <= now) {
      const Change due = wire.coming.front();
      wire.coming.pop_front();
      if (due.high != wire.high) {
        wire.high = due.high;
        put_edge(name, wire, due.at);
      }
      if (wire.chatters) {
        wire.coming.push_back({due.at + clock_.real(kChatter), !wire.high});
      }
    }
  }
}

void EmulatedLines::put_edge(const LineName & name, const Wire & wire, Time at)
{
  for (std::size_t i = 0; i < requested_.size(); ++i) {
    Requested & line = requested_[i];
    const bool kept = !wire.edges_lost && line.queue.size() < kKernelsQueue;
    if (name_of(line.request) == name && kept) {
      line.queue.push_back({i, wire.high != line.request.active_low, at});
    }
  }
}

Time EmulatedLines::next_change(Time limit) const
{
  Time next = limit;
  for (const auto & [name, wire] : wires_) {
    if (!wire.coming.empty()) {
      next = std::min(next, wire.coming.front().at);
    }
  }
  return next;
}

std::optional<IoFault> EmulatedLines::gone() const
{
  if (lost_) {
    return IoFault{IoFaultKind::kSilent, "chip " + *lost_ + " is gone (ENODEV)"};
  }
  if (requested_.empty()) {
    return IoFault{IoFaultKind::kNotConfigured, "no line was requested"};
  }
  return std::nullopt;
}

std::optional<IoFault> EmulatedLines::refusal(const LineRequest & line) const
{
  const std::string name = "line " + std::to_string(line.offset) + " of " + line.chip;
  if (unplugged_.count(line.chip) != 0) {
    return IoFault{IoFaultKind::kSilent, "chip " + line.chip + " cannot be opened (ENOENT)"};
  }
  const auto size = sizes_.find(line.chip);
  if (size != sizes_.end() && line.offset >= size->second) {
    return IoFault{
      IoFaultKind::kBadAnswer,
      name + ": there are " + std::to_string(size->second) + ", accepted: less than that"};
  }
  if (taken_.count(name_of(line)) != 0) {
    return IoFault{IoFaultKind::kSilent, name + " cannot be requested (EBUSY)"};
  }
  return std::nullopt;
}

std::optional<IoFault> EmulatedLines::open(const std::vector<LineRequest> & lines)
{
  const Lock lock{mutex_};
  requested_.clear();
  lost_.reset();
  for (const LineRequest & line : lines) {
    if (auto refused = refusal(line)) {
      return refused;
    }
  }
  const Time now = monotonic();
  advance(now);
  for (const LineRequest & line : lines) {
    requested_.push_back({line, {}});
  }
  for (const LineRequest & line : lines) {  // the bias acts from now on, and makes no edge
    Wire & wire = wires_[name_of(line)];
    if (wire.coming.empty()) {
      wire.high = rest_level(name_of(line), wire);
    }
  }
  return std::nullopt;
}

void EmulatedLines::close() noexcept
{
  const Lock lock{mutex_};
  requested_.clear();
}

void EmulatedLines::wait_while_hanging(Lock & lock)
{
  changed_.wait(lock, [this] { return !hanging_; });
}

std::optional<IoFault> EmulatedLines::wait(Time patience, std::vector<LineEdge> & edges)
{
  edges.clear();
  Lock lock{mutex_};
  const Time limit = monotonic() + patience;
  for (;;) {
    wait_while_hanging(lock);
    if (auto fault = gone()) {
      return fault;
    }
    const Time now = monotonic();
    advance(now);
    for (Requested & line : requested_) {
      edges.insert(edges.end(), line.queue.begin(), line.queue.end());
      line.queue.clear();
    }
    if (!edges.empty() || now >= limit) {
      return std::nullopt;
    }
    changed_.wait_until(lock, moment(next_change(limit)));
  }
}

Result<LineLevels> EmulatedLines::levels()
{
  Lock lock{mutex_};
  wait_while_hanging(lock);
  if (auto fault = gone()) {
    return *fault;
  }
  advance(monotonic());
  LineLevels levels;
  for (std::size_t i = 0; i < requested_.size(); ++i) {
    const LineRequest & request = requested_[i].request;
    levels[i] = wires_[name_of(request)].high != request.active_low;
  }
  return levels;
}

}  // namespace stetro_driver::emulator
