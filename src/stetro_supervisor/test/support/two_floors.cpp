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

#include "support/two_floors.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::FlightSpec;
using stetro_site::Floor;
using stetro_site::Polygon;
using stetro_site::Pose;

constexpr double kRiser_m = 0.14;
constexpr double kTread_m = 0.32;
constexpr double kWidth_m = 2.05;
constexpr double kFoot_m = 5.0;  // x of the lower flight's first riser

Polygon in_frame(const Polygon & on_map, const Pose & frame)
{
  const stetro_site::FrameTransform T_map_frame{frame};
  Polygon corners;
  for (const auto & corner : on_map) {
    corners.push_back(T_map_frame.to_frame(Eigen::Vector3d{corner.x(), corner.y(), 0.0}).head<2>());
  }
  return corners;
}

Floor floor(const char * id, const Pose & frame, const Polygon & outline)
{
  return {id, frame, stetro_site::PolygonWalls{in_frame(outline, frame), {}}};
}

FlightSpec flight(const char * id, int steps, const Pose & pose, const char * from, const char * to)
{
  FlightSpec spec;
  spec.id = id;
  spec.steps = stetro_site::equal_steps(steps, kRiser_m, kTread_m);
  spec.width_foot_m = spec.width_top_m = kWidth_m;
  spec.wall_overrun_m = 0.0;
  spec.pose_in_map = pose;
  spec.lower_floor = from;
  spec.upper_floor = to;
  return spec;
}

}  // namespace

stetro_site::Site two_floors(int lower_steps, int upper_steps)
{
  const double top = kFoot_m + lower_steps * kTread_m;
  const double end = top - upper_steps * kTread_m;
  const double rise = lower_steps * kRiser_m;
  stetro_site::SiteSpec spec;
  spec.name = "two_floors";
  const double seen = kFoot_m + std::min(3, lower_steps) * kTread_m;  // over the first risers
  spec.floors.push_back(floor(
    "ground", Pose{},
    {{0.0, 0.0},
     {seen, 0.0},
     {seen, 2.05},
     {5.0, 2.05},
     {5.0, 4.0},
     {1.2, 4.0},
     {1.2, 3.2},
     {0.0, 3.2}}));
  std::get<stetro_site::PolygonWalls>(spec.floors[0].drawing).obstacles = {
    {{2.3, 1.8}, {2.7, 1.8}, {2.7, 2.2}, {2.3, 2.2}}};
  const double back = top - std::min(3, upper_steps) * kTread_m;
  spec.floors.push_back(floor(
    "landing", {0.0, 0.0, rise, 0.0},
    {{kFoot_m, 0.0},
     {top + 2.5, 0.0},
     {top + 2.5, 4.6},
     {back, 4.6},
     {back, 2.55},
     {top, 2.55},
     {top, 2.05},
     {kFoot_m, 2.05}}));
  const Pose first{1.0, 2.0, rise + upper_steps * kRiser_m, 0.3};
  spec.floors.push_back(floor(
    "first", first,
    {{end - 4.5, 2.55},
     {top, 2.55},
     {top, 4.6},
     {end, 4.6},
     {end, 7.0},
     {end - 3.7, 7.0},
     {end - 3.7, 6.2},
     {end - 4.5, 6.2}}));
  spec.flights.emplace_back(
    flight("lower", lower_steps, {kFoot_m, 0.0, 0.0, 0.0}, "ground", "landing"));
  spec.flights.emplace_back(
    flight("upper", upper_steps, {top, 4.6, rise, 3.14159265358979312}, "landing", "first"));
  return stetro_site::Site(std::move(spec));
}

}  // namespace stetro_supervisor
