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

#include "linux/device_health.hpp"

#include <algorithm>
#include <utility>

namespace stetro_driver::linux_io
{

DeviceHealth::DeviceHealth(std::string device, const BackOff & back_off)
: device_(std::move(device)), back_off_(back_off), next_wait_(back_off.first)
{
}

void DeviceHealth::answered() noexcept
{
  ++counts_.good;
  failures_in_a_row_ = 0;
  faulty_since_.reset();
  next_wait_ = back_off_.first;
}

void DeviceHealth::failed(Time now, IoFault fault)
{
  ++(fault.kind == IoFaultKind::kBadAnswer ? counts_.bad_answers : counts_.timeouts);
  ++failures_in_a_row_;
  if (!faulty_since_) {
    faulty_since_ = now;
  }
  last_fault_ = std::move(fault);
}

void DeviceHealth::closed(Time now) noexcept
{
  open_at_ = now + next_wait_;
  next_wait_ = std::min(2 * next_wait_, back_off_.longest);
}

void DeviceHealth::opened() noexcept
{
  if (open_at_) {
    ++counts_.reopens;
    open_at_.reset();
  }
}

}  // namespace stetro_driver::linux_io
