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

#ifndef STETRO_DDS__ROS_ARGUMENTS_HPP_
#define STETRO_DDS__ROS_ARGUMENTS_HPP_

#include <optional>
#include <string>
#include <vector>

#include "stetro_dds/topic_name.hpp"

namespace stetro_dds
{

/// One `-p [node:]name:=value`.
struct ParameterOverride
{
  std::string node;  ///< name or full name of the node meant; empty for every node
  std::string name;
  std::string value;  ///< YAML text
};

/// One `-r [node:]from:=to`; `from` may be `__ns` or `__node`.
struct NodeRemapping
{
  std::string node;  ///< empty for every node
  Remapping rule;
};

/// What a ROS 2 command line says: everything between `--ros-args` and `--` or the end.
struct RosArguments
{
  std::vector<std::string> params_files{};
  std::vector<ParameterOverride> overrides{};
  std::vector<NodeRemapping> remappings{};
  std::string log_level = "info";     ///< debug, info, warn, error or fatal
  std::vector<std::string> others{};  ///< what is no ROS argument, program name first

  /// \throws stetro_config::ConfigError with every argument that is not understood
  static RosArguments parse(int argc, const char * const * argv);
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__ROS_ARGUMENTS_HPP_
