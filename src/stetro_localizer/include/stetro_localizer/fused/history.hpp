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

#ifndef STETRO_LOCALIZER__FUSED__HISTORY_HPP_
#define STETRO_LOCALIZER__FUSED__HISTORY_HPP_

#include <cstddef>
#include <optional>
#include <vector>

#include "stetro_localizer/fused/fused_model.hpp"

namespace stetro_localizer
{

/// The last samples, each with the core from before it: what lets a late one in at its time.
/**
 * A sample that is older than others goes back to the core from before it, and those others are
 * taken again after it, so that the order of arrival leaves no trace in the result. All memory is
 * taken at construction.
 */
class History
{
public:
  enum class Taken {
    kYes,
    kStale,  ///< older than what is kept
    kTwice   ///< there is one of the same kind and time
  };

  /// \param window how long samples are kept
  /// \param capacity most samples that are kept; with more in the window the oldest leave
  History(const FusedModel & model, FusedCore core, Nanoseconds window, std::size_t capacity);

  /// Takes a sample at its place in time.
  Taken take(const Sample & sample);

  /// Where the samples have led, or where the motion goes on from there after `look_ahead`.
  [[nodiscard]] const FusedCore & core() const { return ahead_ ? *ahead_ : core_; }

  /// Lets the motion go on as it was until `time`, for want of samples; the next one takes it back.
  void look_ahead(Nanoseconds time);

  /// The core as of a while ago: no late sample changes it any more.
  [[nodiscard]] const FusedCore & settled() const
  {
    return count_ > 0 ? ring_[first_].before : core_;
  }

  /// Goes on from another core; what was kept cannot be taken again.
  void restart(const FusedCore & core);

private:
  struct Entry
  {
    Sample sample;
    FusedCore before;
  };

  [[nodiscard]] Entry & entry(std::size_t age_order);
  void forget_old(Nanoseconds newest);

  const FusedModel * model_;
  FusedCore core_;
  std::optional<FusedCore> ahead_;
  Nanoseconds window_;
  std::vector<Entry> ring_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  Nanoseconds forgotten_{0};  // samples up to this time are no longer kept
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__HISTORY_HPP_
