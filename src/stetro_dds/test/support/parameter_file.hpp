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

#ifndef SUPPORT__PARAMETER_FILE_HPP_
#define SUPPORT__PARAMETER_FILE_HPP_

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace stetro_dds
{

/// A file with this text, until the end of the test.
class ParameterFile
{
public:
  explicit ParameterFile(const std::string & text)
  : path_(
      std::filesystem::temp_directory_path() /
      ("stetro_parameters_" + std::to_string(::getpid()) + ".yaml"))
  {
    std::ofstream(path_) << text;
  }
  ~ParameterFile() { std::filesystem::remove(path_); }
  ParameterFile(const ParameterFile &) = delete;
  ParameterFile & operator=(const ParameterFile &) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }

private:
  std::filesystem::path path_;
};

}  // namespace stetro_dds

#endif  // SUPPORT__PARAMETER_FILE_HPP_
