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

#ifndef TESTS__CYCLONE__KNOWN_TOPICS_HPP_
#define TESTS__CYCLONE__KNOWN_TOPICS_HPP_

#include <dds/dds.h>

#include <string>
#include <vector>

namespace stetro_tests::cyclone
{

/// What ROS 2 expects of one topic of the robot.
struct KnownTopic
{
  std::string name;  ///< ROS name with the namespace /stetro
  std::string node;  ///< the one node that publishes it; empty: several, or nobody in the robot
  const dds_topic_descriptor_t * type;
  bool latched;  ///< offered transient local
  bool sensor;   ///< for RELIABLE and for BEST_EFFORT readers
  bool spoken;   ///< published by a robot in simulation without being asked to

  [[nodiscard]] std::string dds_name() const { return "rt" + name; }
};

/// Every topic that the running robot publishes, written down from the table of the wire.
const std::vector<KnownTopic> & published_topics();

}  // namespace stetro_tests::cyclone

#endif  // TESTS__CYCLONE__KNOWN_TOPICS_HPP_
