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

#include "node/driver_front.hpp"

#include <utility>

#include "stetro_dds/qos.hpp"

namespace stetro_driver
{
namespace
{

using stetro_dds::LifecycleTransition;

constexpr double kBearingLoad = 0.05;  // a block with this share of the weight stands

}  // namespace

DriverFront::DriverFront(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
  World world, RobotAccess robot)
: start_active_(setup.params.start_active),
  robot_(std::move(robot)),
  node_(context, std::move(options)),
  topics_(node_, setup, world),
  desk_(node_, gate_limits(setup.params))
{
  node_.subscribe<stetro_msgs::msg::Command>(
    "command", stetro_dds::qos::kCommand,
    [this](const stetro_msgs::msg::Command & message) { return take(to_request(message)); });
  give_life();
  report();
}

void DriverFront::start(const std::function<Time()> & configured)
{
  if (const auto refusal = node_.lifecycle().request(LifecycleTransition::kConfigure)) {
    throw HardwareError(refusal->detail);
  }
  may_act_from_ = configured();
  const Time now = robot_.clocks().now;
  robot_.alone([&](HardwareInterface & robot) {
    if (const auto read = robot.read(now)) {
      frame_ = read.value();
    } else {
      note(read.fault());
    }
  });
  topics_.publish_static(now);
  if (frame_.emergency_stop_latched) {
    desk_.gate().latch_emergency_stop();
  }
  activate_if_told();
}

void DriverFront::hear(const SensorFrame & frame)
{
  frame_ = frame;
  if (frame_.emergency_stop_latched) {
    desk_.gate().latch_emergency_stop();
  }
  topics_.publish(frame_);
  desk_.observe(frame_);
}

void DriverFront::note(const std::optional<IoFault> & fault)
{
  if (fault) {
    ++io_faults_;
    desk_.give_up(*fault, robot_.clocks().now);
    if (fault->detail != last_fault_) {
      node_.log().error("hardware: {}", fault->detail);
    }
  }
  last_fault_ = fault ? fault->detail : "";
}

void DriverFront::rearm()
{
  if (active()) {
    node_.lifecycle().request(LifecycleTransition::kDeactivate);
    activate_if_told();
  }
}

void DriverFront::shut_down() { node_.lifecycle().request(LifecycleTransition::kShutdown); }

std::optional<stetro_dds::Refusal> DriverFront::take(const CommandRequest & request)
{
  const GateClocks clocks = robot_.clocks();
  auto refusal = desk_.offer(request, clocks, situation(clocks));
  if (!refusal && accepted_) {
    accepted_(request);
  }
  if (desk_.gate().take_reset_request()) {
    const bool latched = frame_.emergency_stop_latched || desk_.gate().emergency_stop_latched();
    latched ? reset_emergency_stop(request.issuer) : reset_fault(request.issuer);
  }
  return refusal;
}

/// Servos forget what they latched, and blocks what stopped them, when they are given power.
void DriverFront::reset_fault(const std::string & asked_by)
{
  node_.log().info("'{}' resets the hardware's fault", asked_by);
  rearm();
  activate_if_told();
}

void DriverFront::reset_emergency_stop(const std::string & asked_by)
{
  try {
    robot_.alone([](HardwareInterface & robot) { robot.reset_emergency_stop(); });
  } catch (const HardwareError & error) {
    node_.log().error("emergency stop not reset: {}", error.what());
    return;
  }
  frame_.emergency_stop_latched = false;
  desk_.gate().reset_emergency_stop();
  node_.log().info("emergency stop reset: '{}' left its fault", asked_by);
  activate_if_told();
}

/// Powers the motors if the parameters say so and nothing speaks against it.
void DriverFront::activate_if_told()
{
  if (!start_active_ || active()) {
    return;
  }
  if (const auto refusal = node_.lifecycle().request(LifecycleTransition::kActivate)) {
    node_.log().error("stays inactive: {}", refusal->detail);
  }
}

GateSituation DriverFront::situation(const GateClocks & clocks) const
{
  GateSituation situation;
  situation.active = active() && clocks.now >= may_act_from_;
  situation.emergency_stop = frame_.emergency_stop_latched;
  situation.refused_power = start_active_ && !active();
  situation.emergency_stop_pressed = frame_.contact(ContactPlace::kEmergencyStop).closed;
  situation.steering_rad = frame_.steering.angle_rad;
  situation.steering_moving = frame_.steering.moving;
  for (std::size_t i = 0; i < kBlocks; ++i) {
    const BlockReading & block = frame_.blocks[i];
    situation.fault = situation.fault || block.fault;
    situation.standing[i] = block.at_lower_lock || block.load > kBearingLoad;
  }
  return situation;
}

/// Ties the node's life to the hardware's.
void DriverFront::give_life()
{
  using Action = void (HardwareInterface::*)();
  const auto attempt = [this](Action action) -> std::optional<stetro_dds::Refusal> {
    try {
      robot_.alone([action](HardwareInterface & robot) { (robot.*action)(); });
      return std::nullopt;
    } catch (const HardwareError & error) {
      return stetro_dds::Refusal{"hardware", error.what()};
    }
  };
  auto & life = node_.lifecycle();
  life.on(
    LifecycleTransition::kConfigure, [attempt] { return attempt(&HardwareInterface::configure); });
  life.on(LifecycleTransition::kActivate, [this, attempt] {
    auto refusal = attempt(&HardwareInterface::activate);
    robot_.power(!refusal);
    return refusal;
  });
  const auto let_go = [this]() -> std::optional<stetro_dds::Refusal> {
    desk_.gate().drop();
    robot_.power(false);
    robot_.alone([](HardwareInterface & robot) { robot.deactivate(); });
    return std::nullopt;
  };
  life.on(LifecycleTransition::kDeactivate, let_go);
  life.on(LifecycleTransition::kShutdown, let_go);
}

/// What `/diagnostics` says of the hardware and of the commands.
void DriverFront::report()
{
  using stetro_dds::DiagnosticReport;
  using stetro_dds::Health;
  node_.diagnostics().add("hardware", [this](DiagnosticReport & report) {
    if (!last_fault_.empty()) {
      report.summarise(Health::kError, last_fault_);
    }
    report.value("io_faults", io_faults_);
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      if (frame_.ranges[i].status == RangeStatus::kFault && frame_.time > Time::zero()) {
        report.summarise(Health::kWarn, std::string(kRangeNames[i]) + " does not answer");
      }
    }
  });
  node_.diagnostics().add("devices", [this](DiagnosticReport & report) {
    for (const DeviceStatus & device : robot_.devices()) {
      if (device.fault) {
        report.summarise(Health::kError, device.fault->detail);
      }
      for (const auto & [name, value] : device.figures) {
        report.value(device.name + ": " + name, value);
      }
    }
  });
  node_.diagnostics().add("commands", [this](DiagnosticReport & report) {
    const GateCounters & counters = desk_.gate().counters();
    if (desk_.gate().emergency_stop_latched()) {
      report.summarise(Health::kError, "emergency stop latched");
    }
    report.value("accepted", counters.accepted);
    report.value("expired", counters.expired);
    report.value("stalls", counters.stalls);
    for (std::size_t i = 1; i < kRefusals; ++i) {
      if (counters.refused[i] > 0) {
        report.value(
          "refused " + std::string(to_string(static_cast<stetro_driver::Refusal>(i))),
          counters.refused[i]);
      }
    }
  });
}

}  // namespace stetro_driver
