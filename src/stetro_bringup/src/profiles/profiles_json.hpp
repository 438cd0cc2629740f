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

#include "profiles/logs_suite.hpp"
#include "profiles/maps_suite.hpp"
#include "profiles/rooms_suite.hpp"

namespace stetro_bringup
{

/// All that one run of the suite found.
struct ProfilesReport
{
  std::uint64_t seed = 1;
  std::vector<RoomsTable> rooms;
  std::vector<MapsTable> maps;
  std::vector<LogTable> logs;
};

/// A JSON object, shares 0 to 1, counts as integers: `<rooms table>.<way>.<figure>`,
/// `real_maps.<map>.<way>.<figure>` and `real_logs.<log>.<way>.<figure>`.
[[nodiscard]] std::string profiles_json(const ProfilesReport & report);

}  // namespace stetro_bringup

#endif  // PROFILES__PROFILES_JSON_HPP_
