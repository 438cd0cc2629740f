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

#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "grey_image.hpp"

namespace stetro_site
{
namespace
{

/// One PNG on its way through libpng, which reports a fault with a long jump.
/** So no step that libpng may leave that way owns anything that needs destroying. */
class PngReader
{
public:
  explicit PngReader(const std::string & bytes) : bytes_(bytes)
  {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::hush);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw ImageError("libpng does not start", "the libpng this was built with");
    }
    png_set_read_fn(png_, this, &PngReader::give);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader &) = delete;
  PngReader & operator=(const PngReader &) = delete;

  GreyImage read()
  {
    attempt(&PngReader::read_header);
    GreyImage image;
    check_size(png_get_image_width(png_, info_), png_get_image_height(png_, info_));
    image.columns = static_cast<int>(png_get_image_width(png_, info_));
    image.rows = static_cast<int>(png_get_image_height(png_, info_));
    const std::size_t row_bytes = png_get_rowbytes(png_, info_);
    samples_.resize(row_bytes * static_cast<std::size_t>(image.rows));
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.rows); ++row) {
      rows_.push_back(samples_.data() + row * row_bytes);
    }
    attempt(&PngReader::read_pixels);
    grey(image);
    return image;
  }

private:
  static void fail(png_structp png, png_const_charp message)
  {
    auto & self = *static_cast<PngReader *>(png_get_error_ptr(png));
    std::strncpy(self.why_.data(), message, self.why_.size() - 1);
    png_longjmp(png, 1);
  }

  static void hush(png_structp, png_const_charp) {}  // what can be read in spite of it is read

  static void give(png_structp png, png_bytep out, std::size_t count)
  {
    auto & self = *static_cast<PngReader *>(png_get_io_ptr(png));
    if (count > self.bytes_.size() - self.at_) {
      png_error(png, "ends early");
    }
    std::memcpy(out, self.bytes_.data() + self.at_, count);
    self.at_ += count;
  }

  void attempt(void (PngReader::*step)())
  {
    if (setjmp(png_jmpbuf(png_)) != 0) {  // NOLINT: libpng's way to report a fault
      throw ImageError("a PNG that is damaged: " + std::string{why_.data()}, "a whole PNG");
    }
    (this->*step)();
  }

  void read_header()
  {
    png_read_info(png_, info_);
    png_set_expand(png_);  // a palette to colours, one transparent colour to alpha, bits to bytes
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  void read_pixels()
  {
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
  }

  /// Sums the channels of each pixel; the second and the fourth are alpha.
  void grey(GreyImage & image) const
  {
    const std::size_t channels = png_get_channels(png_, info_);
    const std::size_t width = png_get_bit_depth(png_, info_) / 8U;
    const bool has_alpha = channels % 2 == 0;
    const std::size_t colours = channels - (has_alpha ? 1 : 0);
    const std::uint32_t most = width == 2 ? 65535 : 255;
    const auto sample = [&](std::size_t i) {
      return width == 2 ? samples_[2 * i] * 256U + samples_[2 * i + 1] : samples_[i];
    };
    image.white = most * static_cast<std::uint32_t>(colours);
    image.levels.resize(static_cast<std::size_t>(image.columns) * rows_.size());
    for (std::size_t pixel = 0; pixel < image.levels.size(); ++pixel) {
      std::uint32_t level = 0;
      for (std::size_t c = 0; c < colours; ++c) {
        level += sample(pixel * channels + c);
      }
      const bool is_opaque = !has_alpha || sample(pixel * channels + colours) == most;
      image.levels[pixel] = is_opaque ? level : GreyImage::kTransparent;
    }
  }

  const std::string & bytes_;
  std::size_t at_ = 0;
  std::array<char, 128> why_{};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<png_byte> samples_;
  std::vector<png_bytep> rows_;
};

}  // namespace

GreyImage read_png(const std::string & bytes) { return PngReader{bytes}.read(); }

}  // namespace stetro_site
