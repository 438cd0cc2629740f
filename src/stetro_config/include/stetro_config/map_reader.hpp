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

#ifndef STETRO_CONFIG__MAP_READER_HPP_
#define STETRO_CONFIG__MAP_READER_HPP_

#include <yaml-cpp/yaml.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_config/value.hpp"

namespace stetro_config
{

/// Reads one YAML map of a structured file, key by key, and misses nothing.
/**
 *   Faults faults;
 *   MapReader site = MapReader::from_file("site.yaml", faults);
 *   const auto name = site.require<std::string>("name", Identifier{});
 *   for (MapReader & flight : site.require_maps("flights")) {
 *     const auto riser_m = flight.require<double>("riser_m", Within{0.05, 0.25});
 *     flight.finish();
 *   }
 *   site.finish();
 *   faults.throw_if_any();
 *
 * A key that is missing, of the wrong type or refused by its rule adds a fault with file and line
 * and reads as `T{}`, so that reading goes on and finds the next fault; `sound()` tells whether to
 * trust what was read. Each key that is asked for is known; `finish()` refuses all others.
 * Faults must outlive the reader. A copy counts its own keys.
 */
class MapReader
{
public:
  /// Reads the file's root map. On a fault the reader is absent.
  [[nodiscard]] static MapReader from_file(const std::string & path, Faults & faults);

  /// The same for a text that `file` names in faults.
  [[nodiscard]] static MapReader from_text(
    const std::string & text, const std::string & file, Faults & faults);

  /// The value of a key that must be there; `T{}` after a fault.
  template <class T, class Rule>
  [[nodiscard]] T require(const std::string & key, const Rule & rule)
  {
    return read<T>(key, rule, true).value_or(T{});
  }

  /// The value of a key, or `otherwise` if the key is not there; `T{}` after a fault.
  template <class T, class Rule>
  [[nodiscard]] T optional(const std::string & key, T otherwise, const Rule & rule)
  {
    auto value = read<T>(key, rule, false);
    return has(key) ? std::move(value).value_or(T{}) : std::move(otherwise);
  }

  /// The value of a key, or nothing if the key is not there or after a fault.
  template <class T, class Rule>
  [[nodiscard]] std::optional<T> find(const std::string & key, const Rule & rule)
  {
    return read<T>(key, rule, false);
  }

  /// The map under a key; absent after a fault.
  [[nodiscard]] MapReader require_map(const std::string & key);
  [[nodiscard]] std::optional<MapReader> find_map(const std::string & key);

  /// The maps of a sequence under a key, named `key[0]`, `key[1]`, ...; empty after a fault.
  [[nodiscard]] std::vector<MapReader> require_maps(const std::string & key);
  /// The same, empty also when the key is not there.
  [[nodiscard]] std::vector<MapReader> find_maps(const std::string & key);

  /// The node under a key as it stands, for another reader to judge; undefined if not there.
  [[nodiscard]] YAML::Node verbatim(const std::string & key);

  /// Whether the map has the key. Does not make the key known.
  [[nodiscard]] bool has(const std::string & key) const { return entries_.count(key) > 0; }
  /// The keys of the map, sorted, for maps whose keys are a person's choice.
  [[nodiscard]] std::vector<std::string> keys() const;

  /// Adds a fault at a key of this map, or at the map itself for a key that is not there.
  void refuse(const std::string & key, std::string value, std::string accepted);

  /// Adds a fault for every key that nobody asked for.
  void finish();

  /// True if the map is there and neither it nor a map below it has had a fault.
  [[nodiscard]] bool sound() const { return soundness_->sound; }

  /// The dotted path of a key, as faults name it.
  [[nodiscard]] std::string name_of(const std::string & key) const;
  /// Where a key stands; the map's own place for a key that is not there.
  [[nodiscard]] Origin origin(const std::string & key) const;
  /// Where the map begins.
  [[nodiscard]] Origin origin() const { return {file_, line_}; }

private:
  struct Entry
  {
    YAML::Node node;
    int line;
    bool asked;
  };

  /// Shared by the copies of a reader; a fault below spoils all above.
  struct Soundness
  {
    bool sound;
    std::shared_ptr<Soundness> above;
  };

  MapReader(std::string file, Faults & faults, std::shared_ptr<Soundness> above);
  void open(const YAML::Node & map, std::string path, int line);
  void add(int line, std::string name, std::string value, std::string accepted);
  [[nodiscard]] MapReader child(const YAML::Node & node, const std::string & key, int line) const;
  /// The entry of a key, now known; a fault and nothing if it must be there and is not.
  [[nodiscard]] const Entry * ask(
    const std::string & key, const std::string & accepted, bool must_be_there);
  [[nodiscard]] std::vector<MapReader> maps(const std::string & key, bool must_be_there);

  template <class T, class Rule>
  [[nodiscard]] std::optional<T> read(
    const std::string & key, const Rule & rule, bool must_be_there)
  {
    const std::string accepted = accepted_words(kind_of<T>(), rule);
    const Entry * entry = ask(key, accepted, must_be_there);
    if (!entry) {
      return std::nullopt;
    }
    const auto value = parse(entry->node, kind_of<T>());
    if (!value || !rule.accepts(std::get<T>(*value))) {
      refuse(key, excerpt(entry->node), accepted);
      return std::nullopt;
    }
    return std::get<T>(*value);
  }

  std::string file_;
  std::string path_;
  int line_ = 0;
  Faults * faults_;
  std::shared_ptr<Soundness> soundness_;
  bool absent_ = true;  ///< there is no map: a fault already says so, and nothing else is missing
  std::map<std::string, Entry> entries_;
  std::set<std::string> not_there_;  ///< asked for, so known, but not written
};

}  // namespace stetro_config

#endif  // STETRO_CONFIG__MAP_READER_HPP_
