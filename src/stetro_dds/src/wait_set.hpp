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

#ifndef WAIT_SET_HPP_
#define WAIT_SET_HPP_

#include <chrono>

#include "fastdds/dds/core/condition/GuardCondition.hpp"
#include "fastdds/dds/core/condition/WaitSet.hpp"

namespace stetro_dds
{

/// The middleware's WaitSet with a bell to wake it. One thread waits at a time.
class WaitSet
{
public:
  WaitSet();
  ~WaitSet();
  WaitSet(const WaitSet &) = delete;
  WaitSet & operator=(const WaitSet &) = delete;

  void attach(const eprosima::fastdds::dds::Condition & condition);

  /// To be called before the condition is destroyed.
  void detach(const eprosima::fastdds::dds::Condition & condition);

  /// Returns when a condition is true, after `ring()`, or when the time is up.
  void wait(std::chrono::nanoseconds timeout);

  /// From any thread.
  void ring();

private:
  eprosima::fastdds::dds::GuardCondition bell_;
  eprosima::fastdds::dds::WaitSet conditions_;
  eprosima::fastdds::dds::ConditionSeq active_;
};

}  // namespace stetro_dds

#endif  // WAIT_SET_HPP_
