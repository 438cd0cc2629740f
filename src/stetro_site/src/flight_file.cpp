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

#include "flight_file.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "metres.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Any;
using stetro_config::AtLeast;
using stetro_config::Each;
using stetro_config::Identifier;
using stetro_config::MapReader;
using stetro_config::OneOf;
using stetro_config::Within;

constexpr double kRounding = 1e-9;  // [m] what sums of doubles leave behind
constexpr Within kRiser{0.02, 0.5};
constexpr Within kTread{0.1, 5.0};
constexpr Within kYaw{-3.1416, 3.1416};

Side read_side(MapReader & sides, const std::string & key)
{
  return sides.require<std::string>(key, OneOf{"walled", "open"}) == "open" ? Side::kOpen
                                                                            : Side::kWalled;
}

/// Equal steps, then those that differ.
std::vector<Step> read_steps(MapReader & map)
{
  const auto count = map.require<std::int64_t>("steps", Within{1, 500});
  const auto riser_m = map.require<double>("riser_m", kRiser);
  const auto tread_m = map.require<double>("tread_m", kTread);
  auto steps = equal_steps(static_cast<int>(count), riser_m, tread_m);
  std::set<std::int64_t> seen;
  for (MapReader & exception : map.find_maps("exceptions")) {
    const auto i = exception.require<std::int64_t>("step", Within{1, static_cast<double>(count)});
    const auto riser = exception.find<double>("riser_m", kRiser);
    const auto tread = exception.find<double>("tread_m", kTread);
    exception.finish();
    if (!exception.sound() || count == 0) {
      continue;
    }
    if (!riser && !tread) {
      exception.refuse("step", std::to_string(i), "an exception with riser_m, tread_m or both");
    } else if (!seen.insert(i).second) {
      exception.refuse("step", std::to_string(i), "one exception for each step");
    } else {
      Step & step = steps[static_cast<std::size_t>(i) - 1];
      step = {riser.value_or(step.riser_m), tread.value_or(step.tread_m)};
    }
  }
  return steps;
}

/// "16 x 0.14", or what it takes when steps differ.
std::string count_of(const MapReader & map, const Flight & flight, double Step::*length)
{
  const double first = flight.spec().steps.front().*length;
  for (const Step & step : flight.spec().steps) {
    if (step.*length != first) {
      return "the sum of " + std::to_string(flight.steps()) + " with the exceptions of " +
             map.name_of("exceptions");
    }
  }
  return std::to_string(flight.steps()) + " x " + metres(first);
}

std::string differing(double given_m, double sum_m)
{
  return "differs by " + metres(std::abs(given_m - sum_m));
}

void check_height(MapReader & map, const Flight & flight, double tolerance_m, double given_m)
{
  const double sum_m = flight.total_rise_m();
  if (std::abs(given_m - sum_m) > tolerance_m + kRounding) {
    map.refuse(
      "total_height_m", metres(given_m),
      metres(sum_m) + " = " + count_of(map, flight, &Step::riser_m) + " risers, within " +
        metres(tolerance_m) + " (" + differing(given_m, sum_m) + ")");
  }
}

// The papers give L = 480 for 16 treads of 32: 15 x 32, between the outer tread centres (D1-10).
void check_length(
  MapReader & map, const Flight & flight, double tolerance_m, double given_m,
  std::vector<std::string> & notes)
{
  const double whole_m = flight.total_run_m();
  const double centres_m = flight.centre_to_centre_m();
  if (std::abs(given_m - whole_m) <= tolerance_m + kRounding) {
    return;
  }
  const std::string centres = "from the first tread's centre to the last's";
  if (std::abs(given_m - centres_m) <= tolerance_m + kRounding) {
    notes.push_back(
      map.name_of("total_length_m") + ": " + metres(given_m) + " is the length " + centres +
      "; all treads together are " + metres(whole_m));
    return;
  }
  map.refuse(
    "total_length_m", metres(given_m),
    metres(whole_m) + " = " + count_of(map, flight, &Step::tread_m) + " treads (" +
      differing(given_m, whole_m) + "), or " + metres(centres_m) + " " + centres + " (" +
      differing(given_m, centres_m) + "), within " + metres(tolerance_m));
}

}  // namespace

Pose read_pose(MapReader map, bool with_z)
{
  Pose pose;
  pose.x_m = map.require<double>("x_m", Any{});
  pose.y_m = map.require<double>("y_m", Any{});
  pose.z_m = with_z ? map.require<double>("z_m", Any{}) : 0.0;
  pose.yaw_rad = map.require<double>("yaw_rad", kYaw);
  map.finish();
  return pose;
}

std::optional<Flight> read_flight(
  MapReader & map, double tolerance_m, std::vector<std::string> & notes)
{
  FlightSpec spec;
  spec.id = map.require<std::string>("id", Identifier{});
  const auto joins = map.require<std::vector<std::string>>("joins", Each{Identifier{}, 2, 2});
  spec.steps = read_steps(map);
  spec.width_foot_m = map.require<double>("width_m", Within{0.2, 20.0});
  spec.width_top_m = spec.width_foot_m;
  MapReader sides = map.require_map("sides");
  spec.right = read_side(sides, "right");
  spec.left = read_side(sides, "left");
  sides.finish();
  spec.wall_overrun_m = map.optional("wall_overrun_m", spec.wall_overrun_m, Within{0.0, 20.0});
  spec.pose_in_map = read_pose(map.require_map("pose"), true);
  const auto height_m = map.find<double>("total_height_m", AtLeast{0.0});
  const auto length_m = map.find<double>("total_length_m", AtLeast{0.0});
  map.finish();
  if (!map.sound()) {
    return std::nullopt;
  }
  spec.lower_floor = joins[0];
  spec.upper_floor = joins[1];
  Flight flight{std::move(spec)};
  if (height_m) {
    check_height(map, flight, tolerance_m, *height_m);
  }
  if (length_m) {
    check_length(map, flight, tolerance_m, *length_m, notes);
  }
  return flight;
}

}  // namespace stetro_site
