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

#include "stetro_localizer/stamp_guard.hpp"

namespace stetro_localizer
{

Refusal StampGuard::accept(Nanoseconds stamp, Nanoseconds now)
{
  if (stamp <= Nanoseconds{0}) {
    return Refusal::kZeroStamp;
  }
  if (stamp > now + limits_.future) {
    return Refusal::kFuture;
  }
  if (stamp <= last_) {
    return Refusal::kOutOfOrder;
  }
  if (stamp < now - limits_.age) {
    return Refusal::kTooOld;
  }
  last_ = stamp;
  return Refusal::kNone;
}

}  // namespace stetro_localizer
