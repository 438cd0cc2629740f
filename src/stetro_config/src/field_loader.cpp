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

#include "stetro_config/field_loader.hpp"

#include <algorithm>
#include <utility>

#include "stetro_config/suggestion.hpp"
#include "stetro_config/yaml_file.hpp"

namespace stetro_config
{
namespace
{

constexpr char kDefault[] = "default";

std::string joined(const std::vector<std::string> & names)
{
  std::string text;
  for (const std::string & name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

void FieldLoader::read_file(const std::string & path)
{
  if (const auto root = read_yaml_file(path, faults_)) {
    read_map(*root, path);
  }
}

void FieldLoader::read_map(const YAML::Node & map, const std::string & file)
{
  if (!map.IsMap()) {
    refuse({file, line_of(map)}, "", excerpt(map), "a map of parameters");
    return;
  }
  Seen seen;
  descend(map, file, "", seen);
}

// Goes down only where a declared name does, so neither depth nor a node that contains itself
// through an alias can lead astray.
void FieldLoader::descend(
  const YAML::Node & map, const std::string & file, const std::string & group, Seen & seen)
{
  for (const auto & entry : map) {
    const YAML::Node & key = entry.first;
    const YAML::Node & node = entry.second;
    const Origin at{file, line_of(key)};
    if (!key.IsScalar() || key.Scalar() == "<<") {
      refuse(at, group, key.IsScalar() ? "<<" : excerpt(key), "plain keys, without merging");
      continue;
    }
    const std::string name = group.empty() ? key.Scalar() : group + "." + key.Scalar();
    const auto [first, fresh] = seen.emplace(name, at.line);
    if (!fresh) {
      refuse(at, name, excerpt(node), "once only; first on line " + std::to_string(first->second));
      continue;
    }
    const auto below = names_under(name);
    if (const auto other = left_out_.find(name); other != left_out_.end()) {
      other->second.reset(node);
    } else if (find(name)) {
      take(name, node, at);
    } else if (!below.empty() && node.IsMap()) {
      descend(node, file, name, seen);
    } else if (!below.empty()) {
      refuse(at, name, excerpt(node), "a map: " + joined(below));
    } else {
      std::vector<std::string> known;
      std::transform(
        fields_.begin(), fields_.end(), std::back_inserter(known),
        [](const Field & field) { return field.name; });
      refuse(at, name, excerpt(node), suggest(name, known));
    }
  }
}

void FieldLoader::set(
  const std::string & name, const std::string & text, const std::string & source)
{
  // Through a one-line map, so that text means here exactly what it means in a file.
  try {
    YAML::Node map;
    map[name] = YAML::Load(text);
    read_map(map, source);
  } catch (const YAML::Exception & error) {
    refuse({source, 0}, name, text, "well-formed YAML (" + error.msg + ")");
  }
}

void FieldLoader::take(const std::string & name, const YAML::Node & node, const Origin & at)
{
  const Field & field = *find(name);
  const auto value = parse(node, field.kind);
  if (!value || !field.assign(*value)) {
    refuse(at, name, excerpt(node), field.accepted);
  }
  origins_[name] = at;
}

void FieldLoader::require_every_name(const std::string & file)
{
  for (const Field & field : fields_) {
    if (origins_.count(field.name) == 0) {
      refuse({file, 0}, field.name, kMissing, field.accepted);
    }
  }
}

void FieldLoader::check_values()
{
  for (const Field & field : fields_) {
    const Value value = field.get();
    if (!field.accepts(value)) {
      refuse(origin(field.name), field.name, to_yaml(value), field.accepted);
    }
  }
}

void FieldLoader::add_located(const Faults & found)
{
  for (const Fault & fault : found) {
    Fault located = fault;
    if (located.file.empty()) {
      const Origin at = origin(fault.name);
      located.file = at.file;
      located.line = at.line;
    }
    faults_.add(std::move(located));
  }
}

Origin FieldLoader::origin(const std::string & name) const
{
  const auto found = origins_.find(name);
  return found == origins_.end() ? Origin{kDefault, 0} : found->second;
}

const Field * FieldLoader::find(const std::string & name) const
{
  const auto found = std::find_if(
    fields_.begin(), fields_.end(), [&](const Field & field) { return field.name == name; });
  return found == fields_.end() ? nullptr : &*found;
}

std::vector<std::string> FieldLoader::names_under(const std::string & group) const
{
  std::vector<std::string> names;
  for (const Field & field : fields_) {
    if (field.name.compare(0, group.size() + 1, group + ".") == 0) {
      names.push_back(field.name);
    }
  }
  return names;
}

void FieldLoader::refuse(
  const Origin & at, std::string name, std::string value, std::string accepted)
{
  faults_.add({at.file, at.line, std::move(name), std::move(value), std::move(accepted)});
}

}  // namespace stetro_config
