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

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "../src/grey_image.hpp"
#include "./png_bytes.hpp"
#include "./written_file.hpp"

namespace stetro_site
{
namespace
{

using Levels = std::vector<std::uint32_t>;

constexpr std::uint32_t kClear = GreyImage::kTransparent;

/// What is found in bytes that are no image, and what would be accepted.
std::string fault_of(const std::string & bytes)
{
  const WrittenFile file{bytes};
  try {
    static_cast<void>(read_image(file.path()));
  } catch (const ImageError & error) {
    return std::string{error.what()} + "; " + error.accepted();
  }
  return "none";
}

TEST(PgmImage, ReadsAsciiAndItsComments)
{
  const GreyImage image =
    read_pgm("P2 # 9 9\n#8-bit pgm - 7 7\n3# wide\n 2 255#\n0 205\n# 12\n254  7 8 9");
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.white, 255U);
  EXPECT_EQ(image.levels, (Levels{0, 205, 254, 7, 8, 9}));
}

TEST(PgmImage, ReadsBytesAndACommentWithNumbersBeforeThem)
{
  const GreyImage image = read_pgm(
    "P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n2 2\n255\n" + std::string{"\n#\x00\xff", 4});
  EXPECT_EQ(image.levels, (Levels{'\n', '#', 0, 255})) << "bytes are not text";
}

TEST(PgmImage, ReadsOtherLargestLevels)
{
  const GreyImage dark = read_pgm("P5 2 1 100 " + std::string{"\x64\x07"});
  EXPECT_EQ(dark.white, 100U);
  EXPECT_EQ(dark.levels, (Levels{100, 7}));
  const GreyImage deep = read_pgm("P5 2 1 65535 " + std::string{"\xff\xff\x01\x02", 4});
  EXPECT_EQ(deep.levels, (Levels{65535, 258})) << "the high byte first";
}

TEST(PgmImage, RefusesWhatItsHeaderDoesNotSay)
{
  EXPECT_EQ(
    fault_of("P5 3 2 255\nabcde"),
    "5 bytes of pixels; 6 = 3 x 2 pixels of 1 byte, as its header says");
  EXPECT_EQ(
    fault_of("P5 3 2 256\nabcdefghijklm"),
    "13 bytes of pixels; 12 = 3 x 2 pixels of 2 bytes, as its header says");
  EXPECT_EQ(
    fault_of("P2 3 2 255\n1 2 3 4 5 \n"),
    "ends after 5 pixels; 6 = 3 x 2 pixels, as its header says");
  EXPECT_EQ(
    fault_of("P2 3 1 255\n1 2 3 4"),
    "goes on after its pixels; 3 = 3 x 1 pixels, as its header says");
  EXPECT_EQ(
    fault_of("P2 3 1 255\n1 -2 3"), "no number at pixel 1; 3 = 3 x 1 pixels, as its header says");
  EXPECT_EQ(fault_of("P2 3 1 9\n1 2 10"), "level 10 of pixel 2; 0 to 9, as its header says");
  EXPECT_EQ(fault_of("P5 1 1 9\n\x0a"), "level 10 of pixel 0; 0 to 9, as its header says");
}

TEST(PgmImage, RefusesHeadersThatAreNone)
{
  EXPECT_EQ(
    fault_of("P5\n# 3 2 255\n"),
    "a PGM header without its width; P2 or P5, width, height, largest level");
  EXPECT_EQ(
    fault_of("P2 3 x"), "a PGM header without its height; P2 or P5, width, height, largest level");
  EXPECT_EQ(fault_of("P5 1 1 0\n\x0a"), "largest level 0; 1 to 65535");
  EXPECT_EQ(fault_of("P5 1 1 70000\n\x0a"), "largest level 70000; 1 to 65535");
  EXPECT_EQ(fault_of("P5 0 2 255\n"), "0 x 2 pixels; 1 to 67108864 pixels");
  EXPECT_EQ(fault_of("P5 70000 1000 255\n"), "70000 x 1000 pixels; 1 to 67108864 pixels");
}

TEST(MapImage, RefusesOtherFilesByWhatTheyBeginWith)
{
  const std::string accepted = "; a PGM (P2 or P5) or PNG image";
  EXPECT_EQ(fault_of(""), "an empty file" + accepted);
  EXPECT_EQ(fault_of("P6 1 1 255 abc"), "begins with P6 1" + accepted);
  EXPECT_EQ(fault_of("\xff\xd8\xff\xe0 JFIF"), "begins with \\xff\\xd8\\xff\\xe0" + accepted);
}

TEST(PngImage, ReadsGreyOfEveryDepth)
{
  PngSpec one_bit{4, 2, 1, PNG_COLOR_TYPE_GRAY, {0x50, 0xA0}, {}, {}};  // 0101, 1010
  EXPECT_EQ(read_png(png_bytes(one_bit)).levels, (Levels{0, 255, 0, 255, 255, 0, 255, 0}));
  PngSpec two_bits{4, 1, 2, PNG_COLOR_TYPE_GRAY, {0x1B}, {}, {}};  // 0, 1, 2, 3 of 3
  EXPECT_EQ(read_png(png_bytes(two_bits)).levels, (Levels{0, 85, 170, 255}));
  PngSpec bytes{3, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 205, 254}, {}, {}};
  const GreyImage image = read_png(png_bytes(bytes));
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 1);
  EXPECT_EQ(image.white, 255U);
  EXPECT_EQ(image.levels, (Levels{0, 205, 254}));
  PngSpec deep{2, 1, 16, PNG_COLOR_TYPE_GRAY, {0x01, 0x02, 0xFF, 0xFF}, {}, {}};
  EXPECT_EQ(read_png(png_bytes(deep)).white, 65535U);
  EXPECT_EQ(read_png(png_bytes(deep)).levels, (Levels{258, 65535}));
}

