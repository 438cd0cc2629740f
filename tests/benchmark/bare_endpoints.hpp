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

#ifndef TESTS__BENCHMARK__BARE_ENDPOINTS_HPP_
#define TESTS__BENCHMARK__BARE_ENDPOINTS_HPP_

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "fastdds/dds/core/condition/GuardCondition.hpp"
#include "fastdds/dds/domain/DomainParticipant.hpp"
#include "fastdds/dds/publisher/DataWriter.hpp"
#include "fastdds/dds/publisher/Publisher.hpp"
#include "fastdds/dds/subscriber/DataReader.hpp"
#include "fastdds/dds/subscriber/SampleInfo.hpp"
#include "fastdds/dds/subscriber/Subscriber.hpp"
#include "fastdds/dds/topic/TypeSupport.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_msgs/support.hpp"

/// Fast DDS with nothing of ours around it, but with the transport, the quality of service and the
/// way of dispatch that stetro_dds uses: what the robot's figures are divided by.
namespace bare
{

namespace dds = eprosima::fastdds::dds;

class Participant
{
public:
  /// \throws std::runtime_error if Fast DDS does not make one
  explicit Participant(std::uint32_t domain_id);
  ~Participant();
  Participant(const Participant &) = delete;
  Participant & operator=(const Participant &) = delete;

  /// \param topic ROS name, such as /stetro/pose
  dds::DataWriter * make_writer(
    dds::TypeSupport type, const std::string & topic, const stetro_dds::QosProfile & profile);
  dds::DataReader * make_reader(
    dds::TypeSupport type, const std::string & topic, const stetro_dds::QosProfile & profile);

private:
  dds::Topic * topic_for(dds::TypeSupport & type, const std::string & topic);

  dds::DomainParticipant * participant_;
  dds::Publisher * publisher_;
  dds::Subscriber * subscriber_;
};

template <class Message>
class Writer
{
public:
  Writer(
    Participant & participant, const std::string & topic, const stetro_dds::QosProfile & profile)
  : writer_(participant.make_writer(
      dds::TypeSupport(new stetro_msgs::SupportOf<Message>()), topic, profile))
  {
  }

  bool write(const Message & message)
  {
    return writer_->write(const_cast<Message *>(&message));  // its interface takes void *
  }

  [[nodiscard]] int matched() const
  {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }

private:
  dds::DataWriter * writer_;
};

/// A thread that waits in a WaitSet and takes what its readers received.
class Dispatch
{
public:
  ~Dispatch();

  /// Before `start()`: each sample of the topic is handed to the callback, in the thread.
  template <class Message, class Callback>
  void read(
    Participant & participant, const std::string & topic, const stetro_dds::QosProfile & profile,
    Callback callback)
  {
    dds::DataReader * reader = participant.make_reader(
      dds::TypeSupport(new stetro_msgs::SupportOf<Message>()), topic, profile);
    readers_.push_back({reader, [reader, callback, message = Message()]() mutable {
                          dds::SampleInfo info;
                          while (reader->take_next_sample(&message, &info) ==
                                 eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
                            if (info.valid_data) {
                              callback(message);
                            }
                          }
                        }});
  }

  void start();
  void stop();

private:
  struct Reading
  {
    dds::DataReader * reader;
    std::function<void()> take_all;
  };

  void run();

  std::vector<Reading> readers_;
  dds::GuardCondition leave_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace bare

#endif  // TESTS__BENCHMARK__BARE_ENDPOINTS_HPP_
