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

#ifndef STETRO_LOCALIZER__SAMPLE_HISTORY_HPP_
#define STETRO_LOCALIZER__SAMPLE_HISTORY_HPP_

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// The last samples, each with the core from before it: what lets a late one in at its time.
/**
 * A sample that is older than others goes back to the core from before it, and those others are
 * taken again after it, so that the order of arrival leaves no trace in the result. All memory is
 * taken at construction.
 *
 * A `Model` names its `Core`, which can be copied, and its `Sample`, a variant with `stamp_of`; it
 * takes a core over a sample, `take(core, sample)`, lets time pass, `advance(core, time)`, and adds
 * to a sample what another of its kind and time has beyond it, `fill_in(kept, sample)`, which says
 * whether there was any. It must live as long as its history. Samples of one time are taken in the
 * order of their kinds.
 */
template <class Model>
class SampleHistory
{
public:
  using Core = typename Model::Core;
  using Sample = typename Model::Sample;

  enum class Taken {
    kYes,
    kStale,  ///< older than what is kept
    kTwice   ///< there is one of the same kind and time, and nothing in this that is not in it
  };

  /// \param window how long samples are kept
  /// \param capacity most samples that are kept; with more in the window the oldest leave
  SampleHistory(const Model & model, Core core, Nanoseconds window, std::size_t capacity)
  : model_(&model),
    core_(std::move(core)),
    window_(window),
    ring_(std::max<std::size_t>(capacity, 1), Entry{Sample{}, core_})
  {
  }

  /// Takes a sample at its place in time.
  Taken take(const Sample & sample)
  {
    ahead_.reset();
    const Nanoseconds stamp = stamp_of(sample);
    if (stamp <= forgotten_) {
      return Taken::kStale;
    }
    std::size_t place = count_;
    while (place > 0 && before(sample, entry(place - 1).sample)) {
      --place;
    }
    if (place > 0 && !before(entry(place - 1).sample, sample)) {
      if (!Model::fill_in(entry(place - 1).sample, sample)) {
        return Taken::kTwice;
      }
      core_ = entry(place - 1).before;
      replay(place - 1);
      return Taken::kYes;
    }
    if (count_ == ring_.size()) {
      if (place == 0) {
        return Taken::kStale;
      }
      forgotten_ = stamp_of(entry(0).sample);
      first_ = (first_ + 1) % ring_.size();
      --count_;
      --place;
    }
    insert(sample, place);
    forget_old(stamp_of(entry(count_ - 1).sample));
    return Taken::kYes;
  }

  /// Where the samples have led, or where the motion goes on from there after `look_ahead`.
  [[nodiscard]] const Core & core() const { return ahead_ ? *ahead_ : core_; }

  /// Lets the motion go on as it was until `time`, for want of samples; the next one takes it back.
  void look_ahead(Nanoseconds time)
  {
    ahead_ = core_;
    model_->advance(*ahead_, time);
  }

  /// The core as of a while ago: no late sample changes it any more.
  [[nodiscard]] const Core & settled() const { return count_ > 0 ? ring_[first_].before : core_; }

  /// Goes on from another core; what was kept cannot be taken again.
  /** \param until samples up to this time are in that core */
  void restart(const Core & core, Nanoseconds until = Nanoseconds{0})
  {
    const Nanoseconds last = count_ > 0 ? stamp_of(entry(count_ - 1).sample) : forgotten_;
    forgotten_ = std::max({forgotten_, last, until});
    core_ = core;
    ahead_.reset();
    first_ = 0;
    count_ = 0;
  }

private:
  struct Entry
  {
    Sample sample;
    Core before;
  };

  // By time, and within one time by kind: wheels and gyroscope tell of the time before.
  static bool before(const Sample & a, const Sample & b)
  {
    return std::make_pair(stamp_of(a), a.index()) < std::make_pair(stamp_of(b), b.index());
  }

  [[nodiscard]] Entry & entry(std::size_t age_order)
  {
    return ring_[(first_ + age_order) % ring_.size()];
  }

  // The cores behind its place are made anew, only the samples move up.
  void insert(const Sample & sample, std::size_t place)
  {
    for (std::size_t i = count_; i > place; --i) {
      entry(i).sample = entry(i - 1).sample;
    }
    if (place < count_) {
      core_ = entry(place).before;
    }
    entry(place).sample = sample;
    ++count_;
    replay(place);
  }

  // From there on, with the core as it was before.
  void replay(std::size_t from)
  {
    for (std::size_t i = from; i < count_; ++i) {
      Entry & one = entry(i);
      one.before = core_;
      model_->take(core_, one.sample);
    }
  }

  void forget_old(Nanoseconds newest)
  {
    while (count_ > 1 && newest - stamp_of(entry(0).sample) > window_) {
      forgotten_ = stamp_of(entry(0).sample);
      first_ = (first_ + 1) % ring_.size();
      --count_;
    }
  }

  const Model * model_;
  Core core_;
  std::optional<Core> ahead_;
  Nanoseconds window_;
  std::vector<Entry> ring_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  Nanoseconds forgotten_{0};  // samples up to this time are no longer kept
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SAMPLE_HISTORY_HPP_
