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

#include "stetro_config/field.hpp"

#include <stdexcept>

namespace stetro_config
{
namespace
{

bool is_group_of(const std::string & group, const std::string & name)
{
  return name.size() > group.size() && name.compare(0, group.size(), group) == 0 &&
         name[group.size()] == '.';
}

}  // namespace

void FieldCollector::add(Field field)
{
  for (const Field & other : fields_) {
    if (
      other.name == field.name || is_group_of(other.name, field.name) ||
      is_group_of(field.name, other.name)) {
      throw std::logic_error(
        "parameter " + field.name + " declared beside " + other.name + ": names must be apart");
    }
  }
  fields_.push_back(std::move(field));
}

}  // namespace stetro_config
