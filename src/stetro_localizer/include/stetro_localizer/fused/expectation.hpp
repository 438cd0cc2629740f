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

#ifndef STETRO_LOCALIZER__FUSED__EXPECTATION_HPP_
#define STETRO_LOCALIZER__FUSED__EXPECTATION_HPP_

#include <array>
#include <cassert>

#include "stetro_localizer/fused/state.hpp"

namespace stetro_localizer
{

/// What a scalar measurement should be by the state, and how it depends on it.
/** The Jacobian is a row with few entries that are not zero; only those are kept. */
class Expectation
{
public:
  struct Entry
  {
    int index = 0;
    double slope = 0.0;
  };
  static constexpr int kMostEntries = 9;

  explicit Expectation(double value) : value_(value) {}

  /// d(value)/d(state[index]); call it once for each index.
  void depends_on(int index, double slope)
  {
    assert(count_ < kMostEntries);
    entries_[static_cast<std::size_t>(count_++)] = {index, slope};
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const Entry * begin() const { return entries_.data(); }
  [[nodiscard]] const Entry * end() const { return entries_.data() + count_; }

private:
  double value_;
  int count_ = 0;
  std::array<Entry, kMostEntries> entries_{};
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__EXPECTATION_HPP_
