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

#include "stetro_driver/driver_hardware.hpp"

#include <utility>

#include "stetro_driver/sim_robot.hpp"
#include "stetro_driver/site_shape.hpp"

namespace stetro_driver
{

DriverHardware make_hardware(const DriverSetup & setup)
{
  auto robot =
    std::make_unique<SimRobot>(building_of(setup), shape_of(setup.robot), sim_options(setup));
  SimRobot & simulated = *robot;
  return {std::move(robot), &simulated, &simulated};
}

}  // namespace stetro_driver
