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

#include "linux/lines/gpiod_lines.hpp"

#include <gpiod.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>

namespace stetro_driver::linux_io
{
namespace
{

const char * const kConsumer = "stetro_driver";  // what gpioinfo shows
constexpr Time kOtherClock = std::chrono::seconds{10};

IoFault fault(const std::string & what, int error)
{
  std::string hint;
  if (error == EBUSY) {
    hint = ": another program has it, see gpioinfo";
  } else if (error == EACCES || error == EPERM) {
    hint = ": its group must be one of the driver's, see docs/hardware/lines.md";
  }
  return {IoFaultKind::kSilent, what + " (" + std::generic_category().message(error) + ")" + hint};
}

int flags(const LineRequest & line)
{
  int flags = line.active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
  switch (line.bias) {
    case LineBias::kPullUp:
      return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
    case LineBias::kPullDown:
      return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    case LineBias::kNone:
      break;
  }
  return flags | GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
}

Time monotonic()
{
  return std::chrono::duration_cast<Time>(std::chrono::steady_clock::now().time_since_epoch());
}

/// Kernels before 5.7 stamp edges with the time of day: then now is the best that is known.
Time stamp_of(const gpiod_line_event & event)
{
  const Time stamp = std::chrono::seconds{event.ts.tv_sec} + Time{event.ts.tv_nsec};
  const Time now = monotonic();
  return std::chrono::abs(now - stamp) < kOtherClock ? stamp : now;
}

}  // namespace

void GpiodLines::CloseChip::operator()(gpiod_chip * chip) const noexcept { gpiod_chip_close(chip); }

std::optional<IoFault> GpiodLines::open(const std::vector<LineRequest> & lines)
{
  close();
  for (const LineRequest & line : lines) {
    if (auto failed = request(line)) {
      close();
      return failed;
    }
  }
  return std::nullopt;
}

std::optional<IoFault> GpiodLines::request(const LineRequest & line)
{
  auto & chip = chips_[line.chip];
  if (!chip) {
    chip.reset(gpiod_chip_open_lookup(line.chip.c_str()));
    if (!chip) {
      return fault("chip " + line.chip + " cannot be opened", errno);
    }
  }
  const std::string name = "line " + std::to_string(line.offset) + " of " + line.chip;
  const unsigned int size = gpiod_chip_num_lines(chip.get());
  if (line.offset >= size) {
    return IoFault{
      IoFaultKind::kBadAnswer,
      name + ": there are " + std::to_string(size) + ", accepted: less than that"};
  }
  gpiod_line * const requested = gpiod_chip_get_line(chip.get(), line.offset);
  if (
    requested == nullptr ||
    gpiod_line_request_both_edges_events_flags(requested, kConsumer, flags(line)) != 0) {
    return fault(name + " cannot be requested", errno);
  }
  lines_.push_back(requested);
  polled_.push_back({gpiod_line_event_get_fd(requested), POLLIN, 0});
  names_.push_back(name);
  return std::nullopt;
}

void GpiodLines::close() noexcept
{
  polled_.clear();
  lines_.clear();
  names_.clear();
  chips_.clear();
}

std::optional<IoFault> GpiodLines::wait(Time patience, std::vector<LineEdge> & edges)
{
  edges.clear();
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(patience);
  const timespec limit{whole.count(), (patience - whole).count()};
  const int ready = ppoll(polled_.data(), polled_.size(), &limit, nullptr);
  if (ready < 0) {
    return errno == EINTR ? std::nullopt
                          : std::optional<IoFault>{fault("lines cannot be watched", errno)};
  }
  for (std::size_t i = 0; ready > 0 && i < polled_.size(); ++i) {
    if ((polled_[i].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0) {
      return fault(names_[i] + " is gone", ENODEV);
    }
    if ((polled_[i].revents & POLLIN) != 0) {
      if (auto failed = drain(i, edges)) {
        return failed;
      }
    }
  }
  return std::nullopt;
}

std::optional<IoFault> GpiodLines::drain(std::size_t line, std::vector<LineEdge> & edges)
{
  std::array<gpiod_line_event, 16> events{};  // as many as the kernel keeps
  const int size =
    gpiod_line_event_read_fd_multiple(polled_[line].fd, events.data(), events.size());
  if (size < 0) {
    return fault(names_[line] + " cannot be read", errno);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    // With an active-low line rising is becoming active: the kernel has turned it round.
    edges.push_back(
      {line, events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE, stamp_of(events[i])});
  }
  return std::nullopt;
}

Result<LineLevels> GpiodLines::levels()
{
  LineLevels levels;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const int value = gpiod_line_get_value(lines_[i]);
    if (value < 0) {
      return fault(names_[i] + " cannot be read", errno);
    }
    levels[i] = value != 0;
  }
  return levels;
}

}  // namespace stetro_driver::linux_io
