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

#include "support/recorded_flight.hpp"

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "nlohmann/json.hpp"

namespace stetro_supervisor
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;

namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kResolution = 0.05;        // [m]
constexpr double kHalfFan = 6 * kPi / 180;  // [rad]
constexpr double kSameWall = 0.3;           // between ends of successive beams [m]
constexpr double kBesideWall = 0.15;        // rays beside the axis end this much earlier [m]
constexpr double kOccupiedShare = 0.3;
constexpr double kAxisWeight = 9.0;  // of the axis, against 1 of each of the 8 rays beside it

Eigen::Vector2d direction(double heading_rad)
{
  return {std::cos(heading_rad), std::sin(heading_rad)};
}

GridFrame flown_room()
{
  GridFrame frame;
  frame.columns = frame.rows = 96;
  frame.resolution_m = kResolution;
  frame.origin_m = {-1.6, -2.6};
  return frame;
}

/// How often beams ended in a cell and how often they passed it.
class BeamCounts
{
public:
  BeamCounts()
  : frame_(flown_room()),
    grid_(frame_, std::vector<Cell>(static_cast<std::size_t>(frame_.columns * frame_.rows))),
    ends_(grid_.cells().size(), 0.0),
    passes_(grid_.cells().size(), 0.0)
  {
  }

  void end_at(const Eigen::Vector2d & point_m)
  {
    count(ends_, grid_.cell_at(point_m), kAxisWeight);
  }

  void end_along(const Eigen::Vector2d & from_m, const Eigen::Vector2d & to_m)
  {
    const int steps = 1 + static_cast<int>((to_m - from_m).norm() / (kResolution / 2));
    for (int i = 1; i <= steps; ++i) {
      end_at(from_m + (to_m - from_m) * i / steps);
    }
  }

  void pass(const Eigen::Vector2d & from_m, double heading_rad, double length_m, double weight)
  {
    CellIndex before{-1, -1};
    for (double at_m = 0.0; at_m < length_m; at_m += kResolution / 4) {
      const CellIndex cell = grid_.cell_at(from_m + at_m * direction(heading_rad));
      if (!(cell == before)) {
        count(passes_, cell, weight);
        before = cell;
      }
    }
  }

  [[nodiscard]] OccupancyGrid map() const
  {
    std::vector<Cell> cells(ends_.size(), Cell::kUnknown);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double met = ends_[i] + passes_[i];
      if (ends_[i] > 0.0 && ends_[i] >= kOccupiedShare * met) {
        cells[i] = Cell::kOccupied;
      } else if (met > 0.0) {
        cells[i] = Cell::kFree;
      }
    }
    return OccupancyGrid(frame_, std::move(cells));
  }

private:
  void count(std::vector<double> & counts, CellIndex cell, double weight) const
  {
    if (grid_.contains(cell)) {
      counts[grid_.offset(cell)] += weight;
    }
  }

  GridFrame frame_;
  OccupancyGrid grid_;
  std::vector<double> ends_;
  std::vector<double> passes_;
};

}  // namespace

const std::array<double, 4> kFlightBeams{0.0, kPi / 2, kPi, -kPi / 2};

std::vector<FlightSample> read_flight(const std::string & path)
{
  try {
    std::ifstream file(path);
    std::vector<FlightSample> samples;
    for (const auto & record : nlohmann::json::parse(file)) {
      FlightSample sample;
      const auto number = [&](const char * name) { return record.at(name).get<double>(); };
      sample.ranges_m = {number("front"), number("left"), number("back"), number("right")};
      sample.position_m = {number("x"), number("y")};
      sample.heading_rad = number("yaw") + kPi;
      samples.push_back(sample);
    }
    return samples;
  } catch (const nlohmann::json::exception & fault) {
    throw std::runtime_error(path + ": " + fault.what());
  }
}

OccupancyGrid map_of(const std::vector<FlightSample> & samples)
{
  BeamCounts counts;
  for (std::size_t beam = 0; beam < kFlightBeams.size(); ++beam) {
    Eigen::Vector2d end_before_m(1e3, 1e3);  // far from all
    for (const FlightSample & sample : samples) {
      const double heading_rad = sample.heading_rad + kFlightBeams[beam];
      const double range_m = sample.ranges_m[beam];
      const Eigen::Vector2d end_m = sample.position_m + range_m * direction(heading_rad);
      if ((end_m - end_before_m).norm() < kSameWall) {
        counts.end_along(end_before_m, end_m);
      } else {
        counts.end_at(end_m);
      }
      end_before_m = end_m;
      counts.pass(sample.position_m, heading_rad, range_m - kResolution, kAxisWeight);
      for (const int ray : {-4, -3, -2, -1, 1, 2, 3, 4}) {
        counts.pass(
          sample.position_m, heading_rad + ray * kHalfFan / 4, range_m - kBesideWall, 1.0);
      }
    }
  }
  return counts.map();
}

std::vector<double> range_errors_m(
  const OccupancyGrid & map, const std::vector<FlightSample> & samples)
{
  std::vector<double> errors_m;
  for (const FlightSample & sample : samples) {
    for (std::size_t beam = 0; beam < kFlightBeams.size(); ++beam) {
      const Eigen::Vector2d along = direction(sample.heading_rad + kFlightBeams[beam]);
      double length_m = 0.0;
      const auto met = [&] { return map.at(map.cell_at(sample.position_m + length_m * along)); };
      while (met() == Cell::kFree) {
        length_m += kResolution / 20;
      }
      if (met() == Cell::kOccupied) {
        errors_m.push_back(sample.ranges_m[beam] - length_m);
      }
    }
  }
  return errors_m;
}

std::vector<FlightSample> every_other_block(
  const std::vector<FlightSample> & samples, std::size_t length, bool first)
{
  std::vector<FlightSample> chosen;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((i / length % 2 == 0) == first) {
      chosen.push_back(samples[i]);
    }
  }
  return chosen;
}

}  // namespace stetro_supervisor
