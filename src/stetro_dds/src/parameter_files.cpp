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
#include <map>
#include <string>
#include <utility>
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

/// Goes down the namespaces of one file to its sections.
class SectionFinder
{
public:
  SectionFinder(
    std::string file, stetro_config::Faults & faults, std::vector<ParameterSection> & found)
  : file_(std::move(file)), faults_(faults), found_(found)
  {
  }

  /// \param name of the map, its namespaces included; empty for the file's root \param line of it
  void descend(const YAML::Node & map, const std::string & name, int line)
  {
    for (const auto & entry : map) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      const int key_line = stetro_config::line_of(entry.first);
      const YAML::Node & value = entry.second;
      if (key == kParameters && !name.empty()) {
        if (value.IsMap()) {
          take(name, value, line);
        } else if (!value.IsNull()) {
          refuse(key_line, key, value, "a map of parameters");
        }
      } else if (value.IsMap() && key != kParameters && depth_of(name) < kDeepestName) {
        descend(value, name + (key.substr(0, 1) == "/" ? "" : "/") + key, key_line);
      } else {
        refuse(key_line, name + "/" + key, value, "a node's name with ros__parameters below it");
      }
    }
  }

private:
  void take(const std::string & name, const YAML::Node & parameters, int line)
  {
    const auto [first, fresh] = line_of_.emplace(name, line);
    if (fresh) {
      found_.push_back({name, parameters, {file_, line}});
    } else {
      const std::string place = "first on line " + std::to_string(first->second);
      refuse(line, name, parameters, "once only in a file; " + place);
    }
  }

  void refuse(
    int line, const std::string & name, const YAML::Node & value, const std::string & accepted)
  {
    faults_.add({file_, line, name, stetro_config::excerpt(value), accepted});
  }

  const std::string file_;
  stetro_config::Faults & faults_;
  std::vector<ParameterSection> & found_;
  std::map<std::string, int> line_of_;  // of the sections found, by their name
};

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
      SectionFinder(path, faults, sections_).descend(*root, "", 0);
    }
  }
}

void ParameterFiles::each_section(
  const std::string & full_name, stetro_config::Faults & faults,
  const std::function<void(const YAML::Node & map, const std::string & file)> & visit_section) const
{
  for (const auto & section : sections_) {
    if (addresses(section.pattern, full_name)) {
      visit_section(section.parameters, section.origin.file);
    } else if (forgets_namespace(section.pattern, full_name)) {
      faults.add(
        {section.origin.file, section.origin.line, kParameters, "for " + section.pattern,
         full_name + " or /**" + section.pattern});
    }
  }
}

std::vector<ParameterSection> ParameterFiles::sections_for_none_of(
  const std::vector<std::string> & full_names) const
{
  std::vector<ParameterSection> strays;
  for (const auto & section : sections_) {
    const bool concerns_us =
      std::any_of(full_names.begin(), full_names.end(), [&section](const std::string & name) {
        return addresses(section.pattern, name) || forgets_namespace(section.pattern, name);
      });
    if (!concerns_us) {
      strays.push_back(section);
    }
  }
  return strays;
}

}  // namespace stetro_dds
