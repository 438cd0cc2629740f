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

#include "wait_set.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace stetro_dds
{

WaitSet::WaitSet() { conditions_.attach_condition(bell_); }

WaitSet::~WaitSet() { conditions_.detach_condition(bell_); }

void WaitSet::attach(const eprosima::fastdds::dds::Condition & condition)
{
  conditions_.attach_condition(condition);
}

void WaitSet::detach(const eprosima::fastdds::dds::Condition & condition)
{
  conditions_.detach_condition(condition);
}

void WaitSet::wait(std::chrono::nanoseconds timeout)
{
  const auto remaining = std::max(timeout, std::chrono::nanoseconds{0});
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(remaining);
  active_.clear();
  conditions_.wait(
    active_, {static_cast<std::int32_t>(whole.count()),
              static_cast<std::uint32_t>((remaining - whole).count())});
  if (bell_.get_trigger_value()) {
    bell_.set_trigger_value(false);
  }
}

void WaitSet::ring() { bell_.set_trigger_value(true); }

}  // namespace stetro_dds
