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
#ifndef STETRO_BRINGUP__ROBOT_HPP_
#define STETRO_BRINGUP__ROBOT_HPP_

#include <functional>

#include "stetro_dds/context.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_driver/driver_node.hpp"
#include "stetro_driver/driver_setup.hpp"
#include "stetro_localizer/localizer_node.hpp"
#include "stetro_localizer/localizer_setup.hpp"
#include "stetro_supervisor/supervisor_node.hpp"
#include "stetro_supervisor/supervisor_setup.hpp"

namespace stetro_bringup
{

/// Parameters of the three nodes.
struct RobotConfiguration
{
  stetro_dds::NodeOptions driver_options;
  stetro_driver::DriverSetup driver;
  stetro_dds::NodeOptions localizer_options;
  stetro_localizer::LocalizerSetup localizer;
  stetro_dds::NodeOptions supervisor_options;
  stetro_supervisor::SupervisorSetup supervisor;
};

/// Reads the parameters of all three.
/** \throws stetro_config::ConfigError with every fault of every node, site and robot file */
[[nodiscard]] RobotConfiguration configure_robot(stetro_dds::Launch & launch);

/// Driver, localizer and supervisor in one process, on one executor.
/**
 * Nothing but the process differs from three: the nodes talk by messages all the same, delivered
 * without the network. Time is the driver's to make: step() for a repeatable run, run() for one that
 * keeps pace with the clock on the wall.
 */
class Robot
{
public:
  /// Builds the nodes and starts the driver, standing and holding.
  /** \throws stetro_driver::HardwareError when the hardware cannot be configured */
  Robot(stetro_dds::Context & context, const RobotConfiguration & configuration);

  /// Adds a node that is to live on the robot's executor, after the robot's own.
  void add(stetro_dds::Node & node) { executor_.add(node); }

  /// One tick of the driver, and everything that follows from it.
  void step();

  /// Has every node tell its diagnostics now, between two ticks, and whoever is here hear them.
  void tell_diagnostics();

  /// Ticks at the driver's pace until `stop` says so, then leaves the robot standing.
  void run(const std::function<bool()> & stop);

private:
  stetro_driver::DriverNode driver_;
  stetro_localizer::LocalizerNode localizer_;
  stetro_supervisor::SupervisorNode supervisor_;
  stetro_dds::Executor executor_;
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__ROBOT_HPP_
