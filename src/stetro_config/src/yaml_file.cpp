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

#include "stetro_config/yaml_file.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "stetro_config/value.hpp"

namespace stetro_config
{
namespace
{

constexpr std::size_t kLargestFile = 16U << 20U;  // far above any site, far below /dev/zero
constexpr char kOneMap[] = "one YAML document with a map at its root";

int line_of(const YAML::Mark & mark) { return mark.is_null() ? 0 : mark.line + 1; }

/// The file's bytes, or nothing and the reason in `why`.
std::optional<std::string> contents_of(const std::string & path, std::string & why)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    why = "a directory";
    return std::nullopt;
  }
  errno = 0;
  std::ifstream file{path, std::ios::binary};
  if (!file) {
    why = std::generic_category().message(errno);
    return std::nullopt;
  }
  std::string text;
  std::array<char, 4096> chunk{};
  while (file.read(chunk.data(), chunk.size()) || file.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > kLargestFile) {
      why = "more than 16 MiB";
      return std::nullopt;
    }
  }
  if (file.bad()) {
    why = std::generic_category().message(errno);
    return std::nullopt;
  }
  return text;
}

}  // namespace

int line_of(const YAML::Node & node) { return line_of(node.Mark()); }

std::optional<YAML::Node> read_yaml_text(
  const std::string & text, const std::string & file, Faults & faults)
{
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(text);
  } catch (const YAML::Exception & error) {
    faults.add({file, line_of(error.mark), "", error.msg, "well-formed YAML"});
    return std::nullopt;
  }
  if (documents.size() > 1) {
    faults.add({file, line_of(documents[1]), "", "a second document", kOneMap});
    return std::nullopt;
  }
  if (documents.empty() || !documents.front().IsMap()) {
    const std::string root = documents.empty() ? "an empty file" : excerpt(documents.front());
    faults.add({file, documents.empty() ? 1 : line_of(documents.front()), "", root, kOneMap});
    return std::nullopt;
  }
  return documents.front();
}

std::optional<YAML::Node> read_yaml_file(const std::string & path, Faults & faults)
{
  std::string why;
  const auto text = contents_of(path, why);
  if (!text) {
    faults.add({path, 0, "", why, "a file that can be read"});
    return std::nullopt;
  }
  return read_yaml_text(*text, path, faults);
}

}  // namespace stetro_config
