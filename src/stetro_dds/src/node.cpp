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

#include "stetro_dds/node.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "participant.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/Clock.hpp"
#include "topic_watch.hpp"

namespace stetro_dds
{

namespace
{

constexpr auto kDiagnosticsPeriod = std::chrono::seconds(1);  // ROS 2's; stale after 5 s

NodeName checked(NodeName name)
{
  validate(name);
  return name;
}

/// A logger of the node's own name that writes where the default one does.
std::shared_ptr<spdlog::logger> logger_of(const NodeName & name)
{
  return spdlog::default_logger()->clone(name.full());
}

void report_clock(const Clock & clock, DiagnosticReport & report)
{
  const auto faults = clock.faults();
  if (!clock.known()) {
    report.summarise(Health::kWarn, "no time yet on /clock");
  }
  if (faults.behind > std::chrono::seconds(1)) {
    report.summarise(Health::kWarn, "the system clock was set back");
  }
  report.value("time zero refused", faults.zero);
  report.value("steps backwards refused", faults.backwards);
  report.value("steps forwards", faults.forwards);
  report.value("system clock behind [s]", static_cast<double>(faults.behind.count()) * 1e-9);
}

}  // namespace

Node::Node(Context & context, NodeOptions options)
: context_(context),
  name_(checked({options.ns, options.name})),
  remappings_(std::move(options.remappings)),
  log_(logger_of(name_)),
  clock_(options.time)
{
  context_.participant().graph().add_node(name_);
  watch_ = std::make_unique<TopicWatch>(*this);
  if (clock_.source() == TimeSource::kClockTopic) {
    follow_clock_topic();
  }
  diagnostics_ = std::make_unique<Diagnostics>(*this, options.hardware_id);
  diagnostics_->add("lifecycle", [this](DiagnosticReport & report) {
    report.value("state", std::string(to_string(lifecycle_.state())));
  });
  diagnostics_->add("clock", [this](DiagnosticReport & report) { report_clock(clock_, report); });
  diagnostics_->add("topics", [this](DiagnosticReport & report) { watch_->report(report); });
  create_steady_timer(kDiagnosticsPeriod, [this](Time) {
    watch_->look();
    diagnostics_->publish();
  });
}

Node::~Node()
{
  if (executor_ != nullptr) {
    executor_->remove(*this);
  }
  auto & participant = context_.participant();
  for (const auto & publisher : publishers_) {
    participant.peers().remove(publisher->guid());
  }
  for (const auto & subscription : subscriptions_) {
    participant.peers().remove(subscription->guid());
  }
  participant.graph().remove_node(name_);
}

void Node::follow_clock_topic()
{
  subscribe<rosgraph_msgs::msg::Clock>(
    "/clock", qos::kClock, [this](const rosgraph_msgs::msg::Clock & message) {
      return clock_.set(time_of(message.clock()));
    });
}

void Node::adopt(std::unique_ptr<PublisherBase> publisher)
{
  auto & participant = context_.participant();
  participant.peers().add(as_peer(*publisher, PeerEndpoint::Role::kWriter));
  participant.graph().add_writer(name_, publisher->guid());
  publishers_.push_back(std::move(publisher));
}

void Node::adopt(std::unique_ptr<SubscriptionBase> subscription)
{
  auto & participant = context_.participant();
  participant.peers().add(as_peer(*subscription, PeerEndpoint::Role::kReader));
  participant.graph().add_reader(name_, subscription->guid());
  subscriptions_.push_back(std::move(subscription));
}

Timer & Node::create_timer(std::chrono::nanoseconds period, std::function<void(Time)> callback)
{
  timers_.push_back(
    std::make_unique<Timer>(clock_, Timer::Counts::kNodeTime, period, std::move(callback)));
  return *timers_.back();
}

Timer & Node::create_steady_timer(
  std::chrono::nanoseconds period, std::function<void(Time)> callback)
{
  timers_.push_back(
    std::make_unique<Timer>(clock_, Timer::Counts::kSteadyTime, period, std::move(callback)));
  return *timers_.back();
}

std::string Node::resolve(std::string_view topic) const
{
  return resolve_topic(topic, name_, remappings_);
}

std::vector<std::string> Node::unmatched() const
{
  std::vector<std::string> topics;
  const auto collect = [&topics](const auto & endpoints) {
    for (const auto & endpoint : endpoints) {
      if (endpoint->matched() == 0 && endpoint->topic() != "/diagnostics") {
        topics.push_back(endpoint->topic());
      }
    }
  };
  collect(publishers_);
  collect(subscriptions_);
  return topics;
}

bool Node::wait_matched(
  const std::vector<std::string> & topics, std::chrono::nanoseconds timeout) const
{
  std::vector<std::string> wanted;
  std::transform(
    topics.begin(), topics.end(), std::back_inserter(wanted),
    [this](const std::string & topic) { return resolve(topic); });
  return context_.wait_for(
    [&]() {
      const auto missing = unmatched();
      if (wanted.empty()) {
        return missing.empty();
      }
      return std::none_of(wanted.begin(), wanted.end(), [&](const std::string & topic) {
        return std::find(missing.begin(), missing.end(), topic) != missing.end();
      });
    },
    timeout);
}

}  // namespace stetro_dds
