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

#include "stetro_driver/driver_node.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "node/command_desk.hpp"
#include "node/driver_topics.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_driver/pacer.hpp"
#include "stetro_driver/site_shape.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"

namespace stetro_driver
{
namespace
{

using stetro_dds::Clock;
using stetro_dds::LifecycleTransition;

constexpr Time kLongestNap = std::chrono::milliseconds{20};  // between looks at `stop`
/// A driver that took a world over in mid-climb moves nothing for so long: whoever commanded the
/// one before it has then seen that this is another one, and does not go on as if nothing had been.
constexpr Time kStandFirst = std::chrono::milliseconds{300};
constexpr double kBearingLoad = 0.05;  // a block with this share of the weight stands

stetro_dds::NodeOptions by_hand(stetro_dds::NodeOptions options)
{
  options.time = stetro_dds::TimeSource::kByHand;
  options.hardware_id = "simulated stetro";
  return options;
}

}  // namespace

class DriverNode::Body
{
public:
  Body(stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup)
  : start_active_(setup.params.start_active),
    robot_(building_of(setup), shape_of(setup.robot), sim_options(setup)),
    pacer_(pacer_limits(setup.params), SimRobot::kTick),
    node_(context, by_hand(std::move(options))),
    topics_(node_, setup),
    desk_(node_, gate_limits(setup.params))
  {
    node_.subscribe<stetro_msgs::msg::Command>(
      "command", stetro_dds::qos::kCommand,
      [this](const stetro_msgs::msg::Command & message) { return take(to_request(message)); });
    if (setup.params.sim.throttle) {
      node_.subscribe<geometry_msgs::msg::PoseWithCovarianceStamped>(
        "pose", stetro_dds::qos::kPose,
        [this](const geometry_msgs::msg::PoseWithCovarianceStamped & message) {
          return hear_localizer(time_of(message.header().stamp()));
        });
    }
    give_life();
    report();
  }

  ~Body() { robot_.make_safe(); }

  void start()
  {
    if (const auto refusal = node_.lifecycle().request(LifecycleTransition::kConfigure)) {
      throw HardwareError(refusal->detail);
    }
    frame_ = robot_.read(robot_.time()).value();
    node_.clock().set(robot_.time());
    topics_.publish_static(robot_.time());
    if (!robot_.resume_detail().empty()) {
      node_.log().info("snapshot: {}", robot_.resume_detail());
    }
    if (robot_.resume_outcome() == ResumeOutcome::kResumed) {
      may_act_from_ = robot_.time() + kStandFirst;
    }
    if (frame_.emergency_stop_latched) {
      desk_.gate().latch_emergency_stop();
    }
    activate_if_told();
  }

  void step()
  {
    const JointCommand command = desk_.in_force(clocks());
    if (node_.lifecycle().active()) {
      note(robot_.write(command));
    }
    robot_.step();
    node_.clock().set(robot_.time());
    auto read = robot_.read(robot_.time());
    if (!read) {
      note(read.fault());
      return;
    }
    frame_ = read.value();
    if (frame_.emergency_stop_latched) {
      desk_.gate().latch_emergency_stop();
    }
    topics_.publish(frame_);
    topics_.publish(robot_.truth());
    desk_.observe(frame_);
  }

  void run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
  {
    paced_ = true;
    while (!stop()) {
      const Time wait = pacer_.wait(robot_.time(), Clock::steady_now());
      if (wait > Time::zero()) {
        executor.spin_some(std::min(wait, kLongestNap));
        continue;
      }
      step();
      pacer_.ticked(Clock::steady_now());
      executor.spin_some(Time::zero());
    }
    paced_ = false;
    node_.lifecycle().request(LifecycleTransition::kShutdown);
  }

  stetro_dds::Node & node() { return node_; }
  const SimRobot & robot() const { return robot_; }

private:
  std::optional<stetro_dds::Refusal> take(const CommandRequest & request)
  {
    auto refusal = desk_.offer(request, clocks(), situation());
    if (!refusal) {
      pacer_.hear(Peer::kSupervisor, request.stamp, robot_.time());
    }
    if (desk_.gate().take_reset_request()) {
      reset_emergency_stop(request.issuer);
    }
    return refusal;
  }

