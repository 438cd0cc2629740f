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

#include "stetro_dds/parameter_files.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stetro_config/value.hpp"
#include "stetro_config/yaml_file.hpp"

namespace stetro_dds
{

namespace
{

constexpr char kParameters[] = "ros__parameters";
constexpr std::ptrdiff_t kDeepestName = 32;  // an alias of its own map nests for ever

std::ptrdiff_t depth_of(const std::string & name)
{
  return std::count(name.begin(), name.end(), '/');
}

/// "/a/b" as {"a", "b"}.
std::vector<std::string> parts_of(const std::string & name)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 1; begin < name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

using Part = std::vector<std::string>::const_iterator;

bool matches(Part pattern, Part pattern_end, Part name, Part name_end)
{
  if (pattern == pattern_end) {
    return name == name_end;
  }
  if (*pattern == "**") {
    return matches(pattern + 1, pattern_end, name, name_end) ||
           (name != name_end && matches(pattern, pattern_end, name + 1, name_end));
  }
  return name != name_end && (*pattern == "*" || *pattern == *name) &&
         matches(pattern + 1, pattern_end, name + 1, name_end);
}

/// `driver:` for a node that is `/stetro/driver`: means /driver, and would be lost in silence.
bool forgets_namespace(const std::string & pattern, const std::string & full_name)
{
  const auto of_pattern = parts_of(pattern);
  const auto of_name = parts_of(full_name);
  return of_pattern.size() == 1 && of_name.size() > 1 && of_pattern.front() == of_name.back();
}

}  // namespace

bool addresses(const std::string & pattern, const std::string & full_name)
{
  const auto of_pattern = parts_of(pattern);
  const auto of_name = parts_of(full_name);
  return matches(of_pattern.begin(), of_pattern.end(), of_name.begin(), of_name.end());
}

ParameterFiles::ParameterFiles(
  const std::vector<std::string> & paths, stetro_config::Faults & faults)
{
  for (const auto & path : paths) {
    if (const auto root = stetro_config::read_yaml_file(path, faults)) {
      collect(*root, "", path, faults);
    }
  }
}

void ParameterFiles::collect(
  const YAML::Node & map, const std::string & prefix, const std::string & file,
  stetro_config::Faults & faults)
{
  for (const auto & entry : map) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const int line = stetro_config::line_of(entry.first);
    const YAML::Node & value = entry.second;
    if (key == kParameters && !prefix.empty()) {
      if (value.IsMap()) {
        sections_.push_back({prefix, value, file, line});
      } else if (!value.IsNull()) {
        faults.add({file, line, key, stetro_config::excerpt(value), "a map of parameters"});
      }
    } else if (value.IsMap() && key != kParameters && depth_of(prefix) < kDeepestName) {
      collect(value, prefix + (key.substr(0, 1) == "/" ? "" : "/") + key, file, faults);
    } else {
      faults.add(
        {file, line, prefix + "/" + key, stetro_config::excerpt(value),
         "a node's name with ros__parameters below it"});
    }
  }
}

void ParameterFiles::each_section(
  const std::string & full_name, stetro_config::Faults & faults,
  const std::function<void(const YAML::Node & map, const std::string & file)> & visit_section) const
{
  for (const auto & section : sections_) {
    if (addresses(section.pattern, full_name)) {
      visit_section(section.parameters, section.file);
    } else if (forgets_namespace(section.pattern, full_name)) {
      faults.add(
        {section.file, section.line, kParameters, "for " + section.pattern,
         full_name + " or /**" + section.pattern});
    }
  }
}

}  // namespace stetro_dds
