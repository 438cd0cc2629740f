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

#include "stetro_dds/ros_arguments.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "stetro_config/fault.hpp"

namespace stetro_dds
{

namespace
{

constexpr char kSource[] = "command line";

/// "node:name:=value" in its three parts.
struct Rule
{
  std::string node;
  std::string left;
  std::string right;
};

std::optional<Rule> parse_rule(const std::string & text)
{
  const auto assign = text.find(":=");
  if (assign == std::string::npos || assign == 0) {
    return std::nullopt;
  }
  Rule rule{"", text.substr(0, assign), text.substr(assign + 2)};
  if (const auto colon = rule.left.find(':'); colon != std::string::npos) {
    rule.node = rule.left.substr(0, colon);
    rule.left.erase(0, colon + 1);
  }
  return rule.left.empty() ? std::nullopt : std::optional<Rule>{rule};
}

/// One pass over the words of a command line.
class Parser
{
public:
  Parser(int argc, const char * const * argv) : words_(argv, argv + argc) {}

  RosArguments parse()
  {
    bool in_ros_args = false;
    while (next_ < words_.size()) {
      const std::string word = words_[next_++];
      if (word == "--ros-args") {
        in_ros_args = true;
      } else if (in_ros_args && word == "--") {
        in_ros_args = false;
      } else if (in_ros_args) {
        take(word);
      } else {
        result_.others.push_back(word);
      }
    }
    faults_.throw_if_any();
    return std::move(result_);
  }

private:
  void take(const std::string & option)
  {
    if (option == "--params-file") {
      if (const auto file = value_of(option, "a file name")) {
        result_.params_files.push_back(*file);
      }
    } else if (option == "-p" || option == "--param") {
      if (const auto rule = rule_of(option, "[node:]name:=value")) {
        result_.overrides.push_back({rule->node, rule->left, rule->right});
      }
    } else if (option == "-r" || option == "--remap") {
      if (const auto rule = rule_of(option, "[node:]from:=to")) {
        result_.remappings.push_back({rule->node, {rule->left, rule->right}});
      }
    } else if (option == "--log-level") {
      take_log_level();
    } else {
      refuse("--ros-args", option, "--params-file, -p, -r, --log-level, or -- to end them");
    }
  }

  void take_log_level()
  {
    constexpr char kLevels[] = "debug, info, warn, error or fatal";
    const auto level = value_of("--log-level", kLevels);
    constexpr std::array<const char *, 5> kKnown{"debug", "info", "warn", "error", "fatal"};
    if (level && std::find(kKnown.begin(), kKnown.end(), *level) == kKnown.end()) {
      refuse("--log-level", *level, kLevels);
    } else if (level) {
      result_.log_level = *level;
    }
  }

  std::optional<Rule> rule_of(const std::string & option, const std::string & accepted)
  {
    const auto text = value_of(option, accepted);
    if (!text) {
      return std::nullopt;
    }
    auto rule = parse_rule(*text);
    if (!rule) {
      refuse(option, *text, accepted);
    }
    return rule;
  }

  std::optional<std::string> value_of(const std::string & option, const std::string & accepted)
  {
    if (next_ == words_.size()) {
      refuse(option, stetro_config::kMissing, accepted);
      return std::nullopt;
    }
    return words_[next_++];
  }

  void refuse(const std::string & name, const std::string & value, const std::string & accepted)
  {
    faults_.add({kSource, 0, name, value, accepted});
  }

  const std::vector<std::string> words_;
  std::size_t next_ = 0;
  RosArguments result_;
  stetro_config::Faults faults_;
};

}  // namespace

RosArguments RosArguments::parse(int argc, const char * const * argv)
{
  return Parser(argc, argv).parse();
}

}  // namespace stetro_dds
