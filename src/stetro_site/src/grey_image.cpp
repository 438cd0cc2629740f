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

#include "grey_image.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace stetro_site
{
namespace
{

constexpr char kKinds[] = "a PGM (P2 or P5) or PNG image";
constexpr std::uintmax_t kLargestFile = 512U << 20U;  // kMostPixels in ASCII

std::string contents_of(const std::string & path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw ImageError("not a file", std::string{kKinds} + "; there is none at " + path);
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > kLargestFile) {
    throw ImageError(error ? error.message() : "more than 512 MiB", kKinds);
  }
  std::string bytes(size, '\0');
  std::ifstream file{path, std::ios::binary};
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    throw ImageError("not readable", std::string{"a file that can be read, "} + kKinds);
  }
  return bytes;
}

bool begins_with(const std::string & bytes, const std::string & mark)
{
  return bytes.compare(0, mark.size(), mark) == 0;
}

/// The first bytes, for people: text as it is, the rest in hexadecimal.
std::string beginning_of(const std::string & bytes)
{
  if (bytes.empty()) {
    return "an empty file";
  }
  std::string text = "begins with ";
  for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 4); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    std::array<char, 8> hexadecimal{};
    std::snprintf(
      hexadecimal.data(), hexadecimal.size(), std::isprint(byte) != 0 ? "%c" : "\\x%02x", byte);
    text += hexadecimal.data();
  }
  return text;
}

}  // namespace

void check_size(std::uint64_t columns, std::uint64_t rows)
{
  constexpr std::uint64_t kLongest = std::numeric_limits<int>::max();
  if (
    columns == 0 || rows == 0 || columns > kLongest || rows > kLongest ||
    columns * rows > kMostPixels) {
    throw ImageError(
      std::to_string(columns) + " x " + std::to_string(rows) + " pixels",
      "1 to " + std::to_string(kMostPixels) + " pixels");
  }
}

GreyImage read_image(const std::string & path)
{
  const std::string bytes = contents_of(path);
  if (begins_with(bytes, "P2") || begins_with(bytes, "P5")) {
    return read_pgm(bytes);
  }
  if (begins_with(bytes, "\x89PNG\r\n\x1a\n")) {
    return read_png(bytes);
  }
  throw ImageError(beginning_of(bytes), kKinds);
}

}  // namespace stetro_site
