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

#include "stetro_tests/deadline.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

namespace stetro_tests
{

double time_factor()
{
  const char * text = std::getenv("STETRO_TEST_TIME_FACTOR");
  if (text == nullptr) {
    return 1.0;
  }
  const double factor = std::stod(text);
  if (!(factor >= 1.0 && factor <= 100.0)) {
    throw std::invalid_argument(
      std::string("STETRO_TEST_TIME_FACTOR is ") + text + "; accepted is 1 to 100");
  }
  return factor;
}

Deadline::Deadline(std::chrono::nanoseconds from_now)
: at_(
    std::chrono::steady_clock::now() +
    std::chrono::duration_cast<std::chrono::nanoseconds>(from_now * time_factor()))
{
}

std::chrono::nanoseconds Deadline::remaining() const
{
  return at_ - std::chrono::steady_clock::now();
}

bool poll_until(const std::function<bool()> & condition, std::chrono::nanoseconds limit)
{
  const Deadline deadline{limit};
  while (!condition()) {
    if (deadline.passed()) {
      return condition();
    }
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

}  // namespace stetro_tests
