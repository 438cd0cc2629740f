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

#include "stetro_supervisor/floor/range_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "stetro_supervisor/robot_health.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kQuarter_rad = 1.5707963267948966;
constexpr double kFresh_s = 0.5;
constexpr double kShare = 0.03;          // of the range: a cone at a slant, and the sensor's gain
constexpr double kOnePlace_m = 0.40;     // along either axis
constexpr double kOneDirection = 0.985;  // length of the mean direction: headings within 0.3 rad

// What a tick may do and what a cell costs, as in FloorSearch.
constexpr std::size_t kWorkATick = 4000000;
constexpr std::size_t kWorkACell = 100;

/// A sensor, and how many quarters of a turn to the left it looks.
struct Sensor
{
  stetro_site::Place place;
  int quarters;
};

constexpr std::array<Sensor, 4> kSensors{
  {{stetro_site::Place::kFrontLeft, 0},
   {stetro_site::Place::kFrontRight, 0},
   {stetro_site::Place::kSideLeft, 1},
   {stetro_site::Place::kSideRight, 3}}};

double said_m(const Range & range)
{
  switch (range.status) {
    case RangeStatus::kValid:
      return range.range_m;
    case RangeStatus::kNoTarget:
      return kInfinity;
    case RangeStatus::kTooNear:
      return -kInfinity;
    default:
      return std::nan("");
  }
}

std::string square_metres(double area_m2)
{
  const std::string text = std::to_string(area_m2);
  return text.substr(0, text.size() - 5) + " m2";
}

}  // namespace

RangeBeams range_beams_of(
  const Observation & seen, Time now, const stetro_site::RobotGeometry & robot,
  const FloorParams & params)
{
  RangeBeams found;
  for (const Sensor & sensor : kSensors) {
    const auto & range = seen.range(sensor.place);
    if (older_than(range, now, kFresh_s) || std::isnan(said_m(*range))) {
      continue;
    }
    const stetro_site::Mounting & mounting = robot.at(sensor.place);
    RangeBeam beam;
    beam.origin_m = {mounting.x_m, mounting.y_m};
    beam.yaw_rad = sensor.quarters * kQuarter_rad;
    beam.error.short_m = beam.error.long_m = params.beam_error_m;
    beam.error.short_share = beam.error.long_share = kShare;
    beam.error.dependable_m = robot.range_sensor.reliable_range_m;
    beam.error.too_near_m = robot.range_sensor.min_range_m + params.beam_error_m;
    found.beams.push_back(beam);
    found.ranges_m.push_back(said_m(*range));
  }
  return found;
}

RangeSearch::RangeSearch(std::vector<ProfileWitness *> witnesses, RangeBeams beams)
: witnesses_(std::move(witnesses)),
  beams_(std::move(beams)),
  lowest_m_(kInfinity, kInfinity),
  highest_m_(-kInfinity, -kInfinity)
{
}

std::optional<RangeAnswer> RangeSearch::step()
{
  for (std::size_t work = 0; work < kWorkATick && floor_ < witnesses_.size();) {
    work += go_on(kWorkATick - work);
  }
  return floor_ < witnesses_.size() ? std::nullopt : std::optional<RangeAnswer>{answer()};
}

std::size_t RangeSearch::go_on(std::size_t work)
{
  HeadingTables & tables = witnesses_[floor_]->headings();
  if (!tables.is_built(heading_)) {
    return tables.build(heading_, work);
  }
  const auto & grid = witnesses_[floor_]->floor().grid();
  cells_.resize(grid.cells().size(), false);
  const std::size_t cost = look_up(work);
  if (next_ == grid.cells().size()) {
    next_ = 0;
    if (++heading_ == tables.headings()) {
      end_floor();
    }
  }
  return cost;
}