TEST(PngImage, SumsColoursAndLooksUpPalettes)
{
  PngSpec colours{2, 1, 8, PNG_COLOR_TYPE_RGB, {10, 20, 31, 205, 205, 205}, {}, {}};
  EXPECT_EQ(read_png(png_bytes(colours)).white, 765U);
  EXPECT_EQ(read_png(png_bytes(colours)).levels, (Levels{61, 615}));
  PngSpec palette{4, 1, 2, PNG_COLOR_TYPE_PALETTE, {0x1B}, {}, {}};  // 0, 1, 2, 3
  palette.palette = {{0, 0, 0}, {205, 205, 205}, {254, 254, 254}, {1, 2, 3}};
  EXPECT_EQ(read_png(png_bytes(palette)).white, 765U);
  EXPECT_EQ(read_png(png_bytes(palette)).levels, (Levels{0, 615, 762, 6}));
}

TEST(PngImage, ShowsNothingWhereItIsNotOpaque)
{
  PngSpec grey{3, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {0, 255, 254, 254, 254, 0}, {}, {}};
  EXPECT_EQ(read_png(png_bytes(grey)).white, 255U);
  EXPECT_EQ(read_png(png_bytes(grey)).levels, (Levels{0, kClear, kClear}));
  PngSpec colours{2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 255, 1, 2, 3, 128}, {}, {}};
  EXPECT_EQ(read_png(png_bytes(colours)).levels, (Levels{6, kClear}));
  PngSpec palette{2, 1, 8, PNG_COLOR_TYPE_PALETTE, {0, 1}, {{9, 9, 9}, {9, 9, 9}}, {0}};
  EXPECT_EQ(read_png(png_bytes(palette)).levels, (Levels{kClear, 27}));
  PngSpec deep{2, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, {0, 7, 255, 255, 0, 7, 255, 254}, {}, {}};
  EXPECT_EQ(read_png(png_bytes(deep)).levels, (Levels{7, kClear}));
}

TEST(PngImage, IsReadAsWrittenWhateverItsGammaAndOrder)
{
  PngSpec spec{5, 3, 8, PNG_COLOR_TYPE_GRAY, {}, {}, {}};
  for (int i = 0; i < 15; ++i) {
    spec.samples.push_back(static_cast<png_byte>(i * 17));
  }
  const Levels plain = read_png(png_bytes(spec)).levels;
  EXPECT_EQ(plain, Levels(spec.samples.begin(), spec.samples.end()));
  spec.gamma = 1.0;
  EXPECT_EQ(read_png(png_bytes(spec)).levels, plain);
  spec.is_interlaced = true;
  EXPECT_EQ(read_png(png_bytes(spec)).levels, plain);
}

// Property: a PNG that lost its end or had a byte changed is refused, or still reads the same.
TEST(PngImage, RefusesEveryDamage)
{
  PngSpec spec{5, 3, 8, PNG_COLOR_TYPE_GRAY, {}, {}, {}};
  for (int i = 0; i < 15; ++i) {
    spec.samples.push_back(static_cast<png_byte>(i * 17));
  }
  const std::string whole = png_bytes(spec);
  const Levels levels = read_png(whole).levels;
  for (std::size_t i = 8; i < whole.size(); ++i) {
    EXPECT_THROW(static_cast<void>(read_png(whole.substr(0, i))), ImageError) << i;
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    try {
      EXPECT_EQ(read_png(changed).levels, levels) << i;
    } catch (const ImageError &) {
      SUCCEED();
    }
  }
  EXPECT_EQ(fault_of(whole.substr(0, 40)), "a PNG that is damaged: ends early; a whole PNG");
}

}  // namespace
}  // namespace stetro_site
