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

#ifndef STETRO_DDS__SUBSCRIPTION_HPP_
#define STETRO_DDS__SUBSCRIPTION_HPP_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "fastdds/dds/topic/TypeSupport.hpp"
#include "stetro_dds/clock.hpp"
#include "stetro_dds/endpoint.hpp"
#include "stetro_dds/guarded_type.hpp"
#include "stetro_dds/refusal.hpp"

namespace stetro_dds
{

class Participant;
class WaitSet;

/// When and from whom a sample came.
struct Reception
{
  Time steady;  ///< reception by the middleware, on the clock of `Clock::steady_now()` [ns]
  Guid writer;
};

/// Every sample that arrived is in `accepted`, `refused` or `malformed`.
struct SubscriptionCounts
{
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;
  std::uint64_t malformed = 0;  ///< undecodable or beyond the bounds of its type
  std::uint64_t lost = 0;       ///< sent, and never seen here
  std::map<std::string, std::uint64_t, std::less<>> refused_by_reason;

  [[nodiscard]] std::uint64_t received() const { return accepted + refused + malformed; }
};

/// The part of a subscription that does not depend on its message type.
/** Everything but `matched()` belongs to the executor's thread. */
class SubscriptionBase : public Endpoint
{
public:
  /// \throws std::runtime_error naming the topic and what is wrong
  SubscriptionBase(
    Participant & participant, std::string topic, const std::string & dds_topic,
    const eprosima::fastdds::dds::TypeSupport & type, const QosProfile & profile);
  ~SubscriptionBase() override;

  /// Takes what waits, at most `limit` samples, and hands each to the handler in order of arrival.
  /** \return how many were taken, malformed ones included */
  std::size_t take(std::size_t limit);

  [[nodiscard]] Guid guid() const override;
  [[nodiscard]] SubscriptionCounts counts() const;

  /// The last refusal, for whoever reports it; empty reason if there was none.
  [[nodiscard]] const Refusal & last_refusal() const { return last_refusal_; }

  void attach_to(WaitSet & wait_set);
  void detach_from(WaitSet & wait_set);

protected:
  /// The one message that every sample is decoded into.
  virtual void * message() = 0;
  virtual std::optional<Refusal> deliver(const Reception & reception) = 0;

private:
  void count(std::optional<Refusal> refusal);

  class Reader;
  std::unique_ptr<Reader> reader_;
  SubscriptionCounts counts_;
  Refusal last_refusal_;
};

/// Receives messages of one type from one topic.
template <class MessageType>
class Subscription : public SubscriptionBase
{
public:
  using Message = MessageType;
  using Handler = std::function<std::optional<Refusal>(const Message &, const Reception &)>;

  Subscription(
    Participant & participant, std::string topic, const std::string & dds_topic,
    const QosProfile & profile, Handler handler)
  : SubscriptionBase(
      participant, std::move(topic), dds_topic,
      eprosima::fastdds::dds::TypeSupport(new GuardedType<Message>()), profile),
    handler_(std::move(handler))
  {
  }

private:
  void * message() override { return &message_; }
  std::optional<Refusal> deliver(const Reception & reception) override
  {
    return handler_(message_, reception);
  }

  Message message_;
  Handler handler_;
};

/// Makes a handler of anything callable with (message) or (message, reception).
/** It may return nothing at all, or the reason why it does not use the message. */
template <class Message, class Callable>
std::function<std::optional<Refusal>(const Message &, const Reception &)> make_handler(
  Callable callable)
{
  return [callable = std::move(callable)](
           const Message & message, [[maybe_unused]] const Reception & reception) mutable {
    const auto call = [&]() {
      if constexpr (std::is_invocable_v<Callable &, const Message &, const Reception &>) {
        return callable(message, reception);
      } else {
        return callable(message);
      }
    };
    if constexpr (std::is_void_v<decltype(call())>) {
      call();
      return std::optional<Refusal>{};
    } else {
      return std::optional<Refusal>{call()};
    }
  };
}

}  // namespace stetro_dds

#endif  // STETRO_DDS__SUBSCRIPTION_HPP_
