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

#ifndef STETRO_CONFIG__SUGGESTION_HPP_
#define STETRO_CONFIG__SUGGESTION_HPP_

#include <cstddef>
#include <string>
#include <vector>

namespace stetro_config
{

/// Keystrokes that turn one word into another.
/**
 * Insertions, deletions, replacements and swaps of neighbours count one each: the optimal string
 * alignment distance.
 */
[[nodiscard]] std::size_t keystrokes_between(const std::string & a, const std::string & b);

/// What an unknown key should have been: the nearest known one, or all of them if none is near.
/**
 * Near means a third of the word's keystrokes at most. A dotted name is also near by its last part
 * alone, since forgetting the group is as common as misspelling.
 */
[[nodiscard]] std::string suggest(
  const std::string & written, const std::vector<std::string> & known);

}  // namespace stetro_config

#endif  // STETRO_CONFIG__SUGGESTION_HPP_
