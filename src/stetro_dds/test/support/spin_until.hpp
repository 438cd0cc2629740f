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

#ifndef SUPPORT__SPIN_UNTIL_HPP_
#define SUPPORT__SPIN_UNTIL_HPP_

#include <chrono>

#include "stetro_dds/clock.hpp"
#include "stetro_dds/executor.hpp"

namespace stetro_dds
{

/// Spins until the condition holds. \return whether it came to that in time
template <class Condition>
bool spin_until(Executor & executor, const Condition & condition, std::chrono::nanoseconds timeout)
{
  const auto deadline = Clock::steady_now() + timeout;
  while (!condition()) {
    if (Clock::steady_now() > deadline) {
      return false;
    }
    executor.spin_some(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace stetro_dds

#endif  // SUPPORT__SPIN_UNTIL_HPP_
