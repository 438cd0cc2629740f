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

#ifndef STETRO_DRIVER__SITE_SHAPE_HPP_
#define STETRO_DRIVER__SITE_SHAPE_HPP_

#include <string>

#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/building_shape.hpp"
#include "stetro_driver/stair_shape.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot.hpp"
#include "stetro_site/site.hpp"

namespace stetro_driver
{

/// The measures of a flight, as its site file gives them.
[[nodiscard]] StairShape shape_of(const stetro_site::Flight & flight);

/// A site as the simulator takes it.
/**
 * Floors and all flights if any floor is drawn; else the one flight alone, of which nothing but
 * the stairs is known. Walls are those of floors drawn as polygons; one drawn as a grid map has
 * none.
 * \param flight id of the one in whose frame the robot starts
 * \throws std::out_of_range naming the id and those there are
 */
[[nodiscard]] BuildingShape shape_of(const stetro_site::Site & site, const std::string & flight);

/// The measures of a robot, as its file gives them. What the file leaves open keeps its default.
[[nodiscard]] BodyShape shape_of(const stetro_site::Robot & robot);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SITE_SHAPE_HPP_
