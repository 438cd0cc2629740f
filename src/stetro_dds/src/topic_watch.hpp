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

#ifndef TOPIC_WATCH_HPP_
#define TOPIC_WATCH_HPP_

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "peers.hpp"
#include "stetro_dds/node.hpp"

namespace stetro_dds
{

/// Looks after a node's topics: says once what is wrong with each, and reports to diagnostics.
class Node::TopicWatch
{
public:
  explicit TopicWatch(Node & node) : node_(node) {}

  /// Logs what is new: peers that cannot match, first refusals, topics without a peer after 5 s.
  void look();

  /// Counters and mismatches of every topic; a warning if something went wrong since the last.
  void report(DiagnosticReport & report);

private:
  struct Seen
  {
    Time since = Clock::steady_now();
    bool hinted = false;
    std::set<std::string> told{};           ///< what is already in the log
    std::vector<std::string> mismatches{};  ///< "<peer>: <why>", at the last look
    std::uint64_t troubles = 0;             ///< at the last report
  };

  void find_mismatches(const Endpoint & endpoint, PeerEndpoint::Role role, Seen & seen) const;
  void tell_refusals(const SubscriptionBase & subscription, Seen & seen) const;
  void hint_at_silence(const Endpoint & endpoint, Seen & seen) const;
  void report_one(const Endpoint & endpoint, std::uint64_t troubles, DiagnosticReport & report);

  Node & node_;
  std::map<const Endpoint *, Seen> seen_;
  std::uint64_t peers_revision_ = ~std::uint64_t{0};
};

/// What discovery tells the others about an endpoint of ours.
PeerEndpoint as_peer(const Endpoint & endpoint, PeerEndpoint::Role role);

}  // namespace stetro_dds

#endif  // TOPIC_WATCH_HPP_
