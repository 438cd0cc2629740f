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

#include "stetro_dds/stamp.hpp"

#include <chrono>
#include <cstdint>
#include <limits>

namespace stetro_dds
{

namespace
{

using std::chrono::seconds;

constexpr std::uint32_t kNanosPerSecond = 1'000'000'000;

}  // namespace

Time time_of(const builtin_interfaces::msg::Time & stamp)
{
  const bool is_valid = stamp.sec() >= 0 && stamp.nanosec() < kNanosPerSecond;
  return is_valid ? seconds{stamp.sec()} + Time{stamp.nanosec()} : Time{0};
}

builtin_interfaces::msg::Time stamp_of(Time time)
{
  builtin_interfaces::msg::Time stamp;
  const auto whole = std::chrono::duration_cast<seconds>(time);
  if (time >= Time{0} && whole.count() <= std::numeric_limits<std::int32_t>::max()) {
    stamp.sec(static_cast<std::int32_t>(whole.count()));
    stamp.nanosec(static_cast<std::uint32_t>((time - whole).count()));
  }
  return stamp;
}

}  // namespace stetro_dds
