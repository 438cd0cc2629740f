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

#include "stetro_dds/monotone_time.hpp"

#include <algorithm>
#include <chrono>

namespace stetro_dds
{

namespace
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr Time kUnnoticed = 1ms;          // a smaller step back is the clock being slewed
constexpr Time kForwardsStep = 1s;        // a larger one forwards is worth a word
constexpr std::int64_t kSlowness = 1000;  // an excess is lost at 1 in this many

}  // namespace

Time MonotoneTime::advance(Time wall, Time steady)
{
  if (time_ == Time{0}) {
    time_ = wall;
    steady_ = steady;
    return time_;
  }
  const Time elapsed = steady - steady_;
  const Time slowest = time_ + elapsed - elapsed / kSlowness;
  const Time behind = std::max(slowest - wall, Time{0});
  if (behind > faults_.behind + kUnnoticed) {
    ++faults_.backwards;
  }
  if (wall > time_ + elapsed + kForwardsStep) {
    ++faults_.forwards;
  }
  faults_.behind = behind;
  time_ = std::max(wall, slowest);
  steady_ = steady;
  return time_;
}

}  // namespace stetro_dds
