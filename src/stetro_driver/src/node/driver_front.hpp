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

#ifndef NODE__DRIVER_FRONT_HPP_
#define NODE__DRIVER_FRONT_HPP_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "node/command_desk.hpp"
#include "node/driver_topics.hpp"
#include "stetro_driver/driver_hardware.hpp"

namespace stetro_driver
{

/// How the front gets at the robot, which whoever runs it may be using just now.
struct RobotAccess
{
  std::function<GateClocks()> clocks;  ///< the robot's time, and the steady one
  /// Runs an action on the hardware while nobody else does.
  std::function<void(const std::function<void(HardwareInterface &)> &)> alone;
  std::function<void(bool)> power;  ///< told before the motors lose power, and after they got it
  std::function<std::vector<DeviceStatus>()> devices;
};

/// The side of the driver that faces the wire: topics, commands, lifecycle, diagnostics.
/** It does not know how time passes: SteppedRun or TimedRun feed it what the robot senses. */
class DriverFront
{
public:
  /// Told of each command that was accepted.
  using Acceptance = std::function<void(const CommandRequest &)>;

  DriverFront(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
    World world, RobotAccess robot);

  /// Configures the hardware, looks at it, and powers it if told to.
  /**
   * \param configured called once it is; returns the robot time before which no command acts
   * \throws HardwareError when it cannot be configured
   */
  void start(const std::function<Time()> & configured);

  /// What acts now, and until when on the robot's clock.
  InForce in_force() { return desk_.in_force(robot_.clocks()); }

  /// What the robot senses, on its way to the wire.
  void hear(const SensorFrame & frame);
  void hear(const GroundTruth & truth) { topics_.publish(truth); }

  /// What stands between us and the hardware; nothing: all is well.
  void note(const std::optional<IoFault> & fault);

  /// Takes the power from motors that were made safe, and gives it again if told to at the start.
  void rearm();

  /// Takes the power from the motors, for good.
  void shut_down();

  void on_acceptance(Acceptance told) { accepted_ = std::move(told); }
  [[nodiscard]] stetro_dds::Node & node() { return node_; }
  [[nodiscard]] bool active() const { return node_.lifecycle().active(); }

private:
  std::optional<stetro_dds::Refusal> take(const CommandRequest & request);
  void reset_emergency_stop(const std::string & asked_by);
  void reset_fault(const std::string & asked_by);
  void activate_if_told();
  [[nodiscard]] GateSituation situation(const GateClocks & clocks) const;
  void give_life();
  void report();

  const bool start_active_;
  const RobotAccess robot_;
  stetro_dds::Node node_;
  DriverTopics topics_;
  CommandDesk desk_;
  Acceptance accepted_;
  SensorFrame frame_{};
  Time may_act_from_{0};
  std::string last_fault_;
  std::uint64_t io_faults_ = 0;
};

}  // namespace stetro_driver

#endif  // NODE__DRIVER_FRONT_HPP_
