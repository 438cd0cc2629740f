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

#include "accuracy/closed_loop.hpp"

#include <algorithm>
#include <stdexcept>

#include "accuracy/convert.hpp"
#include "stetro_driver/site_shape.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_driver::SimRobot;
using stetro_driver::Time;
using stetro_supervisor::State;

// Periods of the nodes, in ticks of 10 ms.
constexpr std::uint64_t kLocalizerTimer = 10;  // 10 Hz
constexpr std::uint64_t kAsking = 50;          // a refused request is made again every 0.5 s
constexpr Time kContactsPeriod = std::chrono::milliseconds{100};

constexpr double kBearingLoad = 0.05;         // a block with this share of the weight stands
constexpr double kPatienceToStart_s = 60.0;   // for a climb to be accepted
constexpr double kPatienceStanding_s = 60.0;  // held, paused or waiting for the pose
constexpr double kPatienceForStep_s = 300.0;  // for a whole climb, times its steps

std::uint64_t supervisor_period(double rate_hz)
{
  const auto ticks = std::chrono::duration<double>(SimRobot::kTick).count() * rate_hz;
  return static_cast<std::uint64_t>(1.0 / ticks + 0.5);
}

stetro_localizer::LocalizerParams with_estimator(
  stetro_localizer::LocalizerParams params, const std::string & name)
{
  params.estimator = name;
  return params;
}

bool stands_and_waits(State state)
{
  return state == State::kHeld || state == State::kWaitPose || state == State::kPaused;
}

}  // namespace

const char * to_string(ClimbEnd end)
{
  switch (end) {
    case ClimbEnd::kRunning:
      return "running";
    case ClimbEnd::kFinished:
      return "finished";
    case ClimbEnd::kFault:
      return "fault";
    case ClimbEnd::kHeld:
      return "held";
    case ClimbEnd::kTooLong:
      return "too_long";
    case ClimbEnd::kRefused:
      return "refused";
    case ClimbEnd::kFallen:
      return "fallen";
  }
  return "unknown";
}

ClosedLoop::ClosedLoop(
  const RobotSetup & setup, const stetro_driver::SimOptions & sim,
  const std::vector<std::string> & estimators)
: setup_(setup),
  robot_(
    stetro_driver::shape_of(setup.driver.flight()), stetro_driver::shape_of(setup.driver.robot),
    sim),
  gate_(stetro_driver::gate_limits(setup.driver.params)),
  climb_(
    setup.supervisor.params.climb,
    stetro_supervisor::make_geometry(setup.flight(), setup.supervisor.robot.geometry)),
  mission_(climb_, setup.flight())
{
  if (estimators.empty()) {
    throw std::invalid_argument("estimators: none given, accepted: at least one, which drives");
  }
  for (const std::string & name : estimators) {
    listeners_.push_back({stetro_localizer::make_estimator(
      with_estimator(setup.localizer.params, name), setup.localizer.robot, setup.flight())});
    listeners_.back().estimator->begin({});
  }
  seen_.driver_instance = 1;
  robot_.configure();
  robot_.activate();
  frame_ = robot_.read(robot_.time()).value();
}

double ClosedLoop::elapsed_s() const
{
  return std::chrono::duration<double>(SimRobot::kTick).count() * static_cast<double>(ticks_);
}

std::string ClosedLoop::detail() const
{
  switch (end_) {
    case ClimbEnd::kFault:
      return std::string(stetro_supervisor::to_string(climb_.fault())) + ": " + climb_.note();
    case ClimbEnd::kHeld:
      return climb_.note();
    case ClimbEnd::kTooLong:
      return std::string("in state '") + stetro_supervisor::to_string(climb_.state()) + "'";
    case ClimbEnd::kRefused:
      return refusal_;
    default:
      return "";
  }
}

void ClosedLoop::tick()
{
  ++ticks_;
  move();
  truths_.add(robot_.truth());
  contacts_now_ = contacts_due();
  for (Listener & listener : listeners_) {
    sense(listener);
  }
  observe();
  if (!accepted_ && every(kAsking)) {
    ask();
  }
  if (every(supervisor_period(setup_.supervisor.params.rate_hz))) {
    command();
  }
  judge_end();
}

void ClosedLoop::move()
{
  const stetro_driver::GateClocks clocks{robot_.time(), robot_.time()};
  if (const auto fault = robot_.write(gate_.in_force(clocks).command)) {
    seen_.driver_answer = stetro_supervisor::DriverAnswer{robot_.time(), true, fault->detail};
  }
  robot_.step();
  frame_ = robot_.read(robot_.time()).value();
  if (frame_.emergency_stop_latched) {
    gate_.latch_emergency_stop();
  }
}

