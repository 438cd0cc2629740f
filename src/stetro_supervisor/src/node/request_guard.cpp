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

#include "request_guard.hpp"

#include <algorithm>

namespace stetro_supervisor
{
namespace
{

constexpr std::size_t kIssuersKept = 64;

std::string seconds(stetro_dds::Time time)
{
  return std::to_string(std::chrono::duration<double>(time).count()) + " s";
}

}  // namespace

std::optional<Refusal> RequestGuard::judge(
  stetro_dds::Time stamp, const Now & now, const std::string & issuer,
  const stetro_dds::Guid & writer)
{
  if (stamp <= stetro_dds::Time{0}) {
    return Refusal{"zero_stamp", "stamp is zero or negative, accepted: the time of the request"};
  }
  const bool comparable = now.source == stetro_dds::TimeSource::kSystem;
  if (comparable && stamp > now.time + tolerance_) {
    return Refusal{
      "future_stamp", "stamp is " + seconds(stamp - now.time) + " ahead of the robot's clock, " +
                        "accepted: at most " + seconds(tolerance_)};
  }
  if (comparable && now.time - stamp > tolerance_) {
    return Refusal{
      "too_old",
      "stamp is " + seconds(now.time - stamp) + " old, accepted: at most " + seconds(tolerance_)};
  }
  const auto last = std::find_if(last_.begin(), last_.end(), [&](const Last & known) {
    return known.issuer == issuer && known.writer == writer;
  });
  if (last != last_.end()) {
    if (stamp < last->stamp) {
      return Refusal{
        "out_of_order", "stamp is " + seconds(last->stamp - stamp) + " before the request before"};
    }
    last_.erase(last);
  }
  last_.push_back({issuer, writer, stamp});
  if (last_.size() > kIssuersKept) {
    last_.pop_front();
  }
  return std::nullopt;
}

}  // namespace stetro_supervisor
