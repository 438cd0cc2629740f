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

#include "journey_plan.hpp"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/floor/drawn_floor.hpp"
#include "stetro_supervisor/floor/floor_drive.hpp"
#include "stetro_supervisor/floor/floor_params.hpp"
#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/floor/grid_planner.hpp"
#include "stetro_supervisor/floor/route.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_site::Flight;
using stetro_site::Floor;
using stetro_site::Pose;
using stetro_site::Site;
using stetro_supervisor::DrawnFloor;
using stetro_supervisor::FloorParams;
using stetro_supervisor::FloorPlace;
using stetro_supervisor::GridPlanner;

constexpr double kOffStairs_m = 1.5;     // from where a flight is taken up to the start, at least
constexpr int kTries = 10000;            // then the floor has no such place
constexpr char kKidnapOn[] = "kidnap:";  // a floor's id and a moment follow
constexpr double kSparedShare = 0.2;     // of a floor's driving, at either end, without a kidnap

/// Uniform in [from, to), the same with every standard library.
double drawn(std::mt19937_64 & random, double from, double to)
{
  return from + (to - from) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

/// Before a flight, where it is taken up.
FloorPlace foot_of(const Flight & flight, const Site & site, const FloorParams & params)
{
  const Pose foot{-params.foot_m, 0.5 * flight.width_m(0.0), 0.0, 0.0};
  return stetro_supervisor::on_floor(foot, site.floor(flight.spec().lower_floor), flight);
}

/// Behind a flight, where the robot has rolled off it.
FloorPlace end_of(const Flight & flight, const Site & site, const FloorParams & params)
{
  const double end_m = flight.total_run_m();
  const Pose off{end_m + params.roll_off_m, 0.5 * flight.width_m(end_m), 0.0, 0.0};
  return stetro_supervisor::on_floor(off, site.floor(flight.spec().upper_floor), flight);
}

class Planner
{
public:
  explicit Planner(const stetro_site::Deployment & deployment)
  : site_(deployment.site),
    clearance_m_(stetro_supervisor::body_radius_m(deployment.robot.geometry) + params_.margin_m)
  {
  }

  [[nodiscard]] const FloorParams & params() const { return params_; }

  /// Anywhere on a floor, clear of walls and stairs, with a way to a flight's foot.
  [[nodiscard]] FloorPlace draw(const Flight & flight, std::mt19937_64 & random) const
  {
    const DrawnFloor floor(site_, flight.spec().lower_floor, params_.resolution_m);
    const auto & field = *floor.drivable();
    const auto & grid = field.grid();
    const FloorPlace foot = foot_of(flight, site_, params_);
    const GridPlanner planner{floor.drivable(), clearance_m_};
    for (int i = 0; i < kTries; ++i) {
      const auto cell = grid.cell(
        static_cast<std::size_t>(drawn(random, 0.0, static_cast<double>(grid.cells().size()))));
      FloorPlace place = foot;
      place.position_m = grid.centre_m(cell);
      place.yaw_rad = drawn(random, -M_PI, M_PI);
      const bool apart = (place.position_m - foot.position_m).norm() >= kOffStairs_m;
      const bool room = field.distance_m(cell) >= clearance_m_;
      if (apart && room && planner.plan(place.position_m, foot.position_m).refusal.empty()) {
        return place;
      }
    }
    throw std::runtime_error("floor '" + foot.floor_id + "' has no room for the robot to start");
  }

  /// Least time to drive from a place to a flight's foot [s].
  [[nodiscard]] double to_foot_s(const FloorPlace & from, const Flight & flight) const
  {
    const DrawnFloor floor(site_, from.floor_id, params_.resolution_m);
    const FloorPlace foot = foot_of(flight, site_, params_);
    const auto path =
      GridPlanner{floor.drivable(), clearance_m_}.plan(from.position_m, foot.position_m);
    if (!path.refusal.empty()) {
      throw std::runtime_error(path.refusal);
    }
    return path.length_m() / params_.speed_m_s;
  }

private:
  const Site & site_;
  const FloorParams params_;
  const double clearance_m_;
};

}  // namespace

JourneyPlan plan_journey(
  const stetro_site::Deployment & deployment, const std::string & flight, const std::string & goal,
  std::uint64_t seed)
{
  const Site & site = deployment.site;
  const Flight & first = site.flight(flight);
  const auto route = stetro_supervisor::find_route(site, first.spec().lower_floor, goal);
  if (route.segments.empty()) {
    throw std::runtime_error(route.refusal);
  }
  const Planner planner(deployment);
  std::mt19937_64 random{seed};
  FloorPlace at = planner.draw(first, random);
  JourneyPlan plan;
  plan.start = stetro_supervisor::in_flight(at, site.floor(at.floor_id), first);
  double rolled_off_s = 0.0;
  for (const std::string & id : route.segments) {
    if (const Flight * next = site.find_flight(id)) {
      plan.floors.push_back({at.floor_id, rolled_off_s + planner.to_foot_s(at, *next)});
      at = end_of(*next, site, planner.params());
      rolled_off_s = planner.params().roll_off_m / planner.params().roll_off_m_s;
    }
  }
  plan.floors.push_back({at.floor_id, rolled_off_s});
  return plan;
}

std::vector<std::string> with_kidnaps_on_floors(
  const std::vector<std::string> & faults, const std::vector<FloorDriving> & floors,
  std::uint64_t seed)
{
  std::vector<std::string> all;
  for (const std::string & fault : faults) {
    if (fault != "kidnap") {
      all.push_back(fault);
      continue;
    }
    std::mt19937_64 random{seed};
    for (const FloorDriving & driving : floors) {
      const double spared_s = kSparedShare * driving.least_s;
      const double moment_s = drawn(random, spared_s, driving.least_s - spared_s);
      std::array<char, 40> text{};
      std::snprintf(text.data(), text.size(), "@%.2f", moment_s);
      all.push_back(kKidnapOn + driving.floor + text.data());
    }
  }
  return all;
}

std::vector<std::string> floors_of_kidnaps(const std::vector<std::string> & faults)
{
  const std::string begins = kKidnapOn;
  std::vector<std::string> floors;
  for (const std::string & fault : faults) {
    if (fault.rfind(begins, 0) == 0) {
      floors.push_back(fault.substr(begins.size(), fault.find('@') - begins.size()));
    }
  }
  return floors;
}

}  // namespace stetro_bringup
