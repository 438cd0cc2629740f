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

#include "profiles/profile_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "profiles/median.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_supervisor::Beams;
using stetro_supervisor::rotation;
using stetro_supervisor::ScannerPose;

constexpr double kReach = 12.0;
constexpr double kAgrees = 0.15;  // of a picture, a glance's worth [m]
constexpr double kOnWall = 0.10;
constexpr double kAround = 9.0;  // of the walls about a scan that are drawn [m]
constexpr double kMostSigma = 1.0;
constexpr double kMostRadius = 3.0;

std::ofstream opened(const std::string & path)
{
  std::ofstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": cannot be written");
  }
  return file;
}

template <class Draws>
void write_walls(const RecordedFloor & floor, const std::string & path, const Draws & draws)
{
  auto file = opened(path);
  file << "x_m,y_m\n";
  for (std::size_t i = 0; floor.grid && i < floor.grid->cells().size(); ++i) {
    const Eigen::Vector2d at = floor.grid->centre_m(floor.grid->cell(i));
    if (floor.grid->cells()[i] == stetro_site::Cell::kOccupied && draws(at)) {
      file << at.x() << ',' << at.y() << '\n';
    }
  }
}

/// What became of a beam, seen from the pose that was found.
const char * fate_of(const RecordedFloor & floor, const Eigen::Vector2d & end, double error_m)
{
  if (std::abs(error_m) <= kAgrees) {
    return "agrees";
  }
  if (floor.walls && floor.walls->clearance_m(end) <= kOnWall) {
    return "behind";  // on a wall of the map, through one that is no more
  }
  return error_m < 0.0 ? "shorter" : "longer";
}

/// One scan drawn at the pose that was found for it.
class ScanPicture
{
public:
  ScanPicture(const RecordedLog & log, const RecordedScan & scan, const LogCase & one)
  : log_(log), scan_(scan), one_(one), beams_(scan.profile)
  {
    log.floor.map->cast(one.found.position_m, beams_.fan_at(one.found.yaw_rad), kReach, model_m_);
  }

  void write_scan(const std::string & path)
  {
    auto file = opened(path);
    file << "x_m,y_m,model_x_m,model_y_m,fate\n";
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      const double range = beams_.ranges_m()[i];
      if (!std::isfinite(range)) {
        continue;
      }
      const Eigen::Vector2d end = end_of(i, range);
      const Eigen::Vector2d model = end_of(i, std::min(model_m_[i], kReach));
      file << end.x() << ',' << end.y() << ',' << model.x() << ',' << model.y() << ','
           << fate_of(log_.floor, end, range - model_m_[i]) << '\n';
    }
  }

  void write_places(const std::string & path)
  {
    auto file = opened(path);
    file << "what,x_m,y_m\n";
    const auto write = [&file](const char * what, const Eigen::Vector2d & at) {
      file << what << ',' << at.x() << ',' << at.y() << '\n';
    };
    write("reference", scan_.reference.position_m);
    write("found", one_.found.position_m);
    write("published", one_.believed.position_m);
    stetro_supervisor::PublishedLimits limits;
    limits.reach_m = kReach;
    for (const auto & at :
         stetro_supervisor::published_search(*log_.floor.map, beams_, one_.believed, limits)
           .positions_m) {
      write("published", at);
    }
    write_centroid(file, "centroid_scan_all", beams_.ranges_m(), false);
    write_centroid(file, "centroid_map_all", model_m_, false);
    write_centroid(file, "centroid_scan", beams_.ranges_m(), true);
    write_centroid(file, "centroid_map", model_m_, true);
  }

private:
  [[nodiscard]] Eigen::Vector2d end_of(std::size_t i, double range_m) const
  {
    return one_.found.position_m +
           rotation(one_.found.yaw_rad) * (range_m * beams_.directions()[i]);
  }

  void write_centroid(
    std::ofstream & file, const char * what, std::vector<double> ranges_m, bool agreeing) const
  {
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
      const bool counts = !agreeing || std::abs(beams_.ranges_m()[i] - model_m_[i]) <= kAgrees;
      ranges_m[i] = counts && std::isfinite(beams_.ranges_m()[i])
                      ? ranges_m[i]
                      : std::numeric_limits<double>::infinity();
    }
    if (const auto moments = stetro_supervisor::moments_of(beams_, ranges_m)) {
      const Eigen::Vector2d at =
        one_.found.position_m + rotation(one_.found.yaw_rad) * moments->centroid_m;
      file << what << ',' << at.x() << ',' << at.y() << '\n';
    }
  }

  const RecordedLog & log_;
  const RecordedScan & scan_;
  const LogCase & one_;
  Beams beams_;
  std::vector<double> model_m_;
};

}  // namespace

void ProfilePictures::add_maps(const std::vector<RecordedFloor> & floors)
{
  for (const RecordedFloor & floor : floors) {
    const std::string name = floor.name + (floor.level.empty() ? "" : "_" + floor.level);
    auto file = opened(folder + "/usability_" + name + ".csv");
    file << "x_m,y_m,spectral_radius,published_radius,worst_sigma_m\n";
    const auto & layer = *floor.layer;
    for (int row = 0; row < layer.rows(); ++row) {
      for (int column = 0; column < layer.columns(); ++column) {
        const auto & place = layer.of(column, row);
        if (!std::isnan(place.spectral_radius)) {
          const Eigen::Vector2d at = layer.place_m(column, row);
          file << at.x() << ',' << at.y() << ',' << std::min(place.spectral_radius, kMostRadius)
               << ',' << std::min(place.published_radius, kMostRadius) << ','
               << std::min(place.worst_sigma_m, kMostSigma) << '\n';
        }
      }
    }
    write_walls(floor, folder + "/walls_" + name + ".csv", [](const auto &) { return true; });
    maps.push_back(name);
  }
}

void ProfilePictures::add_convergence(const std::vector<MapsTable> & tables)
{
  constexpr std::array<const char *, kRadiusClasses> kNames{"below 0.5", "0.5 to 1", "above 1"};
  auto file = opened(folder + "/convergence.csv");
  file << "radius,step,median_error_m\n";
  for (std::size_t kind = 0; kind < kRadiusClasses; ++kind) {
    for (std::size_t step = 0; step < kDrawnSteps; ++step) {
      std::vector<double> errors;
      for (const MapsTable & table : tables) {
        const auto & more = table.published_errors_m[kind][step];
        errors.insert(errors.end(), more.begin(), more.end());
      }
      if (!errors.empty()) {
        file << kNames[kind] << ',' << step << ',' << median(errors) << '\n';
      }
    }
  }
  convergence = true;
}

void ProfilePictures::add_logs(const std::vector<RecordedLog> & recorded, std::uint64_t seed)
{
  for (const RecordedLog & log : recorded) {
    const std::size_t middle = log.scans.size() / 2;
    const LogCase one = check_scan(log, middle, seed);
    ScanPicture picture(log, log.scans[middle], one);
    picture.write_scan(folder + "/scan_" + log.name + ".csv");
    picture.write_places(folder + "/places_" + log.name + ".csv");
    const auto is_near = [&one](const Eigen::Vector2d & at) {
      return (at - one.found.position_m).norm() < kAround;
    };
    write_walls(log.floor, folder + "/walls_" + log.name + ".csv", is_near);
    logs.push_back(log.name);
  }
}

}  // namespace stetro_bringup
