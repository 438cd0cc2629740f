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

#include "stetro_config/report.hpp"

#include <cstddef>
#include <set>

namespace stetro_config
{
namespace
{

/// Writes the fields whose names start with `group` as a block map; each group once, where its
/// first field stands.
void write_group(
  const std::vector<Field> & fields, const std::string & group, int indent, std::string & out)
{
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::set<std::string> written;
  for (const Field & field : fields) {
    if (field.name.compare(0, group.size(), group) != 0) {
      continue;
    }
    const std::string rest = field.name.substr(group.size());
    const std::size_t dot = rest.find('.');
    const std::string key = rest.substr(0, dot);
    if (dot == std::string::npos) {
      out += margin + key + ": " + to_yaml(field.get()) + "  # " + field.meaning + "\n";
    } else if (written.insert(key).second) {
      out += margin + key + ":\n";
      write_group(fields, group + key + ".", indent + 2, out);
    }
  }
}

/// A table cell: `|` would end it.
std::string cell(const std::string & text)
{
  std::string escaped;
  for (const char c : text) {
    escaped += c == '|' ? "\\|" : std::string(1, c);
  }
  return escaped;
}

}  // namespace

std::string to_yaml(const std::vector<Field> & fields, int indent)
{
  std::string out;
  write_group(fields, "", indent, out);
  return out;
}

std::string reference_table(const std::vector<Field> & fields)
{
  std::string table = "| name | type | default | accepted | meaning |\n|---|---|---|---|---|\n";
  for (const Field & field : fields) {
    const std::string limits = field.limits.empty() ? "any" : field.limits;
    table += "| `" + field.name + "` | " + to_string(field.kind) + " | `" +
             cell(to_yaml(field.get())) + "` | " + cell(limits) + " | " + cell(field.meaning) +
             " |\n";
  }
  return table;
}

}  // namespace stetro_config
