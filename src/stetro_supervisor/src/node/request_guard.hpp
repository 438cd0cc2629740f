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

#ifndef NODE__REQUEST_GUARD_HPP_
#define NODE__REQUEST_GUARD_HPP_

#include <deque>
#include <optional>
#include <string>

#include "stetro_dds/clock.hpp"
#include "stetro_dds/refusal.hpp"
#include "stetro_dds/subscription.hpp"

namespace stetro_supervisor
{

using stetro_dds::Refusal;

/// Refuses requests by their stamps.
/**
 *  - zero or negative: always;
 *  - before the last one of the same issuer and writer: always, equal ones are in order;
 *  - farther from the clock than the tolerance, ahead or behind: only where the clock is the
 *    computer's. On simulated time an operator may well stamp with the clock on the wall, which says
 *    nothing about how old the request is; such an operator is served, and order alone is judged.
 *
 * Whoever stamps with both clocks in turn, from one writer, breaks the order and is refused.
 */
class RequestGuard
{
public:
  /// \param tolerance either way: operators' computers are not synchronised as the robot's are
  explicit RequestGuard(stetro_dds::Time tolerance) : tolerance_(tolerance) {}

  /// The clock that stamps are judged by.
  struct Now
  {
    stetro_dds::Time time;
    stetro_dds::TimeSource source;
  };

  /// \return nothing if the stamp may be used; one that is refused changes nothing
  std::optional<Refusal> judge(
    stetro_dds::Time stamp, const Now & now, const std::string & issuer,
    const stetro_dds::Guid & writer);

private:
  struct Last
  {
    std::string issuer;
    stetro_dds::Guid writer;
    stetro_dds::Time stamp;
  };

  stetro_dds::Time tolerance_;
  std::deque<Last> last_;  // of the issuers heard most lately
};

}  // namespace stetro_supervisor

#endif  // NODE__REQUEST_GUARD_HPP_
