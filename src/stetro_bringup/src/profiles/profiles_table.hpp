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

#ifndef PROFILES__PROFILES_TABLE_HPP_
#define PROFILES__PROFILES_TABLE_HPP_

#include <string>

#include "profiles/profiles_json.hpp"

namespace stetro_bringup
{

/// The report for a terminal.
[[nodiscard]] std::string profiles_table(const ProfilesReport & report);

}  // namespace stetro_bringup

#endif  // PROFILES__PROFILES_TABLE_HPP_
