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
#include "stetro_bringup/robot.hpp"

namespace stetro_bringup
{

RobotConfiguration configure_robot(stetro_dds::Launch & launch)
{
  const auto driver = launch.configure<stetro_driver::DriverParams>("driver", "/stetro");
  const auto setup = stetro_driver::read_setup(driver.params, launch.faults());
  auto localizer = launch.configure<stetro_localizer::LocalizerParams>("localizer", "/stetro");
  auto supervisor = launch.configure<stetro_supervisor::SupervisorParams>("supervisor", "/stetro");
  if (driver.params.hardware != "linux") {  // who simulates the robot makes the time of all three
    localizer.options.time = supervisor.options.time = stetro_dds::TimeSource::kClockTopic;
  }
  const auto climb = stetro_supervisor::read_setup(supervisor.params, launch.faults());
  const auto stairs = stetro_localizer::read_setup(localizer.params, launch.faults());
  launch.check();
  return {driver.options, setup.value(),      localizer.options,
          stairs.value(), supervisor.options, climb.value()};
}

Robot::Robot(stetro_dds::Context & context, const RobotConfiguration & configuration)
: driver_(context, configuration.driver_options, configuration.driver),
  localizer_(context, configuration.localizer_options, configuration.localizer),
  supervisor_(context, configuration.supervisor_options, configuration.supervisor)
{
  executor_.add(driver_.node());
  executor_.add(localizer_.node());
  executor_.add(supervisor_.node());
  driver_.start();
}

void Robot::step()
{
  driver_.step();
  executor_.drain();
}

void Robot::tell_diagnostics()
{
  for (stetro_dds::Node * node : {&driver_.node(), &localizer_.node(), &supervisor_.node()}) {
    node->diagnostics().publish();
  }
  executor_.drain();
}

void Robot::run(const std::function<bool()> & stop)
{
  driver_.run(executor_, stop);
  supervisor_.hold();
}

}  // namespace stetro_bringup
