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
#include "stamp_guard.hpp"

#include <string>

namespace stetro_supervisor
{

std::optional<Refusal> StampGuard::judge(
  stetro_dds::Time stamp, stetro_dds::Time now, const stetro_dds::Guid & writer)
{
  if (stamp <= stetro_dds::Time{0}) {
    return Refusal{"zero_stamp", "stamp is zero or negative, accepted: a time of measurement"};
  }
  if (now <= stetro_dds::Time{0}) {
    return Refusal{"clock_unknown", "no time is known yet"};
  }
  if (stamp > now + tolerance_) {
    return Refusal{
      "future_stamp", "stamp is " + std::to_string((stamp - now).count()) + " ns in the future"};
  }
  if (now - stamp > max_age_) {
    return Refusal{"too_old", "stamp is " + std::to_string((now - stamp).count()) + " ns old"};
  }
  if (writer_ != writer) {
    writer_ = writer;
    last_ = stetro_dds::Time{0};
  }
  if (stamp < last_) {
    return Refusal{
      "out_of_order",
      "stamp is " + std::to_string((last_ - stamp).count()) + " ns before the one before"};
  }
  last_ = stamp;
  return std::nullopt;
}

}  // namespace stetro_supervisor
