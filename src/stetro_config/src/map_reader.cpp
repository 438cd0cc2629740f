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

#include "stetro_config/map_reader.hpp"

#include "stetro_config/suggestion.hpp"
#include "stetro_config/yaml_file.hpp"

namespace stetro_config
{

MapReader MapReader::from_file(const std::string & path, Faults & faults)
{
  MapReader reader{path, faults, nullptr};
  if (const auto root = read_yaml_file(path, faults)) {
    reader.open(*root, "", line_of(*root));
  }
  return reader;
}

MapReader MapReader::from_text(const std::string & text, const std::string & file, Faults & faults)
{
  MapReader reader{file, faults, nullptr};
  if (const auto root = read_yaml_text(text, file, faults)) {
    reader.open(*root, "", line_of(*root));
  }
  return reader;
}

MapReader::MapReader(std::string file, Faults & faults, std::shared_ptr<Soundness> above)
: file_(std::move(file)),
  faults_(&faults),
  soundness_(std::make_shared<Soundness>(Soundness{false, std::move(above)}))
{
}

void MapReader::add(int line, std::string name, std::string value, std::string accepted)
{
  for (Soundness * level = soundness_.get(); level; level = level->above.get()) {
    level->sound = false;
  }
  faults_->add({file_, line, std::move(name), std::move(value), std::move(accepted)});
}

void MapReader::open(const YAML::Node & map, std::string path, int line)
{
  path_ = std::move(path);
  line_ = line;
  absent_ = false;
  soundness_->sound = true;
  for (const auto & item : map) {
    const YAML::Node & key = item.first;
    const int at = line_of(key);
    if (!key.IsScalar() || key.Scalar() == "<<") {
      const std::string written = key.IsScalar() ? key.Scalar() : excerpt(key);
      add(at, path_, written, "plain keys, without merging");
      continue;
    }
    const auto [first, fresh] = entries_.emplace(key.Scalar(), Entry{item.second, at, false});
    if (!fresh) {
      add(
        at, name_of(key.Scalar()), excerpt(item.second),
        "once only; first on line " + std::to_string(first->second.line));
    }
  }
}

MapReader MapReader::child(const YAML::Node & node, const std::string & key, int line) const
{
  MapReader reader{file_, *faults_, soundness_};
  if (node.IsMap()) {
    reader.open(node, name_of(key), line);
  } else {
    reader.add(line, name_of(key), excerpt(node), "a map");
  }
  return reader;
}

const MapReader::Entry * MapReader::ask(
  const std::string & key, const std::string & accepted, bool must_be_there)
{
  const auto found = entries_.find(key);
  if (found != entries_.end()) {
    found->second.asked = true;
    return &found->second;
  }
  not_there_.insert(key);
  if (must_be_there && !absent_) {
    add(line_, name_of(key), kMissing, accepted);
  }
  return nullptr;
}

MapReader MapReader::require_map(const std::string & key)
{
  const Entry * entry = ask(key, "a map", true);
  return entry ? child(entry->node, key, entry->line) : MapReader{file_, *faults_, soundness_};
}

std::optional<MapReader> MapReader::find_map(const std::string & key)
{
  const Entry * entry = ask(key, "a map", false);
  return entry ? std::optional{child(entry->node, key, entry->line)} : std::nullopt;
}

std::vector<MapReader> MapReader::require_maps(const std::string & key) { return maps(key, true); }

std::vector<MapReader> MapReader::find_maps(const std::string & key) { return maps(key, false); }

std::vector<MapReader> MapReader::maps(const std::string & key, bool must_be_there)
{
  std::vector<MapReader> readers;
  const Entry * entry = ask(key, "a list of maps", must_be_there);
  if (!entry) {
    return readers;
  }
  if (!entry->node.IsSequence()) {
    refuse(key, excerpt(entry->node), "a list of maps");
    return readers;
  }
  for (const YAML::Node & item : entry->node) {
    const std::string index = "[" + std::to_string(readers.size()) + "]";
    readers.push_back(child(item, key + index, line_of(item)));
  }
  return readers;
}

YAML::Node MapReader::verbatim(const std::string & key)
{
  const Entry * entry = ask(key, "", false);
  return entry ? entry->node : YAML::Node{YAML::NodeType::Undefined};
}

std::vector<std::string> MapReader::keys() const
{
  std::vector<std::string> names;
  for (const auto & [key, entry] : entries_) {
    names.push_back(key);
  }
  return names;
}

void MapReader::refuse(const std::string & key, std::string value, std::string accepted)
{
  add(origin(key).line, name_of(key), std::move(value), std::move(accepted));
}

void MapReader::finish()
{
  std::vector<std::string> known{not_there_.begin(), not_there_.end()};
  for (const auto & [key, entry] : entries_) {
    if (entry.asked) {
      known.push_back(key);
    }
  }
  for (const auto & [key, entry] : entries_) {
    if (!entry.asked) {
      refuse(key, excerpt(entry.node), suggest(key, known));
    }
  }
}

std::string MapReader::name_of(const std::string & key) const
{
  return path_.empty() ? key : path_ + "." + key;
}

Origin MapReader::origin(const std::string & key) const
{
  const auto found = entries_.find(key);
  return {file_, found == entries_.end() ? line_ : found->second.line};
}

}  // namespace stetro_config
