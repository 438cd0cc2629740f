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

#ifndef STETRO_LOCALIZER__INPUT_WATCH_HPP_
#define STETRO_LOCALIZER__INPUT_WATCH_HPP_

#include <algorithm>
#include <array>
#include <cstddef>

#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// Knows when each input last brought a sample that could be used.
class InputWatch
{
public:
  /// What the localizer listens to.
  static constexpr std::array<Source, 5> kInputs{
    Source::kRanges, Source::kContacts, Source::kBlocks, Source::kGyro, Source::kOdometry};

  explicit InputWatch(double silence_s) : silence_s_(silence_s) {}

  /// An input brought an accepted sample, at the receiver's time.
  void note(Source input, Nanoseconds now) { last(input) = std::max(last(input), now); }

  /// True if the input has brought nothing for too long, counted from the first question on.
  [[nodiscard]] bool is_silent(Source input, Nanoseconds now)
  {
    if (last(input) == Nanoseconds{0}) {
      last(input) = now;
    }
    return seconds(now - last(input)) > silence_s_;
  }

  [[nodiscard]] bool any_silent(Nanoseconds now)
  {
    bool silent = false;
    for (const Source input : kInputs) {
      silent = is_silent(input, now) || silent;
    }
    return silent;
  }

private:
  [[nodiscard]] Nanoseconds & last(Source input) { return last_[static_cast<std::size_t>(input)]; }

  double silence_s_;
  std::array<Nanoseconds, kSourceCount> last_{};
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__INPUT_WATCH_HPP_
