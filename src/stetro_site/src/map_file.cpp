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

#include "stetro_site/map_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include "grey_image.hpp"
#include "stetro_config/map_reader.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Each;
using stetro_config::Faults;
using stetro_config::Kind;
using stetro_config::MapReader;
using stetro_config::NonEmpty;
using stetro_config::to_text;
using stetro_config::Within;

constexpr std::uint32_t kUnknownLevel = 205;  // what map savers write for unknown, of 255

enum class Mode { kTrinary, kScale, kRaw };

/// How levels of grey become cells.
struct Legend
{
  Mode mode = Mode::kTrinary;
  bool negate = false;
  double occupied_thresh = 0.0;
  double free_thresh = 0.0;
};

/// Like map_server, which minds no capitals.
Mode read_mode(MapReader & file)
{
  constexpr char kAccepted[] = "trinary, scale or raw";
  auto name = file.optional<std::string>("mode", "trinary", NonEmpty{});
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  if (name == "scale") {
    return Mode::kScale;
  }
  if (name == "raw") {
    return Mode::kRaw;
  }
  if (!name.empty() && name != "trinary") {
    file.refuse("mode", name, kAccepted);
  }
  return Mode::kTrinary;
}

/// Written 0 or 1, or false or true.
bool read_negate(MapReader & file)
{
  constexpr char kAccepted[] = "0 or 1, false or true";
  const YAML::Node node = file.verbatim("negate");
  if (!file.has("negate")) {
    file.refuse("negate", stetro_config::kMissing, kAccepted);
    return false;
  }
  if (const auto number = stetro_config::parse(node, Kind::kInt)) {
    const auto written = std::get<std::int64_t>(*number);
    if (written == 0 || written == 1) {
      return written == 1;
    }
  } else if (const auto truth = stetro_config::parse(node, Kind::kBool)) {
    return std::get<bool>(*truth);
  }
  file.refuse("negate", stetro_config::excerpt(node), kAccepted);
  return false;
}

Legend read_legend(MapReader & file, const Faults & faults)
{
  constexpr Within kShare{0.0, 1.0};
  Legend legend;
  legend.mode = read_mode(file);
  legend.negate = read_negate(file);
  const std::size_t before = faults.size();
  const auto occupied = file.require<double>("occupied_thresh", kShare);
  const auto free = file.require<double>("free_thresh", kShare);
  if (faults.size() == before && free >= occupied) {
    file.refuse("free_thresh", to_text(free), "less than occupied_thresh, " + to_text(occupied));
  }
  if (legend.mode == Mode::kRaw && legend.negate) {
    file.refuse("negate", "1", "0 with mode raw: map servers differ in what 1 means there");
  }
  legend.occupied_thresh = occupied;
  legend.free_thresh = free;
  return legend;
}

GridFrame read_frame(MapReader & file)
{
  GridFrame frame;
  frame.resolution_m = file.require<double>("resolution", Within{1e-3, 10.0});
  const auto origin = file.require<std::vector<double>>("origin", Each{Within{-1e6, 1e6}, 3, 3});
  if (origin.size() == 3) {
    frame.origin_m = {origin[0], origin[1]};
    frame.yaw_rad = origin[2];
  }
  return frame;
}

std::optional<GreyImage> find_image(MapReader & file)
{
  const auto written = file.require<std::string>("image", NonEmpty{});
  if (written.empty()) {
    return std::nullopt;  // a fault already says so
  }
  const std::filesystem::path folder = std::filesystem::path{file.origin().file}.parent_path();
  try {
    return read_image((folder / written).string());
  } catch (const ImageError & error) {
    file.refuse("image", written + ": " + error.what(), error.accepted());
    return std::nullopt;
  }
}

/// Eq. (1) and (2); nothing where the level stands for unknown.
std::optional<double> occupancy(std::uint32_t level, std::uint32_t white, const Legend & legend)
{
  if (level == GreyImage::kTransparent) {
    return std::nullopt;
  }
  const double shade = static_cast<double>(level) / white;
  if (legend.mode == Mode::kRaw) {
    const double percent = std::round(255.0 * shade);
    return percent > 100.0 ? std::nullopt : std::optional{percent / 100.0};
  }
  return legend.negate ? shade : 1.0 - shade;
}

Cell cell_of(std::uint32_t level, std::uint32_t white, const Legend & legend)
{
  const auto p = occupancy(level, white, legend);
  if (p && *p > legend.occupied_thresh) {
    return Cell::kOccupied;
  }
  return p && *p < legend.free_thresh ? Cell::kFree : Cell::kUnknown;
}

/// Whether a level is exactly what a map saver writes for unknown, in whatever depth.
bool is_saved_unknown(std::uint32_t level, std::uint32_t white, const Legend & legend)
{
  return legend.mode == Mode::kTrinary && !legend.negate &&
         std::uint64_t{level} * 255U == std::uint64_t{kUnknownLevel} * white;
}

/// The cells row by row from the lowest, and how many a map saver left unknown but p makes free.
std::pair<std::vector<Cell>, std::size_t> read_cells(const GreyImage & image, const Legend & legend)
{
  std::vector<Cell> cells;
  cells.reserve(image.levels.size());
  std::size_t kept_unknown = 0;
  const auto columns = static_cast<std::ptrdiff_t>(image.columns);
  for (std::ptrdiff_t row = image.rows; row-- > 0;) {
    const auto first = image.levels.begin() + row * columns;
    std::for_each(first, first + columns, [&](std::uint32_t level) {
      Cell cell = cell_of(level, image.white, legend);
      if (cell == Cell::kFree && is_saved_unknown(level, image.white, legend)) {
        cell = Cell::kUnknown;
        ++kept_unknown;
      }
      cells.push_back(cell);
    });
  }
  return {std::move(cells), kept_unknown};
}

}  // namespace

std::optional<GridMap> read_map(const std::string & path, Faults & faults)
{
  MapReader file = MapReader::from_file(path, faults);
  if (file.origin().line == 0) {
    return std::nullopt;  // there is no YAML to speak of, and a fault says so
  }
  const auto image = find_image(file);
  GridFrame frame = read_frame(file);
  const Legend legend = read_legend(file, faults);
  file.finish();
  if (!file.sound() || !image) {
    return std::nullopt;
  }
  frame.columns = image->columns;
  frame.rows = image->rows;
  auto [cells, kept_unknown] = read_cells(*image, legend);
  GridMap map{OccupancyGrid{frame, std::move(cells)}, {}};
  if (kept_unknown > 0) {
    map.notes.push_back(
      path + ": " + std::to_string(kept_unknown) + " cells of level 205, a map saver's unknown, " +
      "stay unknown although free_thresh " + to_text(legend.free_thresh) + " makes them free");
  }
  return map;
}

GridMap load_map(const std::string & path)
{
  Faults faults;
  auto map = read_map(path, faults);
  faults.throw_if_any();
  return std::move(map).value();
}

}  // namespace stetro_site
