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

#ifndef BUILDINGS_HPP_
#define BUILDINGS_HPP_

#include <string>

#include "stetro_driver/building_shape.hpp"
#include "stetro_driver/site_shape.hpp"
#include "stetro_site/site.hpp"

namespace stetro_driver::test
{

inline stetro_site::Polygon rectangle(double min_x, double min_y, double max_x, double max_y)
{
  return {{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}};
}

/// A flight between two floors that nobody has drawn.
inline stetro_site::Site site_of(const stetro_site::FlightSpec & flight)
{
  stetro_site::SiteSpec site;
  site.name = "site";
  stetro_site::Floor floor;
  floor.id = flight.lower_floor;
  site.floors.push_back(floor);
  floor.id = flight.upper_floor;
  floor.pose_in_map.z_m = 2.24;
  site.floors.push_back(floor);
  site.flights.emplace_back(flight);
  return stetro_site::Site{site};
}

/// The papers' stairs.
inline stetro_site::FlightSpec paper_flight()
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = 2.05;
  spec.width_top_m = 2.05;
  spec.lower_floor = "ground";
  spec.upper_floor = "first";
  return spec;
}

/// The building of two floors that is shipped, entered at one of its flights.
inline BuildingShape two_floors(const std::string & flight = "lower")
{
  return shape_of(stetro_site::load_site(SITES "two_floors.yaml"), flight);
}

}  // namespace stetro_driver::test

#endif  // BUILDINGS_HPP_
