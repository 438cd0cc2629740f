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

#include "stetro_config/fault.hpp"

#include <algorithm>
#include <ostream>
#include <tuple>
#include <utility>

namespace stetro_config
{
namespace
{

std::string listing(const std::vector<Fault> & faults)
{
  std::string text = std::to_string(faults.size());
  text += faults.size() == 1 ? " fault in the configuration:" : " faults in the configuration:";
  for (const Fault & fault : faults) {
    text += "\n  " + to_string(fault);
  }
  return text;
}

}  // namespace

std::string to_string(const Fault & fault)
{
  std::string text;
  if (!fault.file.empty()) {
    text += fault.file + (fault.line > 0 ? ":" + std::to_string(fault.line) : "") + ": ";
  }
  if (!fault.name.empty()) {
    text += fault.name + ": ";
  }
  text += fault.value == kMissing ? std::string{"missing"} : "value '" + fault.value + "' refused";
  return text + ", accepted: " + fault.accepted;
}

std::ostream & operator<<(std::ostream & out, const Fault & fault)
{
  return out << to_string(fault);
}

ConfigError::ConfigError(std::vector<Fault> faults)
: std::runtime_error(listing(faults)), faults_(std::move(faults))
{
}

void Faults::refuse(std::string name, std::string value, std::string accepted)
{
  add({"", 0, std::move(name), std::move(value), std::move(accepted)});
}

void Faults::throw_if_any() const
{
  if (faults_.empty()) {
    return;
  }
  auto ordered = faults_;
  std::stable_sort(ordered.begin(), ordered.end(), [](const Fault & a, const Fault & b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  throw ConfigError(std::move(ordered));
}

}  // namespace stetro_config
