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

#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/stair_shape.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot.hpp"

namespace stetro_driver
{

/// The measures of a flight, as its site file gives them.
[[nodiscard]] StairShape shape_of(const stetro_site::Flight & flight);

/// The measures of a robot, as its file gives them. What the file leaves open keeps its default.
[[nodiscard]] BodyShape shape_of(const stetro_site::Robot & robot);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SITE_SHAPE_HPP_
