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

#ifndef STETRO_DDS__PARAMETER_FILES_HPP_
#define STETRO_DDS__PARAMETER_FILES_HPP_

#include <yaml-cpp/yaml.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"

namespace stetro_dds
{

/// What a parameter file holds for the nodes of one pattern.
struct ParameterSection
{
  std::string pattern;  ///< "/**", "/stetro/driver"
  YAML::Node parameters;
  stetro_config::Origin origin;  ///< of the name above the parameters
};

/// Parameter files in the layout of ROS 2, addressed to nodes by name.
/**
 * Above the literal key `ros__parameters` stands the node's full name, in one key or nested by
 * namespace; `*` stands for one part of it, `**` for any number. A bare `driver:` means the node
 * `/driver`, as in ROS 2, and is refused if the process has a `driver` elsewhere, since it would
 * silently mean nobody. Sections for nodes of other processes are skipped: a name that is misspelt
 * looks just like them, so a program says which it skips.
 */
class ParameterFiles
{
public:
  /// Reads the files in order. A file that is not YAML in this layout, or has two sections of one
  /// name, adds faults.
  ParameterFiles(const std::vector<std::string> & paths, stetro_config::Faults & faults);

  /// Calls with each section's map that addresses the node, in the order written: the last wins.
  void each_section(
    const std::string & full_name, stetro_config::Faults & faults,
    const std::function<void(const YAML::Node & map, const std::string & file)> & visit_section)
    const;

  /// The sections that address none of these nodes, in the order written, without those that
  /// `each_section` refuses.
  [[nodiscard]] std::vector<ParameterSection> sections_for_none_of(
    const std::vector<std::string> & full_names) const;

private:
  std::vector<ParameterSection> sections_;
};

/// Whether a pattern such as `/**`, `/stetro/*` or `/stetro/driver` names the node.
bool addresses(const std::string & pattern, const std::string & full_name);

}  // namespace stetro_dds

#endif  // STETRO_DDS__PARAMETER_FILES_HPP_
