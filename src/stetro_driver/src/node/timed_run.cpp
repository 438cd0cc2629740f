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

#include "node/timed_run.hpp"

#include <utility>

namespace stetro_driver
{
namespace
{

using stetro_dds::Clock;

constexpr Time kLongestNap = std::chrono::milliseconds{20};     // between looks at `stop`
constexpr Time kLoopPatience = std::chrono::milliseconds{200};  // as long as any command may act

Time shorter(Time robot_time, double speed)
{
  return Time{static_cast<Time::rep>(static_cast<double>(robot_time.count()) / speed)};
}

}  // namespace

TimedRun::TimedRun(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
  const DriverHardware & hardware)
: robot_(*hardware.robot),
  world_(hardware.world),
  speed_(world_ != nullptr ? setup.params.sim.speed : 1.0),
  loop_(
    robot_, [this] { return now(); },
    shorter(seconds_to_time(1.0 / setup.params.loop.rate_hz), speed_), setup.params.loop.realtime),
  front_(
    context, std::move(options), setup, world_ != nullptr ? World::kSimulated : World::kReal,
    access())
{
  front_.on_acceptance([this](const CommandRequest &) {
    ++accepted_;
    pass_command();
  });
  report();
}

Time TimedRun::now() { return world_ != nullptr ? world_->time() : node().clock().now(); }

RobotAccess TimedRun::access()
{
  return {
    [this] {
      return GateClocks{now(), Clock::steady_now()};
    },
    [this](const std::function<void(HardwareInterface &)> & action) {
      loop_.alone([&] { action(robot_); });
    },
    [this](bool on) {
      powered_ = on;
      loop_.command(TimedCommand{on, {}, Time::zero(), accepted_});
    },
    [this] { return robot_.devices(); }};
}

void TimedRun::start()
{
  front_.start([this] {
    if (world_ != nullptr) {
      node().clock().set(now());
    }
    return Time::zero();
  });
}

void TimedRun::run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
{
  heard_ = Clock::steady_now();
  loop_.start();
  bool told_realtime = false;
  while (!stop()) {
    loop_.wait(kLongestNap);
    told_realtime = told_realtime || tell_realtime();
    note_fault();
    tell_frames();
    executor.spin_some(Time::zero());
    pass_command();
    watch_loop();
  }
  loop_.stop();
  front_.shut_down();
}

/// \return whether there was anything to tell yet
bool TimedRun::tell_realtime()
{
  const auto granted = loop_.realtime();
  if (granted && granted->refused()) {
    node().log().warn("real time: {}", granted->words);
  }
  return granted.has_value();
}

void TimedRun::tell_frames()
{
  SensorFrame frame;
  while (loop_.take(frame)) {
    heard_ = Clock::steady_now();
    if (silent_) {
      silent_ = false;
      front_.rearm();  // it stands and holds; the next command moves it
    }
    if (world_ != nullptr) {
      node().clock().set(frame.time);
    }
    front_.hear(frame);
    if (world_ != nullptr) {
      const GroundTruth truth = world_->truth();
      if (truth.time > truth_told_) {
        truth_told_ = truth.time;
        front_.hear(truth);
      }
    }
  }
}

void TimedRun::pass_command()
{
  const InForce in_force = front_.in_force();
  const Time left = shorter(in_force.until - now(), speed_);
  loop_.command(TimedCommand{powered_, in_force.command, Clock::steady_now() + left, accepted_});
}

// What a cycle said of an older command is not held against the one in force.
void TimedRun::note_fault()
{
  const auto fault = loop_.fault();
  if (!fault) {
    front_.note(std::nullopt);
  } else if (fault->command == accepted_) {
    front_.note(fault->fault);
  }
}

void TimedRun::watch_loop()
{
  if (!loop_.alive()) {
    throw HardwareError("the control loop ended: " + loop_.death());
  }
  if (!silent_ && Clock::steady_now() - heard_ > kLoopPatience) {
    silent_ = true;
    robot_.make_safe();
    node().log().error("the control loop is silent: the robot has been told to stand");
  }
}

/// What `/diagnostics` says of the control loop.
void TimedRun::report()
{
  using stetro_dds::DiagnosticReport;
  node().diagnostics().add("control loop", [this](DiagnosticReport & report) {
    if (silent_) {
      report.summarise(stetro_dds::Health::kError, "silent");
    }
    const linux_io::LoopSummary summary = loop_.summary();
    report.value("cycles", summary.cycles);
    report.value("overruns", summary.overruns);
    report.value("periods_missed", loop_.missed());
    report.value("period_error_p50_s", time_to_seconds(summary.period_error_p50));
    report.value("period_error_p999_s", time_to_seconds(summary.period_error_p999));
    report.value("period_error_max_s", time_to_seconds(summary.period_error_max));
    report.value("mean_work_s", time_to_seconds(summary.mean_work));
    report.value("longest_work_s", time_to_seconds(summary.longest_work));
    report.value("dropped_frames", loop_.dropped_frames());
  });
}

}  // namespace stetro_driver
