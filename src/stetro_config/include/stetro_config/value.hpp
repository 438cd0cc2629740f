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

#ifndef STETRO_CONFIG__VALUE_HPP_
#define STETRO_CONFIG__VALUE_HPP_

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace stetro_config
{

/// A value of one of the six types a person can write. The order is that of `Kind`.
using Value = std::variant<
  bool, std::int64_t, double, std::string, std::vector<double>, std::vector<std::string>>;

enum class Kind { kBool, kInt, kDouble, kString, kDoubles, kStrings };

/// The kind that holds a `T`; compiles for the six types only.
template <class T>
[[nodiscard]] constexpr Kind kind_of()
{
  if constexpr (std::is_same_v<T, bool>) {
    return Kind::kBool;
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return Kind::kInt;
  } else if constexpr (std::is_same_v<T, double>) {
    return Kind::kDouble;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return Kind::kString;
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    return Kind::kDoubles;
  } else {
    static_assert(
      std::is_same_v<T, std::vector<std::string>>,
      "a field is bool, std::int64_t, double, std::string or a std::vector of the last two");
    return Kind::kStrings;
  }
}

/// Short name of a kind for tables: `double`, `list of strings`.
[[nodiscard]] std::string to_string(Kind kind);

/// What a kind accepts, for a fault: "a finite number".
[[nodiscard]] std::string describe(Kind kind);

/// Reads a node as one kind, strictly. Nothing if it is not written as that kind.
/**
 *  - bool: `true` or `false` (also `True`, `TRUE`, ...); not yes, on or 1
 *  - int: a decimal that fits 64 bits; not 3.0, 010 or 0x10
 *  - double: finite; an integer only if the double equals it exactly; not .nan, .inf or 1e999
 *  - string: quoted, or plain text that is no bool, number or null
 *  - lists: a sequence of which every element is accepted by the above
 */
[[nodiscard]] std::optional<Value> parse(const YAML::Node & node, Kind kind);

/// What a person wrote at a node, short enough for a fault: the scalar, "null", "a map", "a list".
[[nodiscard]] std::string excerpt(const YAML::Node & node);

/// The YAML that `parse` reads back as the same value. Doubles take the shortest exact form.
[[nodiscard]] std::string to_yaml(const Value & value);

/// The shortest text that reads back as the same double, e.g. `0.14`.
[[nodiscard]] std::string to_text(double number);

/// False if a number in the value is NaN or infinite.
[[nodiscard]] bool is_finite(const Value & value);

}  // namespace stetro_config

#endif  // STETRO_CONFIG__VALUE_HPP_
