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

#ifndef PROFILES__PROFILES_JSON_HPP_
#define PROFILES__PROFILES_JSON_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "profiles/rooms_suite.hpp"

namespace stetro_bringup
{

/// The tables as a JSON object: `<table>.<way>.<figure>`, shares 0 to 1, counts as integers.
[[nodiscard]] std::string profiles_json(const std::vector<RoomsTable> & tables, std::uint64_t seed);

/// The tables for a terminal.
[[nodiscard]] std::string profiles_table(const std::vector<RoomsTable> & tables);

}  // namespace stetro_bringup

#endif  // PROFILES__PROFILES_JSON_HPP_
