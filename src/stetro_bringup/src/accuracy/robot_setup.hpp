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

#ifndef ACCURACY__ROBOT_SETUP_HPP_
#define ACCURACY__ROBOT_SETUP_HPP_

#include <string>

#include "stetro_driver/driver_setup.hpp"
#include "stetro_localizer/localizer_setup.hpp"
#include "stetro_supervisor/supervisor_setup.hpp"

namespace stetro_bringup
{

/// Where a setup is read from.
struct SetupFiles
{
  std::string site;
  std::string robot;
  std::string flight{};     ///< id; empty: the only one of the site
  std::string localizer{};  ///< the localizer's parameters that are not its defaults; empty: none
  std::string errors{};     ///< the simulator's errors that are not its defaults; empty: none
};

/// What driver, localizer and supervisor are made of.
/** Read once; any number of climbs may share it between threads. */
struct RobotSetup
{
  stetro_driver::DriverSetup driver;
  stetro_localizer::LocalizerSetup localizer;
  stetro_supervisor::SupervisorSetup supervisor;

  /// What the software believes; the world is made from driver.flight(), the same by default.
  [[nodiscard]] const stetro_site::Flight & flight() const { return localizer.flight; }
};

/// Reads the files.
/** \throws stetro_config::ConfigError with every fault of the files and of their fit */
[[nodiscard]] RobotSetup read_robot_setup(const SetupFiles & files);

}  // namespace stetro_bringup

#endif  // ACCURACY__ROBOT_SETUP_HPP_
