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

#ifndef STETRO_DDS__TOPIC_NAME_HPP_
#define STETRO_DDS__TOPIC_NAME_HPP_

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace stetro_dds
{

/// A name that breaks a rule of ROS 2.
class NameError : public std::invalid_argument
{
public:
  NameError(std::string kind, std::string value, std::string rule);

  const std::string kind;      ///< "topic", "namespace" or "node name"
  const std::string value;     ///< the name
  const std::string accepted;  ///< what would be accepted, in words
};

/// A node's name in the graph: namespace ("/", "/stetro") and name ("driver").
struct NodeName
{
  std::string ns;
  std::string name;

  /// "/stetro/driver"; unique in a process.
  [[nodiscard]] std::string full() const;
};

/// \throws NameError for the rule that the namespace or the name breaks
void validate(const NodeName & node);

/// One `-r from:=to` of the ROS 2 command line, both names as the person wrote them.
struct Remapping
{
  std::string from;
  std::string to;
};

/// The absolute ROS name of a topic as `node` sees it.
/**
 * `scan` becomes `<ns>/scan`, `~/scan` becomes `<ns>/<name>/scan`, `/scan` stays. The first
 * remapping whose resolved `from` is that name then replaces it by its resolved `to`.
 *
 * \throws NameError for the rule that the topic breaks
 */
std::string resolve_topic(
  std::string_view topic, const NodeName & node, const std::vector<Remapping> & remappings = {});

/// The DDS name of an absolute ROS topic: "/scan" is "rt/scan" on the wire.
std::string dds_topic_name(std::string_view absolute_topic);

}  // namespace stetro_dds

#endif  // STETRO_DDS__TOPIC_NAME_HPP_
