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
#ifndef NODE__STAMP_GUARD_HPP_
#define NODE__STAMP_GUARD_HPP_

#include <optional>

#include "stetro_dds/refusal.hpp"
#include "stetro_dds/subscription.hpp"

namespace stetro_supervisor
{

using stetro_dds::Refusal;

/// Refuses stamps of one topic that are zero, ahead of the clock, too old or before the last.
/**
 * After a process was stopped for a while, its queues still hold what was measured before: by its
 * arrival that would be fresh.
 */
class StampGuard
{
public:
  /// \param max_age by the clock that is judged by; without it, age is left to whoever reads
  explicit StampGuard(
    stetro_dds::Time future_tolerance, stetro_dds::Time max_age = stetro_dds::Time::max())
  : tolerance_(future_tolerance), max_age_(max_age)
  {
  }

  /// \return nothing if the stamp may be used; a new writer starts a new order
  std::optional<Refusal> judge(
    stetro_dds::Time stamp, stetro_dds::Time now, const stetro_dds::Guid & writer);

  /// Whatever comes next starts a new order, of the same writer too.
  void restart() { writer_.reset(); }

private:
  stetro_dds::Time tolerance_;
  stetro_dds::Time max_age_;
  stetro_dds::Time last_{0};
  std::optional<stetro_dds::Guid> writer_;
};

}  // namespace stetro_supervisor

#endif  // NODE__STAMP_GUARD_HPP_
