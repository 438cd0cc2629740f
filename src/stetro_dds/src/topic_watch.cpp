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

#include "topic_watch.hpp"

#include <chrono>
#include <string>
#include <vector>

#include "participant.hpp"

namespace stetro_dds
{

namespace
{

using Role = PeerEndpoint::Role;
constexpr auto kPatience = std::chrono::seconds(5);  // discovery takes some 10 ms

constexpr std::size_t kMostTold = 200;  // lines about one topic; diagnostics goes on

Role other(Role role) { return role == Role::kWriter ? Role::kReader : Role::kWriter; }

std::uint64_t troubles_of(const SubscriptionCounts & counts)
{
  return counts.refused + counts.malformed;
}

std::uint64_t troubles_of(const PublisherCounts & counts)
{
  return counts.failed + counts.out_of_bounds;
}

void report_counts(
  const std::string & topic, const SubscriptionCounts & counts, DiagnosticReport & report)
{
  report.value(topic + " accepted", counts.accepted);
  report.value(topic + " refused", counts.refused);
  for (const auto & [reason, count] : counts.refused_by_reason) {
    report.value(topic + " refused: " + reason, count);
  }
  report.value(topic + " malformed", counts.malformed);
  report.value(topic + " lost", counts.lost);
}

void report_counts(
  const std::string & topic, const PublisherCounts & counts, DiagnosticReport & report)
{
  report.value(topic + " published", counts.published);
  report.value(topic + " not sent", counts.failed);
  report.value(topic + " out of bounds", counts.out_of_bounds);
}

}  // namespace

PeerEndpoint as_peer(const Endpoint & endpoint, Role role)
{
  const auto & profile = endpoint.profile();
  const auto & qos = role == Role::kWriter ? profile.offered : profile.requested;
  PeerEndpoint peer;
  peer.guid = endpoint.guid();
  peer.role = role;
  peer.dds_topic = dds_topic_name(endpoint.topic());
  peer.type_name = endpoint.type_name();
  peer.reliability = qos.reliability;
  peer.durability = qos.durability;
  return peer;
}

void Node::TopicWatch::look()
{
  const auto revision = node_.context_.participant().peers().revision();
  const bool peers_changed = revision != peers_revision_;
  peers_revision_ = revision;
  for (const auto & publisher : node_.publishers_) {
    auto & seen = seen_[publisher.get()];
    if (peers_changed) {
      find_mismatches(*publisher, Role::kWriter, seen);
    }
  }
  for (const auto & subscription : node_.subscriptions_) {
    auto & seen = seen_[subscription.get()];
    if (peers_changed) {
      find_mismatches(*subscription, Role::kReader, seen);
    }
    tell_refusals(*subscription, seen);
    hint_at_silence(*subscription, seen);
  }
}

void Node::TopicWatch::find_mismatches(const Endpoint & endpoint, Role role, Seen & seen) const
{
  const auto own = as_peer(endpoint, role);
  seen.mismatches.clear();
  for (const auto & peer : node_.context_.participant().peers().on(own.dds_topic, other(role))) {
    const auto why = role == Role::kWriter ? mismatch(own, peer) : mismatch(peer, own);
    if (!why) {
      continue;
    }
    const std::string text = to_string(peer.guid) + ": " + *why;
    seen.mismatches.push_back(text);
    if (seen.told.size() < kMostTold && seen.told.insert(text).second) {
      node_.log_->warn("{} cannot match peer {}", endpoint.topic(), text);
    }
  }
}

void Node::TopicWatch::tell_refusals(const SubscriptionBase & subscription, Seen & seen) const
{
  const auto counts = subscription.counts();
  for (const auto & [reason, count] : counts.refused_by_reason) {
    if (seen.told.insert("refused " + reason).second) {
      const auto & last = subscription.last_refusal();
      node_.log_->warn(
        "{}: message refused: {}{}{}", subscription.topic(), reason,
        last.reason == reason && !last.detail.empty() ? ": " : "",
        last.reason == reason ? last.detail : "");
    }
  }
  if (counts.malformed > 0 && seen.told.insert("malformed").second) {
    node_.log_->warn("{}: malformed message dropped", subscription.topic());
  }
}

void Node::TopicWatch::hint_at_silence(const Endpoint & endpoint, Seen & seen) const
{
  if (endpoint.matched() > 0) {
    seen.hinted = true;
  } else if (!seen.hinted && Clock::steady_now() - seen.since > kPatience) {
    seen.hinted = true;
    node_.log_->info("{}: nobody writes to it so far", endpoint.topic());
  }
}

void Node::TopicWatch::report(DiagnosticReport & report)
{
  for (const auto & publisher : node_.publishers_) {
    const auto counts = publisher->counts();
    report_one(*publisher, troubles_of(counts), report);
    report_counts(publisher->topic(), counts, report);
  }
  for (const auto & subscription : node_.subscriptions_) {
    const auto counts = subscription->counts();
    report_one(*subscription, troubles_of(counts), report);
    report_counts(subscription->topic(), counts, report);
  }
}

void Node::TopicWatch::report_one(
  const Endpoint & endpoint, std::uint64_t troubles, DiagnosticReport & report)
{
  auto & seen = seen_[&endpoint];
  if (troubles > seen.troubles) {
    report.summarise(Health::kWarn, endpoint.topic() + ": messages refused, malformed or not sent");
  }
  seen.troubles = troubles;
  report.value(endpoint.topic() + " matched", static_cast<std::int64_t>(endpoint.matched()));
  for (const auto & text : seen.mismatches) {
    report.summarise(Health::kWarn, endpoint.topic() + " cannot match peer " + text);
    report.value(endpoint.topic() + " mismatch", text);
  }
}

}  // namespace stetro_dds
