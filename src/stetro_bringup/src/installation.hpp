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

#ifndef INSTALLATION_HPP_
#define INSTALLATION_HPP_

#include <filesystem>
#include <string>

namespace stetro_bringup
{

/// share/stetro_bringup/config of the installation that this program is of.
[[nodiscard]] std::filesystem::path shipped_folder();

/// The shipped file `name` of share/stetro_bringup/config, such as "site/papers_staircase.yaml".
/** \throws std::runtime_error if the installation has no such file */
[[nodiscard]] std::string shipped_file(const std::string & name);

/// The installed program `name`: beside this one, or in the package of its name next to ours.
/** \throws std::runtime_error if the installation has none */
[[nodiscard]] std::string shipped_program(const std::string & name);

}  // namespace stetro_bringup

#endif  // INSTALLATION_HPP_
