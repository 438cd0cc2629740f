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

#ifndef STETRO_CONFIG__YAML_FILE_HPP_
#define STETRO_CONFIG__YAML_FILE_HPP_

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "stetro_config/fault.hpp"

namespace stetro_config
{

/// Reads a file that holds one YAML document with a map at its root.
/**
 * A missing or unreadable file, malformed YAML, a second document or another root is a fault with
 * file and line. An empty file has no root and is refused; `{}` is an empty map. Anchors and
 * aliases are read; a node that is written once and used twice reports the line it is used on.
 *
 * \return nothing if a fault was added
 */
[[nodiscard]] std::optional<YAML::Node> read_yaml_file(const std::string & path, Faults & faults);

/// The same for a text, which `file` names in faults.
[[nodiscard]] std::optional<YAML::Node> read_yaml_text(
  const std::string & text, const std::string & file, Faults & faults);

/// The line of a node, counted from 1; 0 if it was not read from text.
[[nodiscard]] int line_of(const YAML::Node & node);

}  // namespace stetro_config

#endif  // STETRO_CONFIG__YAML_FILE_HPP_
