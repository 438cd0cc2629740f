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

#include "node/stepped_run.hpp"

#include <algorithm>
#include <utility>

#include "stetro_dds/qos.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"

namespace stetro_driver
{
namespace
{

using stetro_dds::Clock;

constexpr Time kLongestNap = std::chrono::milliseconds{20};  // between looks at `stop`
/// A driver that took a world over in mid-climb moves nothing for so long: whoever commanded the
/// one before it has then seen that this is another one, and does not go on as if nothing had been.
constexpr Time kStandFirst = std::chrono::milliseconds{300};

}  // namespace

SteppedRun::SteppedRun(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
  const DriverHardware & hardware)
: robot_(*hardware.robot),
  world_(*hardware.stepped),
  pacer_(pacer_limits(setup.params), SteppedWorld::kTick),
  front_(context, std::move(options), setup, World::kSimulated, access())
{
  front_.on_acceptance([this](const CommandRequest & request) {
    pacer_.hear(Peer::kSupervisor, request.stamp, world_.time());
  });
  if (setup.params.sim.throttle) {
    node().subscribe<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "pose", stetro_dds::qos::kPose,
      [this](const geometry_msgs::msg::PoseWithCovarianceStamped & message) {
        return hear_localizer(time_of(message.header().stamp()));
      });
  }
  report();
}

RobotAccess SteppedRun::access()
{
  return {
    [this] { return clocks(); },
    [this](const std::function<void(HardwareInterface &)> & action) { action(robot_); },
    [](bool) {}, [this] { return robot_.devices(); }};
}

/// In a run by hand no clock is read: steady time is then simulated time, too.
GateClocks SteppedRun::clocks() const
{
  return {world_.time(), paced_ ? Clock::steady_now() : world_.time()};
}

void SteppedRun::start()
{
  front_.start([this] { return configured(); });
  if (!world_.resume_detail().empty()) {
    node().log().info("snapshot: {}", world_.resume_detail());
  }
}

// What time it is, and whether somebody drove before us, is the snapshot's to say.
Time SteppedRun::configured()
{
  node().clock().set(world_.time());
  return world_.resume_outcome() == ResumeOutcome::kResumed ? world_.time() + kStandFirst
                                                            : world_.time();
}

void SteppedRun::step()
{
  const JointCommand command = front_.in_force().command;
  if (front_.active()) {
    front_.note(robot_.write(command));
  }
  world_.step();
  node().clock().set(world_.time());
  const auto read = robot_.read(world_.time());
  if (!read) {
    front_.note(read.fault());
    return;
  }
  front_.hear(read.value());
  front_.hear(world_.truth());
}

void SteppedRun::run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
{
  paced_ = true;
  while (!stop()) {
    const Time wait = pacer_.wait(world_.time(), Clock::steady_now());
    if (wait > Time::zero()) {
      executor.spin_some(std::min(wait, kLongestNap));
      continue;
    }
    step();
    pacer_.ticked(Clock::steady_now());
    executor.spin_some(Time::zero());
  }
  paced_ = false;
  front_.shut_down();
}

std::optional<stetro_dds::Refusal> SteppedRun::hear_localizer(Time stamp)
{
  if (stamp <= Time::zero() || stamp > world_.time()) {
    return stetro_dds::Refusal{"bad_stamp", "stamp zero, negative or in the future"};
  }
  pacer_.hear(Peer::kLocalizer, stamp, world_.time());
  return std::nullopt;
}

/// What `/diagnostics` says of the simulation.
void SteppedRun::report()
{
  using stetro_dds::DiagnosticReport;
  node().diagnostics().add("simulation", [this](DiagnosticReport & report) {
    const ResumeOutcome outcome = world_.resume_outcome();
    if (outcome == ResumeOutcome::kDamaged || outcome == ResumeOutcome::kForeign) {
      report.summarise(stetro_dds::Health::kWarn, world_.resume_detail());
    }
    report.value("time_s", time_to_seconds(world_.time()));
    report.value("snapshot", world_.resume_detail());
    report.value("waits_for_peers", pacer_.waits());
    report.value("peers_given_up", pacer_.losses());
  });
}

}  // namespace stetro_driver
