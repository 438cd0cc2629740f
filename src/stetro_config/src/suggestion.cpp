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

#include "stetro_config/suggestion.hpp"

#include <algorithm>

namespace stetro_config
{
namespace
{

std::string last_part(const std::string & name)
{
  return name.substr(name.rfind('.') + 1);  // npos + 1 is 0: the whole name
}

std::string enumeration(const std::vector<std::string> & known)
{
  constexpr std::size_t kMost = 12;
  std::string text = "a known key:";
  for (std::size_t i = 0; i < std::min(known.size(), kMost); ++i) {
    text += (i == 0 ? " " : ", ") + known[i];
  }
  return known.size() > kMost ? text + ", ..." : text;
}

}  // namespace

std::size_t keystrokes_between(const std::string & a, const std::string & b)
{
  std::vector<std::size_t> before(b.size() + 1);  // row i - 2
  std::vector<std::size_t> above(b.size() + 1);   // row i - 1
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

std::string suggest(const std::string & written, const std::vector<std::string> & known)
{
  if (known.empty()) {
    return "no key at all";
  }
  constexpr std::size_t kLongest = 200;  // the distance costs the product of the lengths
  std::size_t best = std::max<std::size_t>(2, written.size() / 3) + 1;
  const std::string * nearest = nullptr;
  for (const std::string & name : known) {
    const std::size_t strokes = written.size() > kLongest
                                  ? best
                                  : std::min(
                                      keystrokes_between(written, name),
                                      keystrokes_between(last_part(written), last_part(name)) + 1);
    if (strokes < best) {
      best = strokes;
      nearest = &name;
    }
  }
  return nearest ? "a known key; did you mean " + *nearest + "?" : enumeration(known);
}

}  // namespace stetro_config
