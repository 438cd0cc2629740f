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

#include "stetro_localizer/fused/history.hpp"

#include <algorithm>
#include <utility>

namespace stetro_localizer
{
namespace
{

// By time, and within one time by kind: wheels and gyroscope tell of the time before.
bool before(const Sample & a, const Sample & b)
{
  return std::make_pair(stamp_of(a), a.index()) < std::make_pair(stamp_of(b), b.index());
}

}  // namespace

History::History(const FusedModel & model, FusedCore core, Nanoseconds window, std::size_t capacity)
: model_(&model),
  core_(std::move(core)),
  window_(window),
  ring_(std::max<std::size_t>(capacity, 1), Entry{Sample{}, core_})
{
}

History::Entry & History::entry(std::size_t age_order)
{
  return ring_[(first_ + age_order) % ring_.size()];
}

History::Taken History::take(const Sample & sample)
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
    return Taken::kTwice;
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
  // The cores behind its place are about to be made anew, only the samples move up.
  for (std::size_t i = count_; i > place; --i) {
    entry(i).sample = entry(i - 1).sample;
  }
  if (place < count_) {
    core_ = entry(place).before;
  }
  entry(place).sample = sample;
  ++count_;
  for (std::size_t i = place; i < count_; ++i) {
    Entry & one = entry(i);
    one.before = core_;
    model_->take(core_, one.sample);
  }
  forget_old(stamp_of(entry(count_ - 1).sample));
  return Taken::kYes;
}

void History::forget_old(Nanoseconds newest)
{
  while (count_ > 1 && newest - stamp_of(entry(0).sample) > window_) {
    forgotten_ = stamp_of(entry(0).sample);
    first_ = (first_ + 1) % ring_.size();
    --count_;
  }
}

void History::look_ahead(Nanoseconds time)
{
  ahead_ = core_;
  model_->advance(*ahead_, time);
}

void History::restart(const FusedCore & core)
{
  forgotten_ = count_ > 0 ? std::max(forgotten_, stamp_of(entry(count_ - 1).sample)) : forgotten_;
  core_ = core;
  ahead_.reset();
  first_ = 0;
  count_ = 0;
}

}  // namespace stetro_localizer
