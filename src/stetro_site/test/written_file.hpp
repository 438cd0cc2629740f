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

#ifndef WRITTEN_FILE_HPP_
#define WRITTEN_FILE_HPP_

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace stetro_site
{

/// A file of this test alone, gone when the test is over.
class WrittenFile
{
public:
  explicit WrittenFile(const std::string & text) : path_(testing::TempDir() + own_name())
  {
    std::ofstream{path_} << text;
  }
  ~WrittenFile() { std::remove(path_.c_str()); }
  WrittenFile(const WrittenFile &) = delete;
  WrittenFile & operator=(const WrittenFile &) = delete;

  [[nodiscard]] const std::string & path() const { return path_; }

private:
  static std::string own_name()
  {
    const auto * test = testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    return std::string{test->test_suite_name()} + "." + test->name() + "." +
           std::to_string(count++) + ".yaml";
  }

  std::string path_;
};

/// The text of a shipped file.
inline std::string shipped(const std::string & name)
{
  std::ostringstream text;
  text << std::ifstream{CONFIG_FOLDER + name}.rdbuf();
  return text.str();
}

/// The text with one part, which must be there, replaced.
inline std::string with(std::string text, const std::string & part, const std::string & other)
{
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

}  // namespace stetro_site

#endif  // WRITTEN_FILE_HPP_
