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

#include "benchmark/topic_table.hpp"

#include <stdexcept>

#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Clock.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/DiagnosticArray.hpp"
#include "stetro_msgs/FleetState.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/Innovations.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_msgs/TFMessage.hpp"

namespace bench
{

namespace
{

/// The message that bytes spell.
template <class Message>
Message decoded(Bytes bytes)
{
  Message message;
  if (bytes.empty()) {
    return message;  // never heard: an empty one
  }
  eprosima::fastrtps::rtps::SerializedPayload_t payload;
  payload.data = bytes.data();
  payload.length = payload.max_size = static_cast<std::uint32_t>(bytes.size());
  const bool sound = stetro_msgs::SupportOf<Message>().deserialize(&payload, &message);
  payload.data = nullptr;  // it is ours
  if (!sound) {
    throw std::invalid_argument("bytes that spell no message");
  }
  return message;
}

template <class Message>
TopicKind kind(const std::string & name, const stetro_dds::QosProfile & profile)
{
  TopicKind result;
  result.name = name;
  result.read = [name, &profile](bare::Participant & participant, bare::Dispatch & dispatch) {
    dispatch.read<Message>(participant, name, profile, [](const Message &) {});
  };
  result.write = [name, &profile](bare::Participant & participant, const Bytes & bytes) {
    auto writer = std::make_shared<bare::Writer<Message>>(participant, name, profile);
    return [writer, message = decoded<Message>(bytes)] { writer->write(message); };
  };
  result.listen = [name, &profile](stetro_tests::Observer & observer) {
    auto & probe = observer.probe<Message>(name, profile);
    return [&probe] {
      const auto last = probe.last();
      return Heard{probe.count(), last ? stetro_tests::bytes_of(*last) : Bytes{}};
    };
  };
  return result;
}

}  // namespace

const std::vector<TopicKind> & topic_table()
{
  namespace qos = stetro_dds::qos;
  using namespace stetro_msgs::msg;  // NOLINT(build/namespaces): the table is all types
  static const std::vector<TopicKind> table = {
    kind<RangeArray>("/stetro/ranges", qos::kSensor),
    kind<Contacts>("/stetro/contacts", qos::kContacts),
    kind<BlockStates>("/stetro/blocks", qos::kSensor),
    kind<sensor_msgs::msg::Imu>("/stetro/imu/data", qos::kSensor),
    kind<nav_msgs::msg::Odometry>("/stetro/odom", qos::kSensor),
    kind<Command>("/stetro/command", qos::kCommand),
    kind<CommandStatus>("/stetro/command_status", qos::kCommandStatus),
    kind<geometry_msgs::msg::PoseWithCovarianceStamped>("/stetro/pose", qos::kPose),
    kind<StairPose>("/stetro/stair_pose", qos::kLatched),
    kind<Innovations>("/stetro/innovations", qos::kSensor),
    kind<tf2_msgs::msg::TFMessage>("/tf", qos::kTf),
    kind<MissionStatus>("/stetro/mission_status", qos::kLatched),
    kind<rmf_fleet_msgs::msg::FleetState>("/fleet_states", qos::kFleetState),
    kind<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", qos::kDiagnostics),
    kind<rosgraph_msgs::msg::Clock>("/clock", qos::kClock),
    kind<StairPose>("/stetro/ground_truth", qos::kSensor),
  };
  return table;
}

const TopicKind & topic_named(const std::string & name)
{
  for (const TopicKind & topic : topic_table()) {
    if (topic.name == name) {
      return topic;
    }
  }
  throw std::invalid_argument("no topic " + name);
}

}  // namespace bench
