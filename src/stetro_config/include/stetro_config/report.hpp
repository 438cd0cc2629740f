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

#ifndef STETRO_CONFIG__REPORT_HPP_
#define STETRO_CONFIG__REPORT_HPP_

#include <string>
#include <vector>

#include "stetro_config/field.hpp"

namespace stetro_config
{

/// The values in force as YAML that loads back to the same values, indented by `indent` spaces.
[[nodiscard]] std::string to_yaml(const std::vector<Field> & fields, int indent = 0);

/// A markdown table: name, type, value (the default, for a fresh struct), accepted, meaning.
[[nodiscard]] std::string reference_table(const std::vector<Field> & fields);

/// The values in force as YAML.
template <class Params>
[[nodiscard]] std::string to_yaml(Params params, int indent = 0)
{
  return to_yaml(fields_of(params), indent);
}

/// The markdown table of a struct's parameters with its defaults.
template <class Params>
[[nodiscard]] std::string reference_table()
{
  Params params;
  return reference_table(fields_of(params));
}

}  // namespace stetro_config

#endif  // STETRO_CONFIG__REPORT_HPP_
