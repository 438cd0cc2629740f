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

#ifndef STETRO_LOCALIZER__STAMP_GUARD_HPP_
#define STETRO_LOCALIZER__STAMP_GUARD_HPP_

#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// How far a stamp may lie from now.
struct StampLimits
{
  Nanoseconds future{std::chrono::milliseconds(20)};  ///< later than now by at most this
  Nanoseconds age{std::chrono::milliseconds(300)};    ///< earlier than now by at most this
};

/// Lets the stamps of one source pass in order, and no other.
/**
 * A stamp that is zero, ahead of now, not newer than the last accepted one, or older than the
 * limit is refused; the last accepted stamp then stays.
 */
class StampGuard
{
public:
  explicit StampGuard(StampLimits limits = {}) : limits_(limits) {}

  /// `Refusal::kNone` accepts the stamp and remembers it.
  [[nodiscard]] Refusal accept(Nanoseconds stamp, Nanoseconds now);

  /// The last accepted stamp; zero before the first.
  [[nodiscard]] Nanoseconds last() const { return last_; }

private:
  StampLimits limits_;
  Nanoseconds last_{0};
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STAMP_GUARD_HPP_
