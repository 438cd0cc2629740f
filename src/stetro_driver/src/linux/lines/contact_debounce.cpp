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

#include "linux/lines/contact_debounce.hpp"

#include <algorithm>

namespace stetro_driver::linux_io
{

ContactDebounce::ContactDebounce(const DebounceLimits & limits) : limits_(limits) {}

void ContactDebounce::begin(bool active, bool may_be_closed)
{
  *this = ContactDebounce{limits_};
  closed_ = active;
  stuck_ = active && !may_be_closed;
}

void ContactDebounce::press(Time when) noexcept
{
  open_since_.reset();
  if (!closed_) {
    closed_ = true;
    last_change_ = std::max(last_change_, when);
    ++statistics_.presses;
  }
}

void ContactDebounce::edge(bool active, Time stamp)
{
  ++statistics_.edges;
  ++edges_in_second_;
  if (active) {
    press(stamp);
  } else if (closed_) {
    open_since_ = stamp;
  }
}

void ContactDebounce::level(bool active, Time now)
{
  lost_ = false;
  count_edges(now);
  if (active) {
    statistics_.unheralded += closed_ ? 0 : 1;
    press(now);
    return;
  }
  if (!closed_) {
    return;
  }
  if (!open_since_) {
    open_since_ = now;
  }
  if (now - *open_since_ >= limits_.release) {
    closed_ = false;
    stuck_ = false;
    last_change_ = std::max(last_change_, *open_since_);
    open_since_.reset();
  }
}

void ContactDebounce::count_edges(Time now) noexcept
{
  chatters_ = chatters_ || edges_in_second_ > limits_.most_edges;
  if (now - second_began_ >= std::chrono::seconds{1}) {
    chatters_ = edges_in_second_ > limits_.most_edges;
    edges_in_second_ = 0;
    second_began_ = now;
  }
}

ContactTrouble ContactDebounce::trouble() const noexcept
{
  if (lost_) {
    return ContactTrouble::kLost;
  }
  if (chatters_) {
    return ContactTrouble::kChatters;
  }
  return stuck_ ? ContactTrouble::kStuckClosed : ContactTrouble::kNone;
}

ContactReading ContactDebounce::reading() const noexcept
{
  return {closed_, trouble() != ContactTrouble::kNone, last_change_};
}

}  // namespace stetro_driver::linux_io
