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

#ifndef PTY_NAME_HPP_
#define PTY_NAME_HPP_

#include <unistd.h>

#include <filesystem>
#include <string>

namespace stetro_driver::test
{

/// A path for an emulated cable that no other test process uses.
inline std::string pty_name(const std::string & name)
{
  return std::filesystem::temp_directory_path() /
         ("stetro_pty_" + std::to_string(::getpid()) + "_" + name);
}

}  // namespace stetro_driver::test

#endif  // PTY_NAME_HPP_
