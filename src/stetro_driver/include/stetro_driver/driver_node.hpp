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

#ifndef STETRO_DRIVER__DRIVER_NODE_HPP_
#define STETRO_DRIVER__DRIVER_NODE_HPP_

#include <functional>
#include <memory>

#include "stetro_dds/executor.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_driver/driver_hardware.hpp"
#include "stetro_driver/driver_setup.hpp"

namespace stetro_driver
{

/// The driver on the wire: what the robot senses goes out, commands come in and run out.
/**
 * A world that waits for its steps leaves time to this node. Two ways to let it pass:
 *
 *   step()  one tick per call and no clock read: a process that holds all nodes calls it and
 *           drains the executor after each, and its run is repeatable;
 *   run()   ticks at `sim.speed` of the steady clock, slower when localizer or supervisor fall
 *           behind (Pacer).
 *
 * The time of a real robot, or of an emulated one, passes by itself: only run(), which keeps a
 * control loop of fixed rate in a thread of its own.
 *
 * Everything else belongs to the executor's thread.
 */
class DriverNode
{
public:
  /// Opens the topics, around the robot that the parameters name.
  /** \param options of the node; its time is the robot's, whatever they say */
  DriverNode(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup);

  /// The same around a robot that the caller has made.
  DriverNode(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
    DriverHardware hardware);
  ~DriverNode();

  /// Configures the hardware, and powers it if the parameters say so. Standing and holding.
  /**
   * Stays inactive while an emergency stop is latched, also one of before a restart, until the
   * button is released and its issuer shows that a person cleared the fault (see CommandGate).
   * \throws HardwareError when it cannot be configured
   */
  void start();

  /// One tick: the command in force, the world, the topics.
  /** \throws std::logic_error unless the world waits for its steps */
  void step();

  /// Goes on until `stop()` says so, giving the executor its turns in between.
  /** \throws HardwareError when the control loop ends by itself; the robot stands then, too */
  void run(stetro_dds::Executor & executor, const std::function<bool()> & stop);

  [[nodiscard]] stetro_dds::Node & node();
  [[nodiscard]] const SimulatedWorld * world() const;  ///< null: the robot is real

private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__DRIVER_NODE_HPP_
