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

#ifndef GREY_IMAGE_HPP_
#define GREY_IMAGE_HPP_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stetro_site
{

/// An image in levels of grey, row by row from the top, 0 is black.
/** A colour is the sum of its channels, so that nothing is rounded; white is their largest sum. */
struct GreyImage
{
  /// The level of a pixel that is not wholly opaque: it shows nothing of its own.
  static constexpr std::uint32_t kTransparent = std::numeric_limits<std::uint32_t>::max();

  int columns = 0;
  int rows = 0;
  std::uint32_t white = 0;
  std::vector<std::uint32_t> levels;
};

/// Why a file is no image: what was found in it, and what would be accepted.
class ImageError : public std::runtime_error
{
public:
  ImageError(const std::string & found, std::string accepted)
  : std::runtime_error(found), accepted_(std::move(accepted))
  {
  }
  [[nodiscard]] const std::string & accepted() const noexcept { return accepted_; }

private:
  std::string accepted_;
};

/// The most pixels an image may have: 400 m x 400 m in cells of 5 cm.
constexpr std::uint64_t kMostPixels = 1U << 26U;

/// \throws ImageError unless an image of this size has pixels, and no more than kMostPixels
void check_size(std::uint64_t columns, std::uint64_t rows);

/// Reads the bytes of a PGM file, ASCII (P2) or binary (P5) of one or two bytes a pixel.
/** \throws ImageError also for pixels that are too few, too many or above the largest level */
[[nodiscard]] GreyImage read_pgm(const std::string & bytes);

/// Reads the bytes of a PNG file of any kind, as written: no gamma is applied.
/** \throws ImageError also for a file that ends early or whose checksums do not fit */
[[nodiscard]] GreyImage read_png(const std::string & bytes);

/// Reads an image file, whatever its name, by what it begins with.
/** \throws ImageError for a file that is missing, cannot be read or is no image of these kinds */
[[nodiscard]] GreyImage read_image(const std::string & path);

}  // namespace stetro_site

#endif  // GREY_IMAGE_HPP_