/// Cells that all ranges agree with, if base_link faces along the present heading.
std::size_t RangeSearch::look_up(std::size_t work)
{
  const DrawnFloor & floor = witnesses_[floor_]->floor();
  const HeadingTables & tables = witnesses_[floor_]->headings();
  const auto & grid = floor.grid();
  const double yaw_rad = tables.heading_rad(heading_);
  struct Asked
  {
    const ReachTable * table;
    ShiftedStart start;
    DistanceBounds bounds;
  };
  std::vector<Asked> asked;
  for (std::size_t i = 0; i < beams_.beams.size(); ++i) {
    const RangeBeam & beam = beams_.beams[i];
    const auto quarters = static_cast<std::size_t>(std::llround(beam.yaw_rad / kQuarter_rad));
    const auto bounds = distance_bounds(beams_.ranges_m[i], beam.error, grid.resolution_m());
    const Eigen::Vector2d shift =
      rotation(yaw_rad - grid.frame().yaw_rad) * beam.origin_m / grid.resolution_m();
    asked.push_back(
      {&tables.towards(heading_, quarters * kScanBeams / 4), ShiftedStart(shift), bounds.value()});
  }
  std::size_t cost = 0;
  for (; cost < work && next_ < grid.cells().size(); ++next_) {
    cost += kWorkACell;
    if (grid.cells()[next_] != stetro_site::Cell::kFree) {
      continue;
    }
    const bool agree = std::all_of(asked.begin(), asked.end(), [&](const Asked & one) {
      const Reach reach = one.start.reach(
        grid, grid.cell(next_),
        [&](stetro_site::CellIndex start) { return one.table->at(grid.offset(start)); });
      return reach.allows(one.bounds.shortest, one.bounds.longest);
    });
    if (agree && fits(floor, grid.centre_m(grid.cell(next_)), yaw_rad)) {
      note(floor, next_, yaw_rad);
    }
  }
  return cost;
}

/// No sensor is behind a wall, where the map knows nothing and every range may come from.
bool RangeSearch::fits(
  const DrawnFloor & floor, const Eigen::Vector2d & base_m, double yaw_rad) const
{
  return std::all_of(beams_.beams.begin(), beams_.beams.end(), [&](const RangeBeam & beam) {
    return floor.free_space().is_free(base_m + rotation(yaw_rad) * beam.origin_m);
  });
}

void RangeSearch::note(const DrawnFloor & floor, std::size_t offset, double yaw_rad)
{
  const Eigen::Vector2d centre_m = floor.grid().centre_m(floor.grid().cell(offset));
  cells_[offset] = true;
  lowest_m_ = lowest_m_.cwiseMin(centre_m);
  highest_m_ = highest_m_.cwiseMax(centre_m);
  sum_m_ += centre_m;
  facing_ += Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
  cell_m_ = std::max(cell_m_, floor.grid().resolution_m());
  ++places_;
}

void RangeSearch::end_floor()
{
  const auto & grid = witnesses_[floor_]->floor().grid();
  const double cell_m2 = grid.resolution_m() * grid.resolution_m();
  const auto free = std::count(grid.cells().begin(), grid.cells().end(), stetro_site::Cell::kFree);
  const auto left = std::count(cells_.begin(), cells_.end(), true);
  free_m2_ += cell_m2 * static_cast<double>(free);
  area_m2_ += cell_m2 * static_cast<double>(left);
  if (left > 0) {
    on_.push_back(witnesses_[floor_]->floor().id());
  }
  cells_.clear();
  heading_ = 0;
  ++floor_;
}

RangeAnswer RangeSearch::answer() const
{
  RangeAnswer answer;
  answer.area_m2 = area_m2_;
  const std::string ranges = std::to_string(beams_.beams.size()) + " ranges without a lidar: ";
  if (places_ == 0) {
    answer.reason = ranges + "no place agrees with all of them";
    return answer;
  }
  const auto count = static_cast<double>(places_);
  const Eigen::Vector2d size_m = highest_m_ - lowest_m_ + Eigen::Vector2d(cell_m_, cell_m_);
  const double together = facing_.norm() / count;
  answer.reason = ranges + square_metres(area_m2_) + " of " + square_metres(free_m2_) +
                  " agree, on " + std::to_string(on_.size()) + " floors";
  if (on_.size() > 1 || size_m.maxCoeff() > kOnePlace_m || together < kOneDirection) {
    answer.verdict = Verdict::kAmbiguous;
    return answer;
  }
  answer.verdict = Verdict::kCorrected;
  FloorPlace place{
    on_.front(), sum_m_ / count, std::atan2(facing_.y(), facing_.x()), Eigen::Matrix3d::Zero()};
  const Eigen::Vector2d sigma_m = 0.5 * size_m;
  const double sigma_rad = std::acos(kOneDirection);
  place.covariance.diagonal() << sigma_m.x() * sigma_m.x(), sigma_m.y() * sigma_m.y(),
    sigma_rad * sigma_rad;
  answer.found = place;
  return answer;
}

}  // namespace stetro_supervisor
