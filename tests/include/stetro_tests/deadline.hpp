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

#ifndef STETRO_TESTS__DEADLINE_HPP_
#define STETRO_TESTS__DEADLINE_HPP_

#include <chrono>
#include <functional>

namespace stetro_tests
{

using std::chrono_literals::operator""s;
using std::chrono_literals::operator""ms;

/// How much longer things may take here: STETRO_TEST_TIME_FACTOR, 1 without it.
/** Sanitizers and loaded machines slow everything down; only limits that end a wait are scaled. */
double time_factor();

/// A moment of the steady clock by which something must have happened, scaled by `time_factor()`.
class Deadline
{
public:
  explicit Deadline(std::chrono::nanoseconds from_now);

  [[nodiscard]] bool passed() const { return remaining() <= std::chrono::nanoseconds{0}; }
  [[nodiscard]] std::chrono::nanoseconds remaining() const;

private:
  std::chrono::steady_clock::time_point at_;
};

/// Looks at `condition` every few milliseconds; for what no wait of its own reports.
/** \return whether it held before the deadline */
bool poll_until(const std::function<bool()> & condition, std::chrono::nanoseconds limit);

}  // namespace stetro_tests

#endif  // STETRO_TESTS__DEADLINE_HPP_
