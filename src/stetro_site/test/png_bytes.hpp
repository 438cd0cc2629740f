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

#ifndef PNG_BYTES_HPP_
#define PNG_BYTES_HPP_

#include <png.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace stetro_site
{

/// A PNG to be written: its samples are the bytes of its rows, as the format packs them.
struct PngSpec
{
  png_uint_32 columns = 0;
  png_uint_32 rows = 0;
  int bit_depth = 8;
  int colour_type = PNG_COLOR_TYPE_GRAY;
  std::vector<png_byte> samples;
  std::vector<png_color> palette;
  std::vector<png_byte> palette_alpha;
  bool is_interlaced = false;
  double gamma = 0.0;  ///< none written if 0
};

/// The bytes of a PNG file.
inline std::string png_bytes(PngSpec spec)
{
  const auto fail = [](png_structp, png_const_charp message) { throw std::runtime_error(message); };
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string bytes;
  const auto take = [](png_structp to, png_bytep from, std::size_t count) {
    static_cast<std::string *>(png_get_io_ptr(to))->append(reinterpret_cast<char *>(from), count);
  };
  png_set_write_fn(png, &bytes, take, [](png_structp) {});
  png_set_IHDR(
    png, info, spec.columns, spec.rows, spec.bit_depth, spec.colour_type,
    spec.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
    PNG_FILTER_TYPE_DEFAULT);
  if (!spec.palette.empty()) {
    png_set_PLTE(png, info, spec.palette.data(), static_cast<int>(spec.palette.size()));
  }
  if (!spec.palette_alpha.empty()) {
    png_set_tRNS(
      png, info, spec.palette_alpha.data(), static_cast<int>(spec.palette_alpha.size()), nullptr);
  }
  if (spec.gamma > 0.0) {
    png_set_gAMA(png, info, spec.gamma);
  }
  std::vector<png_bytep> rows;
  const std::size_t row_bytes = spec.samples.size() / spec.rows;
  for (std::size_t row = 0; row < spec.rows; ++row) {
    rows.push_back(spec.samples.data() + row * row_bytes);
  }
  png_set_rows(png, info, rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace stetro_site

#endif  // PNG_BYTES_HPP_