bool ClosedLoop::contacts_due()
{
  const bool changed = !std::equal(
    frame_.contacts.begin(), frame_.contacts.end(), last_contacts_.begin(),
    [](const auto & a, const auto & b) { return a.closed == b.closed && a.fault == b.fault; });
  if (!changed && frame_.time - contacts_sent_ < kContactsPeriod) {
    return false;
  }
  last_contacts_ = frame_.contacts;
  contacts_sent_ = frame_.time;
  return true;
}

// What is refused is counted by the estimator itself.
void ClosedLoop::sense(Listener & listener)
{
  stetro_localizer::Estimator & estimator = *listener.estimator;
  const auto before = estimator.estimate().stamp;
  const auto reasons = estimator.estimate().reasons;
  bool published = false;
  static_cast<void>(estimator.add_odometry(to_odometry(frame_), frame_.time));
  if (const auto gyro = to_gyro(frame_)) {
    static_cast<void>(estimator.add_gyro(*gyro, frame_.time));
  }
  if (contacts_now_) {
    static_cast<void>(estimator.add_contacts(to_contacts(frame_), frame_.time));
  }
  if (frame_.ranges_complete) {
    static_cast<void>(estimator.add_blocks(to_blocks(frame_), frame_.time));
    const auto stale_after =
      stetro_driver::seconds_to_time(setup_.localizer.params.max_sample_age_s);
    if (const auto ranges = to_ranges(frame_, stale_after)) {
      published = !estimator.add_ranges(*ranges, frame_.time).is_refused();
    }
  }
  if (every(kLocalizerTimer)) {
    estimator.tick(frame_.time);
    published = published || estimator.estimate().reasons != reasons;
  }
  listener.refreshed = estimator.estimate().stamp != before;
  if (&listener == &listeners_.front()) {
    pose_now_ = published || listener.refreshed;
  }
}

void ClosedLoop::observe()
{
  if (frame_.ranges_complete) {
    observe_ranges(frame_, seen_);
    observe_blocks(frame_, seen_);
  }
  if (contacts_now_) {
    observe_contacts(frame_, seen_);
  }
  observe_odometry(frame_, seen_);
  if (pose_now_) {
    observe_pose(listeners_.front().estimator->estimate(), setup_.flight().id(), seen_);
  }
}

void ClosedLoop::ask()
{
  const stetro_supervisor::MissionRequest request{
    "climb-" + std::to_string(++requests_), "accuracy",
    stetro_supervisor::RequestKind::kCleanFlight, setup_.flight().id()};
  const auto answer = mission_.request(request);
  accepted_ = answer.accepted;
  refusal_ = answer.reason;
}

void ClosedLoop::command()
{
  const stetro_supervisor::MotionCommand motion = climb_.tick(frame_.time, seen_);
  if (motion.kind == stetro_supervisor::MotionCommand::Kind::kNone) {
    return;
  }
  const auto valid_for = stetro_driver::seconds_to_time(setup_.supervisor.params.valid_for_s);
  const auto verdict = gate_.offer(
    to_request(motion, ++sequence_, frame_.time, valid_for), {frame_.time, frame_.time},
    situation());
  seen_.driver_answer =
    stetro_supervisor::DriverAnswer{frame_.time, !verdict.accepted(), verdict.detail};
}

stetro_driver::GateSituation ClosedLoop::situation() const
{
  stetro_driver::GateSituation situation;
  situation.active = true;
  situation.emergency_stop = frame_.emergency_stop_latched;
  situation.emergency_stop_pressed =
    frame_.contact(stetro_driver::ContactPlace::kEmergencyStop).closed;
  situation.steering_rad = frame_.steering.angle_rad;
  situation.steering_moving = frame_.steering.moving;
  for (std::size_t i = 0; i < stetro_driver::kBlocks; ++i) {
    const stetro_driver::BlockReading & block = frame_.blocks[i];
    situation.fault = situation.fault || block.fault;
    situation.standing[i] = block.at_lower_lock || block.load > kBearingLoad;
  }
  return situation;
}

void ClosedLoop::judge_end()
{
  const State state = climb_.state();
  if (!stands_and_waits(state)) {
    standing_since_.reset();
  } else if (!standing_since_) {
    standing_since_ = frame_.time;
  }
  const auto beyond = [this](Time since, double patience_s) {
    return frame_.time - since > stetro_driver::seconds_to_time(patience_s);
  };
  if (robot_.truth().fallen) {
    end_ = ClimbEnd::kFallen;
  } else if (accepted_ && state == State::kFinished) {
    end_ = ClimbEnd::kFinished;
  } else if (state == State::kFault) {
    end_ = ClimbEnd::kFault;
  } else if (standing_since_ && beyond(*standing_since_, kPatienceStanding_s)) {
    end_ = ClimbEnd::kHeld;
  } else if (!accepted_ && elapsed_s() > kPatienceToStart_s) {
    end_ = ClimbEnd::kRefused;
  } else if (elapsed_s() > kPatienceForStep_s * setup_.flight().steps()) {
    end_ = ClimbEnd::kTooLong;
  }
}

}  // namespace stetro_bringup
