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

#ifndef STETRO_DDS__PUBLISHER_HPP_
#define STETRO_DDS__PUBLISHER_HPP_

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "fastdds/dds/topic/TypeSupport.hpp"
#include "stetro_dds/endpoint.hpp"
#include "stetro_dds/guarded_type.hpp"

namespace stetro_dds
{

class Participant;

struct PublisherCounts
{
  std::uint64_t published = 0;
  std::uint64_t failed = 0;         ///< the middleware did not take it
  std::uint64_t out_of_bounds = 0;  ///< a sequence or string longer than its definition allows
};

/// The part of a publisher that does not depend on its message type.
class PublisherBase : public Endpoint
{
public:
  /// \throws std::runtime_error naming the topic and what is wrong
  PublisherBase(
    Participant & participant, std::string topic, const std::string & dds_topic,
    const eprosima::fastdds::dds::TypeSupport & type, const QosProfile & profile);
  ~PublisherBase() override;

  [[nodiscard]] Guid guid() const override;
  [[nodiscard]] PublisherCounts counts() const;

protected:
  bool write(const void * message);
  void count_out_of_bounds() { ++out_of_bounds_; }

private:
  class Writer;
  std::unique_ptr<Writer> writer_;
  std::atomic<std::uint64_t> published_{0};
  std::atomic<std::uint64_t> failed_{0};
  std::atomic<std::uint64_t> out_of_bounds_{0};
};

/// Sends messages of one type on one topic.
template <class MessageType>
class Publisher : public PublisherBase
{
public:
  using Message = MessageType;

  Publisher(
    Participant & participant, std::string topic, const std::string & dds_topic,
    const QosProfile & profile)
  : PublisherBase(
      participant, std::move(topic), dds_topic,
      eprosima::fastdds::dds::TypeSupport(new GuardedType<Message>()), profile)
  {
  }

  /// Sends from the calling thread; any thread may call.
  /** \return false if it was not sent; the reason is counted (`counts()`, `/diagnostics`) */
  bool publish(const Message & message)
  {
    if (!stetro_msgs::within_bounds(message)) {
      count_out_of_bounds();
      return false;
    }
    return write(&message);
  }
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__PUBLISHER_HPP_
