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

#include <utility>

#include "stetro_config/loader.hpp"

namespace stetro_bringup
{
namespace
{

template <class Params>
Params loaded(const std::string & path, Params defaults, stetro_config::Faults & faults)
{
  stetro_config::Loader<Params> loader(std::move(defaults));
  if (!path.empty()) {
    loader.read_file(path);
  }
  return loader.finish(faults);
}

/// Site, robot and flight are those of the command line, whatever a file of parameters says.
template <class Params>
Params with_files(Params params, const SetupFiles & files)
{
  params.site_file = files.site;
  params.robot_file = files.robot;
  params.flight = files.flight;
  return params;
}

}  // namespace

RobotSetup read_robot_setup(const SetupFiles & files)
{
  stetro_config::Faults faults;
  stetro_driver::DriverParams driving;
  driving.sim.errors = loaded(files.errors, stetro_driver::SimErrors{}, faults);
  const auto locating =
    loaded(files.localizer, with_files(stetro_localizer::LocalizerParams{}, files), faults);
  auto driver = stetro_driver::read_setup(with_files(driving, files), faults);
  auto localizer = stetro_localizer::read_setup(with_files(locating, files), faults);
  auto supervisor =
    stetro_supervisor::read_setup(with_files(stetro_supervisor::SupervisorParams{}, files), faults);
  faults.throw_if_any();
  return {driver.value(), localizer.value(), supervisor.value()};
}

}  // namespace stetro_bringup
