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

#ifndef PARTICIPANT_HPP_
#define PARTICIPANT_HPP_

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "fastdds/dds/domain/DomainParticipant.hpp"
#include "fastdds/dds/publisher/Publisher.hpp"
#include "fastdds/dds/subscriber/Subscriber.hpp"
#include "fastdds/dds/topic/Topic.hpp"
#include "fastdds/dds/topic/TypeSupport.hpp"
#include "graph.hpp"
#include "peers.hpp"
#include "stetro_dds/context.hpp"

namespace stetro_dds
{

/// The middleware's participant with everything that hangs on it.
class Participant
{
public:
  /// \throws std::runtime_error if the middleware refuses
  explicit Participant(const ContextOptions & options);
  ~Participant();
  Participant(const Participant &) = delete;
  Participant & operator=(const Participant &) = delete;

  [[nodiscard]] eprosima::fastdds::dds::Publisher & publisher() { return *publisher_; }
  [[nodiscard]] eprosima::fastdds::dds::Subscriber & subscriber() { return *subscriber_; }
  [[nodiscard]] Peers & peers() { return peers_; }
  [[nodiscard]] Graph & graph() { return *graph_; }

  /// The topic of that name, made at its first use.
  /// \throws std::runtime_error if the name is in use here with another type
  eprosima::fastdds::dds::Topic & topic(
    const std::string & dds_topic, eprosima::fastdds::dds::TypeSupport type);

  /// Wakes whoever waits: an endpoint gained or lost a peer.
  void note_match_change();

  bool wait_for(const std::function<bool()> & condition, std::chrono::nanoseconds timeout);

private:
  void create(const ContextOptions & options);

  Peers peers_;
  eprosima::fastdds::dds::DomainParticipant * participant_ = nullptr;
  eprosima::fastdds::dds::Publisher * publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber * subscriber_ = nullptr;
  std::unique_ptr<Graph> graph_;
  std::mutex topics_;
  std::mutex mutex_;
  std::condition_variable match_changed_;
  std::uint64_t match_changes_ = 0;
};

}  // namespace stetro_dds

#endif  // PARTICIPANT_HPP_
