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

#include "profiles/recorded_scan.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "nlohmann/json.hpp"
#include "stetro_site/frame_transform.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_supervisor::rotation;
using stetro_supervisor::ScannerPose;

constexpr double kPi = 3.141592653589793;
constexpr double kTurn = 2.0 * kPi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOwnParts = 0.1;  // points nearer than this are the lidar's own [m]

/// A pose of odometry.
struct Odometry
{
  std::int64_t stamp_ns;
  ScannerPose pose;
};

/// The numbers of a line that may end in a comma. \throws std::runtime_error
std::vector<std::string> cells_of(const std::string & line)
{
  std::vector<std::string> cells;
  std::stringstream rest(line);
  for (std::string cell; std::getline(rest, cell, ',');) {
    if (!cell.empty() && cell != "\r") {
      cells.push_back(cell);
    }
  }
  return cells;
}

std::vector<std::vector<std::string>> rows_of(const std::string & path, std::size_t least)
{
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) {
    throw std::runtime_error(path + ": cannot be read");
  }
  std::vector<std::vector<std::string>> rows;
  while (std::getline(file, line)) {
    rows.push_back(cells_of(line));
    if (rows.back().size() < least) {
      throw std::runtime_error(path + ": too few numbers in row " + std::to_string(rows.size()));
    }
  }
  return rows;
}

std::vector<Odometry> read_odometry(const std::string & path)
{
  std::vector<Odometry> poses;
  for (const auto & row : rows_of(path, 4)) {
    poses.push_back(
      {std::stoll(row[3]), {{std::stod(row[0]), std::stod(row[1])}, std::stod(row[2])}});
  }
  return poses;
}

/// A pose between two, and how fast it turns; nothing outside the record.
std::optional<std::pair<ScannerPose, double>> at_time(
  const std::vector<Odometry> & poses, std::int64_t stamp_ns)
{
  const auto after = std::lower_bound(
    poses.begin(), poses.end(), stamp_ns,
    [](const Odometry & pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.begin() || after == poses.end()) {
    return std::nullopt;
  }
  const Odometry & a = *(after - 1);
  const Odometry & b = *after;
  const double span_s = static_cast<double>(b.stamp_ns - a.stamp_ns) * 1e-9;
  const double part = static_cast<double>(stamp_ns - a.stamp_ns) * 1e-9 / span_s;
  const double turn = stetro_site::wrap_angle(b.pose.yaw_rad - a.pose.yaw_rad);
  ScannerPose pose;
  pose.position_m = (1.0 - part) * a.pose.position_m + part * b.pose.position_m;
  pose.yaw_rad = a.pose.yaw_rad + part * turn;
  return std::make_pair(pose, turn / span_s);
}

ScannerPose composed(const ScannerPose & a, const ScannerPose & b)
{
  return {
    a.position_m + rotation(a.yaw_rad) * b.position_m,
    stetro_site::wrap_angle(a.yaw_rad + b.yaw_rad)};
}

/// Odometry to map, tests/recorded/uw_tb4/README.md.
ScannerPose odometry_in_map(const std::string & run)
{
  if (run == "spiral") {
    return {{1.343, -2.934}, 0.0449};
  }
  if (run == "circle") {
    return {{1.561, -2.471}, 0.2259};
  }
  if (run == "line") {
    return {{1.284, -2.867}, 0.0701};
  }
  throw std::runtime_error("uw_tb4: no run '" + run + "'; there are spiral, circle and line");
}

/// A profile of even beams from points: each takes the nearest point of its sector.
stetro_supervisor::RangeProfile profile_of(const nlohmann::json & points)
{
  constexpr std::size_t kBeams = 600;
  stetro_supervisor::RangeProfile profile;
  profile.fan = {0.0, kTurn / static_cast<double>(kBeams), kBeams};
  profile.ranges_m.assign(kBeams, kInfinity);
  for (const auto & point : points) {
    const double x = point[0].get<double>();
    const double y = point[1].get<double>();
    const double range = std::hypot(x, y);
    const double turn = std::atan2(y, x) / profile.fan.step_rad;
    const auto whole = static_cast<std::int64_t>(kBeams);
    const auto beam = (static_cast<std::int64_t>(std::llround(turn)) + whole) % whole;
    double & nearest = profile.ranges_m[static_cast<std::size_t>(beam)];
    nearest = range > kOwnParts ? std::min(nearest, range) : nearest;
  }
  return profile;
}

}  // namespace

std::vector<RecordedScan> read_scans(const std::string & path)
{
  constexpr std::size_t kAhead = 6;  // numbers before the ranges
  std::vector<RecordedScan> scans;
  for (const auto & row : rows_of(path, kAhead + 2)) {
    RecordedScan scan;
    scan.stamp_ns = std::stoll(row[5]);
    scan.profile.fan = {std::stod(row[0]), std::stod(row[2]), row.size() - kAhead};
    const double least = std::stod(row[3]);
    const double most = std::stod(row[4]);
    for (std::size_t i = kAhead; i < row.size(); ++i) {
      const double range = std::stod(row[i]);
      scan.profile.ranges_m.push_back(
        range > most ? kInfinity : (range < least ? -kInfinity : range));
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

std::vector<RecordedScan> uw_scans(const std::string & folder, const std::string & run)
{
  const ScannerPose odom_in_map = odometry_in_map(run);
  const ScannerPose lidar_in_base{{0.0, 0.0}, kPi / 2.0};
  const auto odometry = read_odometry(folder + "/uw_tb4/odom_content_" + run + ".csv");
  std::vector<RecordedScan> scans;
  for (RecordedScan & scan : read_scans(folder + "/uw_tb4/laser_content_" + run + ".csv")) {
    if (const auto pose = at_time(odometry, scan.stamp_ns)) {
      scan.reference = composed(composed(odom_in_map, pose->first), lidar_in_base);
      scan.turning_rad_s = pose->second;
      scans.push_back(std::move(scan));
    }
  }
  return scans;
}

std::vector<RecordedScan> tau_scans(const std::string & folder)
{
  const auto read = [&folder](const std::string & name) {
    const std::string path = folder + "/tau_lab446a/" + name;
    std::ifstream file(path);
    if (!file) {
      throw std::runtime_error(path + ": cannot be read");
    }
    return nlohmann::json::parse(file);
  };
  const auto points = read("scans.json");
  const auto transforms = read("transforms.json");
  const ScannerPose first_in_map{{3.10, -4.98}, 1.64};
  std::vector<RecordedScan> scans;
  for (const std::string name : {"dev1", "dev2", "dev3", "dev4"}) {
    RecordedScan scan;
    scan.profile = profile_of(points.at(name));
    ScannerPose in_first;
    if (name != "dev1") {
      const auto & m = transforms.at(name).at("dev1");
      in_first = {
        {m[0][2].get<double>(), m[1][2].get<double>()},
        std::atan2(m[1][0].get<double>(), m[0][0].get<double>())};
    }
    scan.reference = composed(first_in_map, in_first);
    scans.push_back(std::move(scan));
  }
  return scans;
}

}  // namespace stetro_bringup
