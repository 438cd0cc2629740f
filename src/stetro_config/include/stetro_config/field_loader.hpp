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

#ifndef STETRO_CONFIG__FIELD_LOADER_HPP_
#define STETRO_CONFIG__FIELD_LOADER_HPP_

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"

namespace stetro_config
{

/// Assigns fields from YAML and from text, remembering who wrote what. `Loader` is its typed face.
class FieldLoader
{
public:
  explicit FieldLoader(std::vector<Field> fields) : fields_(std::move(fields)) {}

  void read_map(const YAML::Node & map, const std::string & file);
  void read_file(const std::string & path);
  void set(const std::string & name, const std::string & text, const std::string & source);

  /// Leaves what stands under a name for another reader, who gets it from `left_out`.
  void leave_out(const std::string & name) { left_out_.emplace(name, YAML::Node{}); }
  /// What stands under a name that was left out; null if nothing does.
  [[nodiscard]] YAML::Node left_out(const std::string & name) const { return left_out_.at(name); }

  /// Adds a fault for every name that nobody wrote.
  void require_every_name(const std::string & file);

  /// Adds a fault for every value in force that its own rule refuses: a default gone astray.
  void check_values();

  /// Adds faults found by name only, with the place where the name was written.
  void add_located(const Faults & found);

  [[nodiscard]] const std::vector<Field> & fields() const noexcept { return fields_; }
  [[nodiscard]] const Faults & faults() const noexcept { return faults_; }

  /// Where the value in force was written; file "default" if nobody wrote it.
  [[nodiscard]] Origin origin(const std::string & name) const;

private:
  /// What one map may hold only once, and where it was first: names of this reading.
  using Seen = std::map<std::string, int>;

  void descend(
    const YAML::Node & map, const std::string & file, const std::string & group, Seen & seen);
  void take(const std::string & name, const YAML::Node & node, const Origin & at);
  [[nodiscard]] const Field * find(const std::string & name) const;
  [[nodiscard]] std::vector<std::string> names_under(const std::string & group) const;
  void refuse(const Origin & at, std::string name, std::string value, std::string accepted);

  std::vector<Field> fields_;
  std::map<std::string, Origin> origins_;
  std::map<std::string, YAML::Node> left_out_;
  Faults faults_;
};

}  // namespace stetro_config

#endif  // STETRO_CONFIG__FIELD_LOADER_HPP_
