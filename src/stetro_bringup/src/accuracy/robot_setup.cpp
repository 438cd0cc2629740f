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

#include "accuracy/robot_setup.hpp"

namespace stetro_bringup
{
namespace
{

template <class Params>
Params params_for(
  const std::string & site_file, const std::string & robot_file, const std::string & flight)
{
  Params params;
  params.site_file = site_file;
  params.robot_file = robot_file;
  params.flight = flight;
  return params;
}

}  // namespace

RobotSetup read_robot_setup(
  const std::string & site_file, const std::string & robot_file, const std::string & flight)
{
  stetro_config::Faults faults;
  auto driver = stetro_driver::read_setup(
    params_for<stetro_driver::DriverParams>(site_file, robot_file, flight), faults);
  auto localizer = stetro_localizer::read_setup(
    params_for<stetro_localizer::LocalizerParams>(site_file, robot_file, flight), faults);
  auto supervisor = stetro_supervisor::read_setup(
    params_for<stetro_supervisor::SupervisorParams>(site_file, robot_file, flight), faults);
  faults.throw_if_any();
  return {driver.value(), localizer.value(), supervisor.value()};
}

}  // namespace stetro_bringup
