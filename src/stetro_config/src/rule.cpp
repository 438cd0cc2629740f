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

#include "stetro_config/rule.hpp"

namespace stetro_config
{

std::string OneOf::words() const
{
  std::string text = "one of";
  for (const std::string & choice : choices) {
    text += (&choice == &choices.front() ? " " : ", ") + choice;
  }
  return text;
}

bool Identifier::accepts(const std::string & value) const
{
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto is_tail = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !value.empty() && is_letter(value.front()) &&
         std::all_of(value.begin(), value.end(), is_tail);
}

std::string Identifier::words() const
{
  return "a lower-case letter, then lower-case letters, digits and _";
}

}  // namespace stetro_config
