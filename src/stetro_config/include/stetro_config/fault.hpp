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

#ifndef STETRO_CONFIG__FAULT_HPP_
#define STETRO_CONFIG__FAULT_HPP_

#include <cstddef>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stetro_config
{

/// What stands in `Fault::value` when nothing was written where something is needed.
constexpr char kMissing[] = "(missing)";

/// Where something was written.
struct Origin
{
  std::string file;  ///< as given by the person, or "command line"
  int line = 0;      ///< counted from 1; 0 when a line means nothing
};

/// One thing a person wrote that cannot be used, and what could be.
struct Fault
{
  std::string file;      ///< file it stands in; empty until it is known
  int line = 0;          ///< counted from 1; 0 when a line means nothing
  std::string name;      ///< dotted path of the key, e.g. `flights[0].riser_m`
  std::string value;     ///< what was written, or `kMissing`
  std::string accepted;  ///< what would be accepted, in words
};

/// `file:line: name: value 'x' refused, accepted: ...`, without the parts that are empty.
[[nodiscard]] std::string to_string(const Fault & fault);
std::ostream & operator<<(std::ostream & out, const Fault & fault);

/// Everything wrong with a configuration, thrown once. `what()` has a line for each fault.
class ConfigError : public std::runtime_error
{
public:
  explicit ConfigError(std::vector<Fault> faults);
  [[nodiscard]] const std::vector<Fault> & faults() const noexcept { return faults_; }

private:
  std::vector<Fault> faults_;
};

/// Collects faults, so that a person sees all of them at once. Not for use from several threads.
class Faults
{
public:
  void add(Fault fault) { faults_.push_back(std::move(fault)); }

  /// Adds a fault whose place the loader fills in: for `check(const Params &, Faults &)`.
  void refuse(std::string name, std::string value, std::string accepted);

  [[nodiscard]] bool empty() const noexcept { return faults_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return faults_.size(); }
  [[nodiscard]] const Fault & operator[](std::size_t i) const { return faults_[i]; }
  [[nodiscard]] auto begin() const noexcept { return faults_.begin(); }
  [[nodiscard]] auto end() const noexcept { return faults_.end(); }

  /// \throws ConfigError with every fault, ordered by file and line, if there is any
  void throw_if_any() const;

private:
  std::vector<Fault> faults_;
};

}  // namespace stetro_config

#endif  // STETRO_CONFIG__FAULT_HPP_