  std::optional<stetro_dds::Refusal> hear_localizer(Time stamp)
  {
    if (stamp <= Time::zero() || stamp > robot_.time()) {
      return stetro_dds::Refusal{"bad_stamp", "stamp zero, negative or in the future"};
    }
    pacer_.hear(Peer::kLocalizer, stamp, robot_.time());
    return std::nullopt;
  }

  void reset_emergency_stop(const std::string & asked_by)
  {
    try {
      robot_.reset_emergency_stop();
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
  void activate_if_told()
  {
    if (!start_active_ || node_.lifecycle().active()) {
      return;
    }
    if (const auto refusal = node_.lifecycle().request(LifecycleTransition::kActivate)) {
      node_.log().error("stays inactive: {}", refusal->detail);
    }
  }

  /// In a run by hand no clock is read: steady time is then simulated time, too.
  GateClocks clocks() const
  {
    return {robot_.time(), paced_ ? Clock::steady_now() : robot_.time()};
  }

  GateSituation situation() const
  {
    GateSituation situation;
    situation.active = node_.lifecycle().active() && robot_.time() >= may_act_from_;
    situation.emergency_stop = frame_.emergency_stop_latched;
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

  void note(const std::optional<IoFault> & fault)
  {
    if (fault) {
      ++io_faults_;
      desk_.give_up(*fault, robot_.time());
      if (fault->detail != last_fault_) {
        node_.log().error("hardware: {}", fault->detail);
      }
    }
    last_fault_ = fault ? fault->detail : "";
  }

  void give_life();
  void report();

  const bool start_active_;
  SimRobot robot_;
  Pacer pacer_;
  stetro_dds::Node node_;
  DriverTopics topics_;
  CommandDesk desk_;
  SensorFrame frame_{};
  bool paced_ = false;
  Time may_act_from_{0};  ///< robot time before which no command acts
  std::string last_fault_;
  std::uint64_t io_faults_ = 0;
};

/// Ties the node's life to the hardware's.
void DriverNode::Body::give_life()
{
  const auto attempt =
    [](const std::function<void()> & action) -> std::optional<stetro_dds::Refusal> {
    try {
      action();
      return std::nullopt;
    } catch (const HardwareError & error) {
      return stetro_dds::Refusal{"hardware", error.what()};
    }
  };
  auto & life = node_.lifecycle();
  life.on(LifecycleTransition::kConfigure, [this, attempt] {
    return attempt([this] { robot_.configure(); });
  });
  life.on(LifecycleTransition::kActivate, [this, attempt] {
    return attempt([this] { robot_.activate(); });
  });
  const auto let_go = [this]() -> std::optional<stetro_dds::Refusal> {
    desk_.gate().drop();
    robot_.deactivate();
    return std::nullopt;
  };
  life.on(LifecycleTransition::kDeactivate, let_go);
  life.on(LifecycleTransition::kShutdown, let_go);
}

/// What `/diagnostics` says of the hardware, the commands and the simulation.
void DriverNode::Body::report()
{
  using stetro_dds::DiagnosticReport;
  using stetro_dds::Health;
  node_.diagnostics().add("hardware", [this](DiagnosticReport & report) {
    if (!last_fault_.empty()) {
      report.summarise(Health::kError, last_fault_);
    }
    if (
      robot_.resume_outcome() == ResumeOutcome::kDamaged ||
      robot_.resume_outcome() == ResumeOutcome::kForeign) {
      report.summarise(Health::kWarn, robot_.resume_detail());
    }
    report.value("io_faults", io_faults_);
    report.value("snapshot", robot_.resume_detail());
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      if (frame_.ranges[i].status == RangeStatus::kFault && frame_.time > Time::zero()) {
        report.summarise(Health::kWarn, std::string(kRangeNames[i]) + " does not answer");
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
  node_.diagnostics().add("simulation", [this](DiagnosticReport & report) {
    report.value("time_s", time_to_seconds(robot_.time()));
    report.value("waits_for_peers", pacer_.waits());
    report.value("peers_given_up", pacer_.losses());
  });
}

DriverNode::DriverNode(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup)
: body_(std::make_unique<Body>(context, std::move(options), setup))
{
}

DriverNode::~DriverNode() = default;

void DriverNode::start() { body_->start(); }

void DriverNode::step() { body_->step(); }

void DriverNode::run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
{
  body_->run(executor, stop);
}

stetro_dds::Node & DriverNode::node() { return body_->node(); }

const SimRobot & DriverNode::robot() const { return body_->robot(); }

}  // namespace stetro_driver
