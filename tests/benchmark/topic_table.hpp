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

#ifndef TESTS__BENCHMARK__TOPIC_TABLE_HPP_
#define TESTS__BENCHMARK__TOPIC_TABLE_HPP_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/bare_endpoints.hpp"
#include "stetro_tests/observer.hpp"
#include "stetro_tests/raw_message.hpp"

namespace bench
{

using stetro_tests::Bytes;

/// How often a topic spoke, and what it said last.
struct Heard
{
  std::size_t count = 0;
  Bytes last;
};

/// A topic of the robot, for programs that treat all topics alike.
struct TopicKind
{
  std::string name;  ///< ROS name
  /// Reads it and throws the messages away.
  std::function<void(bare::Participant &, bare::Dispatch &)> read;
  /// Opens it for writing; each call of the result writes the message that the bytes spell.
  std::function<std::function<void()>(bare::Participant &, const Bytes &)> write;
  /// Listens to the robot's; the result says what was heard so far.
  std::function<std::function<Heard()>(stetro_tests::Observer &)> listen;
};

/// Every topic that the three nodes exchange or publish, and how to treat it.
const std::vector<TopicKind> & topic_table();

/// \throws std::invalid_argument if there is no such topic
const TopicKind & topic_named(const std::string & name);

}  // namespace bench

#endif  // TESTS__BENCHMARK__TOPIC_TABLE_HPP_
