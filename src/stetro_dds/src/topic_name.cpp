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

#include "stetro_dds/topic_name.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stetro_dds
{

namespace
{

constexpr std::size_t kLongestTopic = 247;  // with its prefix it must fit 255
constexpr std::size_t kLongestNodeName = 255;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The rule of ROS 2 names that one part between slashes breaks; empty if none.
std::string_view broken_rule(std::string_view part)
{
  if (part.empty()) {
    return "no empty part, no slash at the end";
  }
  if (is_digit(part.front())) {
    return "no part that starts with a digit";
  }
  if (part.find("__") != std::string_view::npos) {
    return "no double underscore";
  }
  const auto allowed = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  if (!std::all_of(part.begin(), part.end(), allowed)) {
    return "only letters, digits and underscores between slashes";
  }
  return {};
}

[[noreturn]] void refuse(std::string_view what, std::string_view name, std::string_view accepted)
{
  throw NameError(std::string(what), std::string(name), std::string(accepted));
}

/// Checks "/a/b".
void check_absolute(std::string_view what, std::string_view name)
{
  if (name.empty() || name.front() != '/') {
    refuse(what, name, "a name that starts with a slash");
  }
  if (name.size() > kLongestTopic) {
    refuse(what, name, "at most 247 characters");
  }
  for (std::size_t begin = 1; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (const auto rule = broken_rule(name.substr(begin, end - begin)); !rule.empty()) {
      refuse(what, name, rule);
    }
    begin = end + 1;
  }
}

std::string join(const std::string & ns, std::string_view name)
{
  return (ns == "/" ? "" : ns) + "/" + std::string(name);
}

std::string expand(std::string_view topic, const NodeName & node)
{
  if (topic.empty()) {
    refuse("topic", topic, "a name");
  }
  std::string name;
  if (topic.front() == '/') {
    name = topic;
  } else if (topic.substr(0, 2) == "~/") {
    name = join(node.full(), topic.substr(2));
  } else {
    name = join(node.ns, topic);
  }
  check_absolute("topic", name);
  return name;
}

}  // namespace

NameError::NameError(std::string of_kind, std::string name, std::string rule)
: std::invalid_argument(of_kind + " '" + name + "': accepted is " + rule),
  kind(std::move(of_kind)),
  value(std::move(name)),
  accepted(std::move(rule))
{
}

std::string NodeName::full() const { return join(ns, name); }

void validate(const NodeName & node)
{
  if (node.ns != "/") {
    check_absolute("namespace", node.ns);
  }
  if (const auto rule = broken_rule(node.name); !rule.empty()) {
    refuse("node name", node.name, rule);
  }
  if (node.name.size() > kLongestNodeName) {
    refuse("node name", node.name, "at most 255 characters");
  }
}

std::string resolve_topic(
  std::string_view topic, const NodeName & node, const std::vector<Remapping> & remappings)
{
  const std::string name = expand(topic, node);
  for (const auto & remapping : remappings) {
    if (expand(remapping.from, node) == name) {
      return expand(remapping.to, node);
    }
  }
  return name;
}

std::string dds_topic_name(std::string_view absolute_topic)
{
  return "rt" + std::string(absolute_topic);
}

}  // namespace stetro_dds
