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

#ifndef STETRO_DDS__NODE_HPP_
#define STETRO_DDS__NODE_HPP_

#include <spdlog/logger.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stetro_dds/clock.hpp"
#include "stetro_dds/context.hpp"
#include "stetro_dds/diagnostics.hpp"
#include "stetro_dds/lifecycle.hpp"
#include "stetro_dds/publisher.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_dds/subscription.hpp"
#include "stetro_dds/timer.hpp"
#include "stetro_dds/topic_name.hpp"

namespace stetro_dds
{

class Executor;

struct NodeOptions
{
  std::string name;
  std::string ns = "/";
  TimeSource time = TimeSource::kSystem;
  std::string hardware_id = "none";  ///< the device this node speaks for, in `/diagnostics`
  std::vector<Remapping> remappings{};
};

/// A component's presence in the graph: its endpoints, clock, timers, lifecycle and diagnostics.
/**
 * It owns what it hands out by reference. Build it and its endpoints, then `Executor::add` it;
 * from then on it belongs to the executor's thread, `Publisher::publish` and `clock()` excepted.
 * Destroy it before its context; executor and node may go in either order.
 */
class Node
{
public:
  /// \throws std::invalid_argument for a name that ROS 2 would not accept or that the process has
  Node(Context & context, NodeOptions options);
  ~Node();
  Node(const Node &) = delete;
  Node & operator=(const Node &) = delete;

  /// Opens a topic for writing: `advertise<stetro_msgs::msg::RangeArray>("ranges", qos::kSensor)`.
  /**
   * Message is any type of stetro_msgs; include its header "stetro_msgs/<Type>.hpp".
   *
   * \param topic relative to the namespace, `~/private` or `/absolute`
   * \throws std::invalid_argument for a bad name, std::runtime_error if the middleware refuses
   */
  template <class Message>
  Publisher<Message> & advertise(std::string_view topic, const QosProfile & profile)
  {
    const std::string name = resolve(topic);
    auto publisher = std::make_unique<Publisher<Message>>(
      context_.participant(), name, dds_topic_name(name), profile);
    auto & result = *publisher;
    adopt(std::move(publisher));
    return result;
  }

  /// Opens a topic for reading.
  /**
   * \param handler callable with (const Message &) or (const Message &, const Reception &);
   *   returns nothing, or std::optional<Refusal> with the reason why the message is not used
   */
  template <class Message, class Callable>
  Subscription<Message> & subscribe(
    std::string_view topic, const QosProfile & profile, Callable && handler)
  {
    const std::string name = resolve(topic);
    auto subscription = std::make_unique<Subscription<Message>>(
      context_.participant(), name, dds_topic_name(name), profile,
      make_handler<Message>(std::forward<Callable>(handler)));
    auto & result = *subscription;
    adopt(std::move(subscription));
    return result;
  }

  /// Calls back each period of this node's time (simulated time, when it is that).
  Timer & create_timer(std::chrono::nanoseconds period, std::function<void(Time)> callback);

  /// Calls back each period of the steady clock, whatever the node's time does.
  Timer & create_steady_timer(std::chrono::nanoseconds period, std::function<void(Time)> callback);

  [[nodiscard]] const NodeName & name() const { return name_; }
  [[nodiscard]] Context & context() { return context_; }
  [[nodiscard]] Clock & clock() { return clock_; }
  [[nodiscard]] const Clock & clock() const { return clock_; }
  [[nodiscard]] Lifecycle & lifecycle() { return lifecycle_; }
  [[nodiscard]] const Lifecycle & lifecycle() const { return lifecycle_; }
  [[nodiscard]] Diagnostics & diagnostics() { return *diagnostics_; }
  [[nodiscard]] spdlog::logger & log() const { return *log_; }

  /// The absolute name of a topic as this node sees it.
  [[nodiscard]] std::string resolve(std::string_view topic) const;

  /// Waits until each of the topics (all of the node's own, if none is named) has a peer.
  /**
   * Both ends find each other by themselves: the peer may need some milliseconds more until a
   * volatile message of its own reaches this node.
   *
   * \return whether it came to that in time
   */
  bool wait_matched(
    const std::vector<std::string> & topics, std::chrono::nanoseconds timeout) const;

  /// Topics of this node without a peer, diagnostics and discovery not counted.
  [[nodiscard]] std::vector<std::string> unmatched() const;

  [[nodiscard]] const std::vector<std::unique_ptr<PublisherBase>> & publishers() const
  {
    return publishers_;
  }
  [[nodiscard]] const std::vector<std::unique_ptr<SubscriptionBase>> & subscriptions() const
  {
    return subscriptions_;
  }
  [[nodiscard]] const std::vector<std::unique_ptr<Timer>> & timers() const { return timers_; }

private:
  friend class Executor;

  void adopt(std::unique_ptr<PublisherBase> publisher);
  void adopt(std::unique_ptr<SubscriptionBase> subscription);
  void follow_clock_topic();

  Context & context_;
  const NodeName name_;
  const std::vector<Remapping> remappings_;
  std::shared_ptr<spdlog::logger> log_;
  Clock clock_;
  Lifecycle lifecycle_;
  std::vector<std::unique_ptr<PublisherBase>> publishers_;
  std::vector<std::unique_ptr<SubscriptionBase>> subscriptions_;
  std::vector<std::unique_ptr<Timer>> timers_;
  std::unique_ptr<Diagnostics> diagnostics_;
  class TopicWatch;
  std::unique_ptr<TopicWatch> watch_;
  Executor * executor_ = nullptr;
  std::size_t attached_ = 0;  ///< subscriptions the executor waits for
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__NODE_HPP_
