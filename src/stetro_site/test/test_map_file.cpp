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

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "./png_bytes.hpp"
#include "./written_file.hpp"
#include "stetro_site/map_file.hpp"

namespace stetro_site
{
namespace
{

constexpr Cell kF = Cell::kFree;
constexpr Cell kO = Cell::kOccupied;
constexpr Cell kU = Cell::kUnknown;

// Three columns, two rows: the wall at the left of the upper row, unknown at its right.
const char kImage[] = "P2 3 2 255\n0 254 205\n254 254 254\n";

/// A map as the savers of ROS 2 write it, without a newline at the end.
std::string yaml_of(const WrittenFile & image)
{
  return "image: " + std::filesystem::path{image.path()}.filename().string() +
         "\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\n"
         "occupied_thresh: 0.65\nfree_thresh: 0.25";
}

GridMap map_of(const std::string & yaml) { return load_map(WrittenFile{yaml}.path()); }

/// Every fault of a map as "name: value 'x' refused, ..." without its place.
std::string faults_of(const std::string & yaml)
{
  const WrittenFile file{yaml};
  stetro_config::Faults faults;
  EXPECT_FALSE(read_map(file.path(), faults));
  std::string lines;
  for (auto fault : faults) {
    EXPECT_EQ(fault.file, file.path());
    EXPECT_GT(fault.line, 0) << fault;
    fault.file.clear();
    lines += to_string(fault) + "\n";
  }
  return lines;
}

TEST(MapFile, LaysTheFirstRowOfTheImageHighest)
{
  const WrittenFile image{kImage};
  const OccupancyGrid grid = map_of(yaml_of(image)).grid;
  EXPECT_EQ(grid.cells(), (std::vector<Cell>{kF, kF, kF, kO, kF, kU}));
  // The wall: half a cell right of the origin, one and a half above it.
  EXPECT_TRUE(grid.centre_m({0, 1}).isApprox(Eigen::Vector2d(-1.475, 2.075)));
  EXPECT_EQ(grid.at(grid.cell_at({-1.475, 2.075})), kO);
}

// A quarter turn about the origin: the image's right is the floor's +y, its top the floor's -x.
TEST(MapFile, TurnsByTheYawOfItsOrigin)
{
  const WrittenFile image{kImage};
  const OccupancyGrid grid = map_of(with(yaml_of(image), "2, 0]", "2, 1.5707963267948966]")).grid;
  EXPECT_EQ(grid.at(grid.cell_at({-1.575, 2.025})), kO);
  EXPECT_EQ(grid.at(grid.cell_at({-1.575, 2.125})), kU);
}

TEST(MapFile, KeepsUnknownWhatASaverLeftUnknown)
{
  const WrittenFile image{"P2 5 1 255\n205 204 206 205 192\n"};
  const GridMap map = map_of(yaml_of(image));
  // p = 1 - g / 255: 0.196, 0.200, 0.192, 0.196, 0.247, all below 0.25.
  EXPECT_EQ(map.grid.cells(), (std::vector<Cell>{kU, kF, kF, kU, kF}));
  ASSERT_EQ(map.notes.size(), 1U);
  EXPECT_NE(
    map.notes[0].find("2 cells of level 205, a map saver's unknown, stay unknown although "
                      "free_thresh 0.25 makes them free"),
    std::string::npos)
    << map.notes[0];
  const WrittenFile deep{"P2 2 1 65535\n52685 52686\n"};  // 205 x 257 and one more
  EXPECT_EQ(map_of(yaml_of(deep)).grid.cells(), (std::vector<Cell>{kU, kF}));
}

// By the letter of map_server alpha counts as a fourth colour in a trinary map: an opaque 205 would
// then be (3 x 205 + 255) / 4 = 217.5, p = 0.147 and free even below 0.196.
TEST(MapFile, JudgesWhatIsOpaqueByItsColourAndNothingElse)
{
  PngSpec spec{4, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, {}, {}, {}};
  const auto add = [&](png_byte grey, png_byte alpha) {
    spec.samples.insert(spec.samples.end(), {grey, grey, grey, alpha});
  };
  add(0, 255);
  add(205, 255);
  add(254, 255);
  add(254, 0);
  const WrittenFile image{png_bytes(spec)};
  const std::vector<Cell> cells{kO, kU, kF, kU};
  EXPECT_EQ(map_of(yaml_of(image)).grid.cells(), cells);
  EXPECT_EQ(map_of(with(yaml_of(image), "0.25", "0.196")).grid.cells(), cells);
  EXPECT_EQ(
    map_of(with(yaml_of(image), "trinary", "raw")).grid.cells(),
    (std::vector<Cell>{kF, kU, kU, kU}));
}

TEST(MapFile, SaysNothingWhereTheThresholdKeepsItUnknown)
{
  const WrittenFile image{kImage};
  const GridMap map = map_of(with(yaml_of(image), "0.25", "0.196"));
  EXPECT_EQ(map.grid.at({2, 1}), kU);
  EXPECT_TRUE(map.notes.empty());
}

TEST(MapFile, ComparesWithTheThresholdsStrictly)
{
  // p = 0.65, 0.66, 0.25, 0.24 of a white of 100.
  const WrittenFile image{"P2 4 1 100\n35 34 75 76\n"};
  EXPECT_EQ(map_of(yaml_of(image)).grid.cells(), (std::vector<Cell>{kU, kO, kU, kF}));
}

TEST(MapFile, NegatesWhenAsked)
{
  const WrittenFile image{"P2 4 1 255\n0 254 205 100\n"};
  const std::vector<Cell> negated{kF, kO, kO, kU};
  EXPECT_EQ(map_of(with(yaml_of(image), "negate: 0", "negate: 1")).grid.cells(), negated);
  EXPECT_EQ(map_of(with(yaml_of(image), "negate: 0", "negate: true")).grid.cells(), negated);
}

TEST(MapFile, IsTrinaryUnlessItSaysOtherwise)
{
  const WrittenFile image{kImage};
  const std::string yaml = yaml_of(image);
  const auto cells = map_of(yaml).grid.cells();
  EXPECT_EQ(map_of(with(yaml, "mode: trinary\n", "")).grid.cells(), cells);
  EXPECT_EQ(map_of(with(yaml, "trinary", "Trinary")).grid.cells(), cells);
}

// A scale map's saver never writes 205: between its levels 204 and 207 there is none.
TEST(MapFile, ScaleDrivesOnlyWhereItIsBelowFree)
{
  const WrittenFile image{"P2 5 1 255\n0 128 205 255 64\n"};  // p = 1, 0.498, 0.196, 0, 0.749
  const GridMap map = map_of(with(yaml_of(image), "trinary", "scale"));
  EXPECT_EQ(map.grid.cells(), (std::vector<Cell>{kO, kU, kF, kF, kO}));
  EXPECT_TRUE(map.notes.empty());
}

TEST(MapFile, RawIsPerCentAndUnknownAboveThat)
{
  const WrittenFile image{"P2 7 1 255\n0 24 25 65 66 100 101\n"};
  const std::string yaml = with(yaml_of(image), "trinary", "raw");
  EXPECT_EQ(map_of(yaml).grid.cells(), (std::vector<Cell>{kF, kF, kU, kU, kO, kO, kU}));
  EXPECT_EQ(
    faults_of(with(yaml, "negate: 0", "negate: 1")),
    "negate: value '1' refused, accepted: 0 with mode raw: map servers differ in what 1 means "
    "there\n");
}

TEST(MapFile, RefusesNumbersThatAreNone)
{
  const WrittenFile image{kImage};
  const std::string yaml = yaml_of(image);
  EXPECT_EQ(
    faults_of(with(yaml, "[-1.5,", "[.nan,")),
    "origin: value '[.nan, 2, 0]' refused, accepted: a list of finite numbers, 3 of them, each "
    "-1000000 to 1000000\n");
  EXPECT_EQ(
    faults_of(with(yaml, ", 0]", "]")),
    "origin: value '[-1.5, 2]' refused, accepted: a list of finite numbers, 3 of them, each "
    "-1000000 to 1000000\n");
  EXPECT_EQ(
    faults_of(with(yaml, "0.05", "0")),
    "resolution: value '0' refused, accepted: a finite number, 0.001 to 10\n");
  EXPECT_EQ(
    faults_of(with(yaml, "0.25", "0.65")),
    "free_thresh: value '0.65' refused, accepted: less than occupied_thresh, 0.65\n");
  EXPECT_EQ(
    faults_of(with(yaml, "0.65", "65")),
    "occupied_thresh: value '65' refused, accepted: a finite number, 0 to 1\n");
  EXPECT_EQ(
    faults_of(with(yaml, "negate: 0", "negate: 2")),
    "negate: value '2' refused, accepted: 0 or 1, false or true\n");
  EXPECT_EQ(
    faults_of(with(yaml, "trinary", "binary")),
    "mode: value 'binary' refused, accepted: trinary, scale or raw\n");
}

TEST(MapFile, ReportsAllFaultsTogether)
{
  EXPECT_EQ(
    faults_of("image: ''\norigen: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.9"),
    "image: value '' refused, accepted: text (quoted if it looks like a number), not empty\n"
    "resolution: missing, accepted: a finite number, 0.001 to 10\n"
    "origin: missing, accepted: a list of finite numbers, 3 of them, each -1000000 to 1000000\n"
    "negate: missing, accepted: 0 or 1, false or true\n"
    "free_thresh: value '0.9' refused, accepted: less than occupied_thresh, 0.65\n"
    "origen: value '[0, 0, 0]' refused, accepted: a known key; did you mean origin?\n");
}

TEST(MapFile, RefusesAnImageThatIsNoneOrCut)
{
  const WrittenFile cut{"P5 3 2 255\nabc"};
  const std::string name = std::filesystem::path{cut.path()}.filename().string();
  EXPECT_EQ(
    faults_of(yaml_of(cut)),
    "image: value '" + name +
      ": 3 bytes of pixels' refused, accepted: 6 = 3 x 2 pixels of 1 byte, "
      "as its header says\n");
  const std::string missing = faults_of(with(yaml_of(cut), name, "no_such.pgm"));
  EXPECT_EQ(
    missing,
    "image: value 'no_such.pgm: not a file' refused, accepted: a PGM (P2 or P5) or PNG "
    "image; there is none at " +
      testing::TempDir() + "no_such.pgm\n");
}

TEST(MapFile, SaysOnceThatThereIsNone)
{
  stetro_config::Faults faults;
  EXPECT_FALSE(read_map("no/such.yaml", faults));
  EXPECT_EQ(faults.size(), 1U);
  EXPECT_THROW(static_cast<void>(map_of("- a list\n")), stetro_config::ConfigError);
}

// Property: however either file is cut off, nothing but faults leaves, and a map that is cut is
// none.
TEST(MapFile, ThrowsNothingWhateverItHolds)
{
  const std::string pixels = "P5 3 2 255\n" + std::string{"\x00\xfe\xcd\xfe\xfe\xfe", 6};
  for (std::size_t cut = 0; cut < pixels.size(); ++cut) {
    const WrittenFile image{pixels.substr(0, cut)};
    EXPECT_NE(faults_of(yaml_of(image)), "") << cut;
  }
  const WrittenFile image{pixels};
  const std::string yaml = yaml_of(image);
  for (std::size_t cut = 0; cut < yaml.size(); ++cut) {
    const WrittenFile file{yaml.substr(0, cut)};
    stetro_config::Faults faults;
    std::optional<GridMap> map;
    EXPECT_NO_THROW(map = read_map(file.path(), faults)) << cut;
    EXPECT_EQ(map.has_value(), faults.empty()) << cut;
  }
}

}  // namespace
}  // namespace stetro_site
