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

#include "control_loop.hpp"

#include <errno.h>
#include <time.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_driver
{
namespace
{

constexpr Time kSummaryPeriod = std::chrono::seconds{1};
constexpr Time kPeerPatience = std::chrono::seconds{1};  // with whoever commands

timespec to_timespec(Time time)
{
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  return {seconds.count(), (time - seconds).count()};
}

Time steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

void sleep_until(Time deadline)
{
  const timespec until = to_timespec(deadline);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

bool same(const std::optional<LoopFault> & a, const std::optional<LoopFault> & b)
{
  return a.has_value() == b.has_value() &&
         (!a || (a->command == b->command && a->fault.kind == b->fault.kind &&
                 a->fault.detail == b->fault.detail));
}

}  // namespace

ControlLoop::ControlLoop(
  HardwareInterface & robot, RobotClock clock, Time period,
  const linux_io::RealtimeConfig & realtime)
: robot_(robot),
  clock_(std::move(clock)),
  period_(period),
  wishes_(realtime),
  service_(linux_io::ServiceNotify::from_environment()),
  statistics_(period)
{
  if (period <= Time::zero()) {
    throw std::invalid_argument(
      "period is " + std::to_string(period.count()) + " ns, accepted: above 0");
  }
  sem_init(&arrived_, 0, 0);
}

ControlLoop::~ControlLoop()
{
  stop();
  sem_destroy(&arrived_);
}

void ControlLoop::start()
{
  stop_ = false;
  alive_ = true;
  thread_ = std::thread([this] { run(); });
}

void ControlLoop::stop() noexcept
{
  stop_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void ControlLoop::run() noexcept
{
  try {
    granted_.put(linux_io::ask_for_realtime(wishes_));
    service_.ready();
    work();
  } catch (const std::exception & error) {
    death_ = error.what();
  } catch (...) {
    death_ = "an exception without words";
  }
  robot_.make_safe();
  service_.stopping();
  alive_ = false;
  sem_post(&arrived_);
}

void ControlLoop::work()
{
  Time deadline = steady_now();
  while (!stop_) {
    const Time begun = steady_now();
    // Somebody turns the power on or off just now: nothing is lost by a cycle without us.
    if (std::unique_lock<std::mutex> lock{hardware_, std::try_to_lock}; lock) {
      cycle(begun);
    }
    sem_post(&arrived_);
    account(begun);
    deadline += period_;
    const Time late = steady_now() - deadline;
    if (late >= period_) {
      const auto missed = late / period_;
      missed_ += static_cast<std::uint64_t>(missed);
      deadline += missed * period_;
    }
    sleep_until(deadline);
  }
}

void ControlLoop::account(Time begun)
{
  statistics_.begin(begun);
  statistics_.end(steady_now());
  if (begun - summed_ >= kSummaryPeriod) {
    summed_ = begun;
    summary_.put(statistics_.summary());
  }
}

void ControlLoop::command(const TimedCommand & command)
{
  commanded_ = steady_now();
  command_.put(command);
}

void ControlLoop::cycle(Time now)
{
  std::optional<IoFault> fault;
  auto read = robot_.read(clock_());
  if (read) {
    SensorFrame frame = read.value();
    frame.scan = nullptr;  // good only until the next read, and that is ours
    frame.scan_complete = false;
    frames_.put(frame);
  } else {
    fault = read.fault();
  }
  const auto asked = command_.latest();
  if (asked && asked->powered) {
    const bool expired = now >= asked->until;
    if (auto refused = robot_.write(expired ? JointCommand{} : asked->command)) {
      fault = std::move(refused);
    }
  }
  if (now - commanded_.load() < kPeerPatience) {
    service_.alive(now);
  }
  if (fault) {
    tell(LoopFault{std::move(*fault), asked ? asked->number : 0});
  } else {
    tell(std::nullopt);
  }
}

void ControlLoop::tell(std::optional<LoopFault> fault)
{
  if (!same(fault, told_)) {
    told_ = std::move(fault);
    faults_.put(told_);
    service_.status(told_ ? "holds: " + told_->fault.detail : "well");
  }
}

bool ControlLoop::wait(Time patience)
{
  const timespec until = to_timespec(steady_now() + patience);
  if (sem_clockwait(&arrived_, CLOCK_MONOTONIC, &until) != 0) {
    return false;
  }
  while (sem_trywait(&arrived_) == 0) {
  }
  return true;
}

std::optional<LoopFault> ControlLoop::fault() { return faults_.latest().value_or(std::nullopt); }

void ControlLoop::alone(const std::function<void()> & action)
{
  const std::lock_guard<std::mutex> lock{hardware_};
  action();
}

}  // namespace stetro_driver
