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

#include <optional>
#include <string>

#include "grey_image.hpp"

// The format: netpbm.sourceforge.net/doc/pgm.html. Comments are read as netpbm's own library does:
// from a # to the end of its line, wherever text stands, and even numbers in them mean nothing.

namespace stetro_site
{
namespace
{

constexpr std::uint32_t kHighestLevel = 65535;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// The text of a PGM, number by number.
class Text
{
public:
  explicit Text(const std::string & bytes) : bytes_(bytes) {}

  /// The next number, and past the one character of white space behind it.
  /** Nothing at the end of the text, or if something else stands there. */
  std::optional<std::uint32_t> number()
  {
    skip_space();
    if (at_end() || !is_digit(bytes_[at_])) {
      return std::nullopt;
    }
    std::uint64_t value = 0;
    for (; !at_end() && is_digit(bytes_[at_]); ++at_) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_] - '0');
      if (value > std::numeric_limits<std::uint32_t>::max()) {
        return std::nullopt;
      }
    }
    if (!at_end() && !skip_one()) {
      return std::nullopt;
    }
    return static_cast<std::uint32_t>(value);
  }

  /// Whether nothing but white space and comments is left.
  bool is_over()
  {
    skip_space();
    return at_end();
  }

  [[nodiscard]] std::size_t position() const { return at_; }

private:
  [[nodiscard]] bool at_end() const { return at_ >= bytes_.size(); }

  /// Past one white space or one comment with the end of its line; false if neither is there.
  bool skip_one()
  {
    if (bytes_[at_] == '#') {
      at_ = bytes_.find_first_of("\r\n", at_);
      at_ = at_ == std::string::npos ? bytes_.size() : at_ + 1;
      return true;
    }
    if (is_space(bytes_[at_])) {
      ++at_;
      return true;
    }
    return false;
  }

  void skip_space()
  {
    while (!at_end() && skip_one()) {
    }
  }

  const std::string & bytes_;
  std::size_t at_ = 2;  // behind the magic number
};

std::uint32_t header_number(Text & text, const std::string & name)
{
  if (const auto number = text.number()) {
    return *number;
  }
  throw ImageError("a PGM header without its " + name, "P2 or P5, width, height, largest level");
}

/// "15 = 5 x 3 pixels", for people who compare with the header.
std::string pixels_of(const GreyImage & image, std::size_t width = 1)
{
  return std::to_string(width * image.levels.size()) + " = " + std::to_string(image.columns) +
         " x " + std::to_string(image.rows) + " pixels";
}

void check_level(std::uint32_t level, std::size_t i, std::uint32_t white)
{
  if (level > white) {
    throw ImageError(
      "level " + std::to_string(level) + " of pixel " + std::to_string(i),
      "0 to " + std::to_string(white) + ", as its header says");
  }
}

void read_ascii(Text & text, GreyImage & image)
{
  for (std::size_t i = 0; i < image.levels.size(); ++i) {
    const bool is_missing = text.is_over();
    const auto level = text.number();
    if (!level) {
      throw ImageError(
        is_missing ? "ends after " + std::to_string(i) + " pixels"
                   : "no number at pixel " + std::to_string(i),
        pixels_of(image) + ", as its header says");
    }
    check_level(*level, i, image.white);
    image.levels[i] = *level;
  }
  if (!text.is_over()) {
    throw ImageError("goes on after its pixels", pixels_of(image) + ", as its header says");
  }
}

void read_binary(const std::string & bytes, std::size_t first, GreyImage & image)
{
  const std::size_t width = image.white > 255 ? 2 : 1;
  const std::size_t there = bytes.size() - first;
  if (there != width * image.levels.size()) {
    throw ImageError(
      std::to_string(there) + " bytes of pixels",
      pixels_of(image, width) + " of " + std::to_string(width) + (width == 1 ? " byte" : " bytes") +
        ", as its header says");
  }
  for (std::size_t i = 0; i < image.levels.size(); ++i) {
    std::uint32_t level = 0;
    for (std::size_t k = 0; k < width; ++k) {
      level = level << 8U | static_cast<unsigned char>(bytes[first + width * i + k]);
    }
    check_level(level, i, image.white);
    image.levels[i] = level;
  }
}

}  // namespace

GreyImage read_pgm(const std::string & bytes)
{
  Text text{bytes};
  const std::uint32_t columns = header_number(text, "width");
  const std::uint32_t rows = header_number(text, "height");
  const std::uint32_t white = header_number(text, "largest level");
  check_size(columns, rows);
  if (white == 0 || white > kHighestLevel) {
    throw ImageError(
      "largest level " + std::to_string(white), "1 to " + std::to_string(kHighestLevel));
  }
  GreyImage image;
  image.columns = static_cast<int>(columns);
  image.rows = static_cast<int>(rows);
  image.white = white;
  image.levels.resize(static_cast<std::size_t>(columns) * rows);
  if (bytes[1] == '2') {
    read_ascii(text, image);
  } else {
    read_binary(bytes, text.position(), image);
  }
  return image;
}

}  // namespace stetro_site
