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

#include "accuracy/step_watch.hpp"

#include <utility>

namespace stetro_bringup
{
namespace
{

using stetro_localizer::Integrity;
using stetro_supervisor::Phase;
using stetro_supervisor::State;

constexpr stetro_driver::Time kConfirmation = std::chrono::milliseconds(500);

}  // namespace

void StepWatch::watch(const Moment & now)
{
  const bool wrong = now.estimate.step != now.truth.step;
  if (wrong != wrong_) {
    wrong_ = wrong;
    since_ = now.time;
  }
  const bool lasts = now.time - since_ > kConfirmation;
  if (wrong && lasts && now.estimate.step && !miscount_) {
    miscount_ = Miscount{};
  } else if (!wrong && lasts) {
    end_miscount();
  }
  if (begins_lift(now.state)) {
    check(now);
  }
  if (miscount_ && now.estimate.integrity != Integrity::kOk) {
    miscount_->end = MiscountEnd::kNoticed;
  }
}

StepTally StepWatch::take()
{
  if (miscount_) {
    tally_.miscounts.push_back(*miscount_);
  }
  return std::move(tally_);
}

bool StepWatch::begins_lift(State state)
{
  if (stetro_supervisor::phase_of(state) == Phase::kStanding) {
    return false;
  }
  const bool begins = state == State::kLiftBlock2 && working_in_ != state;
  working_in_ = state;
  return begins;
}

void StepWatch::check(const Moment & now)
{
  first_tread_ = first_tread_ && now.truth.step == 0;
  ++tally_.checks;
  tally_.on_stairs += first_tread_ ? 0 : 1;
  if (!wrong_) {
    return;
  }
  if (!miscount_) {
    miscount_ = Miscount{};
  }
  const bool ok = now.estimate.integrity == Integrity::kOk;
  ++tally_.wrong;
  tally_.undetected += ok ? 1 : 0;
  miscount_->climbs += ok && miscount_->end == MiscountEnd::kUnnoticed ? 1 : 0;
}

void StepWatch::end_miscount()
{
  if (!miscount_) {
    return;
  }
  if (miscount_->end == MiscountEnd::kUnnoticed) {
    miscount_->end = MiscountEnd::kCorrected;
  }
  tally_.miscounts.push_back(*miscount_);
  miscount_.reset();
}

}  // namespace stetro_bringup
