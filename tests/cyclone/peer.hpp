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

#ifndef TESTS__CYCLONE__PEER_HPP_
#define TESTS__CYCLONE__PEER_HPP_

#include <dds/dds.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace stetro_tests::cyclone
{

/// The 16 bytes that name a participant or an endpoint on the wire.
using Guid = std::array<std::uint8_t, 16>;

/// What one endpoint asks for or offers; history is KEEP_LAST.
struct Quality
{
  bool reliable;
  bool transient_local;
  std::int32_t depth;
};

/// A participant as another vendor sees it.
struct SeenParticipant
{
  Guid guid;
  std::string user_data;
};

/// An endpoint as another vendor sees it.
struct SeenEndpoint
{
  Guid guid;
  Guid participant;
  std::string topic;  ///< DDS name, such as rt/stetro/pose
  std::string type;   ///< DDS name, such as stetro_msgs::msg::dds_::StairPose_
  bool reliable;
  bool transient_local;
  std::string user_data;
  std::vector<std::string> partitions;
  bool plain_cdr;  ///< data representation is XCDR1, alone
};

/// A Cyclone DDS participant that knows the loopback only.
class Peer
{
public:
  /// \throws std::runtime_error with Cyclone's reason
  explicit Peer(std::uint32_t domain_id);
  ~Peer();
  Peer(const Peer &) = delete;
  Peer & operator=(const Peer &) = delete;

  [[nodiscard]] dds_entity_t participant() const { return participant_; }
  [[nodiscard]] Guid guid() const;

  /// The others that it has discovered and not lost.
  [[nodiscard]] std::vector<SeenParticipant> participants() const;
  [[nodiscard]] std::vector<SeenEndpoint> publications() const;
  [[nodiscard]] std::vector<SeenEndpoint> subscriptions() const;

  dds_entity_t make_topic(const dds_topic_descriptor_t & type, const std::string & name);
  dds_entity_t make_reader(dds_entity_t topic, const Quality & quality);
  dds_entity_t make_writer(dds_entity_t topic, const Quality & quality);

private:
  [[nodiscard]] std::vector<SeenEndpoint> endpoints(dds_entity_t builtin) const;

  dds_entity_t domain_;
  dds_entity_t participant_;
  dds_entity_t participants_;
  dds_entity_t publications_;
  dds_entity_t subscriptions_;
};

/// Waits for samples of `reader`, hands each to `look` until that says true.
/** \return whether it said so before the limit */
bool wait_for_sample(
  dds_entity_t reader, const std::function<bool(const void *)> & look,
  std::chrono::nanoseconds limit);

/// Receives one type, given as its C struct and descriptor, from one DDS topic.
template <class Message>
class Reader
{
public:
  Reader(
    Peer & peer, const dds_topic_descriptor_t & type, const std::string & topic,
    const Quality & quality)
  : entity_(peer.make_reader(peer.make_topic(type, topic), quality))
  {
  }

  bool wait_for(const std::function<bool(const Message &)> & fits, std::chrono::nanoseconds limit)
  {
    return wait_for_sample(
      entity_, [&fits](const void * sample) { return fits(*static_cast<const Message *>(sample)); },
      limit);
  }

  bool wait_any(std::chrono::nanoseconds limit)
  {
    return wait_for([](const Message &) { return true; }, limit);
  }

private:
  dds_entity_t entity_;
};

/// Sends one type on one DDS topic.
template <class Message>
class Writer
{
public:
  Writer(
    Peer & peer, const dds_topic_descriptor_t & type, const std::string & topic,
    const Quality & quality)
  : entity_(peer.make_writer(peer.make_topic(type, topic), quality))
  {
  }

  bool write(const Message & message) { return dds_write(entity_, &message) == DDS_RETCODE_OK; }

  [[nodiscard]] std::uint32_t matched() const
  {
    dds_publication_matched_status_t status{};
    dds_get_publication_matched_status(entity_, &status);
    return status.current_count;
  }

private:
  dds_entity_t entity_;
};

/// The same type under the name it has on the wire.
dds_topic_descriptor_t renamed(const dds_topic_descriptor_t & type, const char * name);

}  // namespace stetro_tests::cyclone

#endif  // TESTS__CYCLONE__PEER_HPP_
