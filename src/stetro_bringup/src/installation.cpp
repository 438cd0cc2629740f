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

#include "installation.hpp"

#include <stdexcept>

namespace stetro_bringup
{
namespace
{

std::filesystem::path prefix()
{
  return std::filesystem::canonical("/proc/self/exe").parent_path().parent_path();
}

}  // namespace

std::filesystem::path shipped_folder() { return prefix() / "share" / "stetro_bringup" / "config"; }

std::string shipped_file(const std::string & name)
{
  const auto file = shipped_folder() / name;
  if (!std::filesystem::exists(file)) {
    throw std::runtime_error("the installation is incomplete: " + file.string() + " is missing");
  }
  return file.string();
}

std::string shipped_program(const std::string & name)
{
  const auto merged = prefix() / "bin" / name;
  const auto isolated = prefix().parent_path() / name / "bin" / name;
  for (const auto & program : {merged, isolated}) {
    if (std::filesystem::exists(program)) {
      return program.string();
    }
  }
  throw std::runtime_error(
    "the installation is incomplete: neither " + merged.string() + " nor " + isolated.string());
}

}  // namespace stetro_bringup
