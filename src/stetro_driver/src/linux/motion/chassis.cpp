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

#include "linux/motion/chassis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::uint8_t kWheelPolicy = 0x35;     // the factory's: a wheel in trouble rolls out
constexpr std::uint8_t kSteeringPolicy = 0x24;  // heat and driver only: it goes on holding
constexpr std::uint8_t kLiftPolicy = 0x00;      // a lift never lets its block go by itself
constexpr Time kPowerPatience = std::chrono::seconds{2};

// Servos stand in this order: the wheels there are, steering, lifts.
std::vector<ServoPlace> places_of(const ChassisConfig & config)
{
  constexpr std::array<const char *, kWheels> kNames{
    "wheel front left", "wheel front right", "wheel rear left", "wheel rear right"};
  std::vector<ServoPlace> places;
  for (std::size_t i = 0; i < kWheels; ++i) {
    const std::int64_t id = config.wheels.wheels[i].id;
    if (id >= 0) {
      places.push_back(
        {kNames[i], static_cast<std::uint8_t>(id), {ServoMode::kVelocity, kWheelPolicy, 0, true}});
    }
  }
  const auto add = [&](const char * name, const JointConfig & joint, std::uint8_t policy) {
    places.push_back(
      {name, static_cast<std::uint8_t>(joint.id), {ServoMode::kPosition, policy, 0, false}});
  };
  add("steering front", config.steering.joints[0], kSteeringPolicy);
  add("steering rear", config.steering.joints[1], kSteeringPolicy);
  add("lift front", config.lifts.joints[0], kLiftPolicy);
  add("lift rear", config.lifts.joints[1], kLiftPolicy);
  return places;
}

}  // namespace

Chassis::Chassis(const ChassisConfig & config, DeviceClock clock)
: config_(config),
  clock_(clock),
  geometry_(config.wheels),
  bank_(config.bus, places_of(config), clock),
  odometry_(config.wheels),
  steering_(config.steering),
  kept_(config.blocks_file),
  lifts_(config.lifts, kept_.load())
{
}

Chassis::~Chassis()
{
  if (thread_.joinable()) {
    make_safe();
    stop_thread();
  }
}

void Chassis::stop_thread()
{
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
  stop_ = false;
}

void Chassis::configure()
{
  if (thread_.joinable()) {
    stop_thread();
  }
  bank_.open();
  powered_ = false;
  fault_ = bank_.cycle();
  measure(clock_.now());
  publish(clock_.now());
  thread_ = std::thread{[this] { run(); }};
}

void Chassis::activate()
{
  if (!thread_.joinable()) {
    throw HardwareError("servos: not configured");
  }
  safe_ = false;  // before, not after: what makes it safe meanwhile is not forgotten
  if (const auto fault = ask_power(Torque::kOn)) {
    throw HardwareError(fault->detail + "; accepted: servos without faults");
  }
}

std::optional<IoFault> Chassis::deactivate()
{
  return thread_.joinable() ? ask_power(Torque::kBrake) : std::nullopt;
}

std::optional<IoFault> Chassis::ask_power(Torque torque)
{
  std::unique_lock<std::mutex> lock{mutex_};
  command_ = {};
  power_asked_ = torque;
  const bool done = changed_.wait_for(
    lock, clock_.real(kPowerPatience), [this] { return !power_asked_.has_value(); });
  if (!done) {
    power_asked_.reset();
    return IoFault{IoFaultKind::kSilent, "servo bus: no time for a change of power"};
  }
  return power_fault_;
}

std::optional<IoFault> Chassis::command(const JointCommand & command)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  if (command.kind == MotionKind::kTwist) {
    const WheelValues wanted = geometry_.to_wheels(
      {command.vx_m_s, command.vy_m_s, command.wz_rad_s}, reading_.steering.angle_rad);
    for (const double speed : wanted) {
      if (!(std::abs(speed) <= config_.wheels.full_speed_rad_s)) {
        command_ = {};
        return IoFault{
          IoFaultKind::kBadCommand, "a wheel would turn at " + std::to_string(speed) +
                                      " rad/s, accepted: up to " +
                                      std::to_string(config_.wheels.full_speed_rad_s)};
      }
    }
  }
  command_ = command;
  commanded_at_ = clock_.now();
  return std::nullopt;
}

ChassisReading Chassis::reading() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return reading_;
}

std::vector<ServoDiagnostics> Chassis::diagnostics() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return diagnostics_;
}

DeviceCounts Chassis::line_counts() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return line_counts_;
}

void Chassis::make_safe() noexcept
{
  safe_ = true;  // the next round holds, and so do all others until activate()
  const std::lock_guard<std::mutex> lock{mutex_};
  if (hold_wire_) {
    bank_.bus().send_from_anywhere(*hold_wire_);
  }
}

void Chassis::run()
{
  const Time period = seconds_to_time(config_.period_s);
  Time next = clock_.now();
  while (true) {
    try {
      round(clock_.now());
    } catch (const std::exception & error) {
      // Out of memory: hold, and try again in the next period.
      make_safe();
      fault_ = IoFault{IoFaultKind::kSilent, error.what()};
    }
    next += period;
    const Time now = clock_.now();
    if (now > next) {
      ++overruns_;
      next = now;
    }
    std::unique_lock<std::mutex> lock{mutex_};
    if (changed_.wait_for(lock, clock_.real(next - now), [this] { return stop_; })) {
      return;
    }
  }
}

void Chassis::round(Time now)
{
  // A late round makes a longer leg, and a very late one does not make up for what it missed.
  const double since_s = time_to_seconds(now - round_at_);
  dt_s_ = std::min(since_s, 2.0 * config_.period_s);
  round_at_ = now;
  fault_ = bank_.cycle();
  change_power();
  measure(now);
  if (!fault_ && steering_.torn()) {
    fault_ = IoFault{IoFaultKind::kBadAnswer, "steering: front and rear stand differently"};
  }
  JointCommand stop;
  stop.kind = MotionKind::kStop;
  JointCommand command;
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    const bool fresh = now - commanded_at_ <= seconds_to_time(config_.command_timeout_s);
    command = fresh ? command_ : stop;
  }
  const bool holding = fault_ || !powered_ || safe_;
  obey(holding ? stop : command, now);
  tell(holding);
  publish(now);
}

void Chassis::change_power()
{
  std::optional<Torque> asked;
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    asked = power_asked_;
  }
  if (!asked) {
    return;
  }
  const bool on = *asked == Torque::kOn;
  auto fault = bank_.set_torque(*asked, on);
  if (!fault) {
    fault_ = bank_.cycle();  // errors that were cleared must be gone
    fault = on ? fault_ : std::nullopt;
  }
  powered_ = on && !fault;
  if (powered_) {
    lifts_.forgive();
  }
  steering_.restart();
  lifts_.restart();
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    power_fault_ = fault;
    power_asked_.reset();
  }
  changed_.notify_all();
}

void Chassis::measure(Time now)
{
  if (fault_) {
    // When this is over, goals begin where things are by then.
    steering_.restart();
    lifts_.restart();
    return;
  }
  const auto & servos = bank_.servos();
  std::size_t at = 0;
  std::array<WheelReading, kWheels> wheels{};
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (geometry_.exists(i)) {
      const ServoState & state = servos[at++].state();
      wheels[i] = {state.stamp, state.position_rad, state.in_gap, told_rad_s_[i]};
    }
  }
  const auto pair = [&](std::size_t first) {
    return std::array<double, kPair>{
      servos[first].state().position_rad, servos[first + 1].state().position_rad};
  };
  steering_.measure(pair(at));
  lifts_.measure(now, pair(at + kPair));
  odometry_.update(wheels, steering_.reading().angle_rad);
}

void Chassis::obey(const JointCommand & command, Time now)
{
  BodyTwist twist{};
  switch (command.kind) {
    case MotionKind::kTwist:
      twist = {command.vx_m_s, command.vy_m_s, command.wz_rad_s};
      steering_.hold();
      lifts_.hold();
      break;
    case MotionKind::kSteer:
      steering_.turn_to(command.steering_rad);
      lifts_.hold();
      break;
    case MotionKind::kLift:
    case MotionKind::kLower:
      steering_.hold();
      lifts_.start(command.kind, command.block);
      break;
    case MotionKind::kStop:
      steering_.hold();
      lifts_.stop();
      break;
    default:
      steering_.hold();
      lifts_.hold();
  }
  wanted_rad_s_ = geometry_.to_wheels(twist, steering_.reading().angle_rad);
  steering_.advance(dt_s_);
  lifts_.advance(now, dt_s_);
}

void Chassis::set_goals(bool holding)
{
  goals_.clear();
  const double full = config_.wheels.full_speed_rad_s;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (geometry_.exists(i)) {
      const double pwm =
        holding ? 0.0
                : speeds_[i].pwm(wanted_rad_s_[i], odometry_.wheel_speed_rad_s(i), full, dt_s_);
      told_rad_s_[i] = pwm * full;
      goals_.push_back({static_cast<int>(std::lround(pwm * kFullPwm)), true});
    }
  }
  for (const double goal : steering_.servo_goals_rad()) {
    goals_.push_back({position_count(goal), !fault_});
  }
  for (const double goal : lifts_.servo_goals_rad()) {
    goals_.push_back({position_count(goal), !fault_});
  }
}

void Chassis::tell(bool holding)
{
  // A leg lasts a little longer than a period, so that the next one finds it still moving.
  const Time playtime = seconds_to_time(config_.period_s) + kServoTick;
  set_goals(holding);
  const HerkulexBytes wire = bank_.jog(goals_, playtime);
  for (std::size_t i = 0; i + 2 * kPair < goals_.size(); ++i) {
    goals_[i].count = 0;  // the wheels
  }
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    hold_wire_ =
      powered_ ? std::optional<HerkulexBytes>{bank_.jog(goals_, playtime)} : std::nullopt;
  }
  if (powered_ && bank_.bus().is_open()) {
    if (auto fault = bank_.bus().send(safe_ ? *hold_wire_ : wire)) {
      fault_ = std::move(fault);
    }
  }
}

void Chassis::publish(Time now)
{
  if (const auto known = lifts_.known()) {
    kept_.keep(*known);
  }
  const std::lock_guard<std::mutex> lock{mutex_};
  reading_.stamp = now;
  reading_.blocks = lifts_.readings();
  for (BlockReading & block : reading_.blocks) {
    block.fault = block.fault || fault_.has_value();
  }
  reading_.steering = steering_.reading();
  reading_.odometry = odometry_.reading();
  reading_.fault = fault_;
  // In place: once their words have room, nothing is allocated while others wait for the lock.
  const auto & servos = bank_.servos();
  diagnostics_.resize(servos.size());
  for (std::size_t i = 0; i < servos.size(); ++i) {
    const DeviceHealth & health = servos[i].health();
    ServoDiagnostics & d = diagnostics_[i];
    d.name = servos[i].name();
    d.counts = health.counts();
    d.faulty = health.faulty();
    d.last_fault = health.last_fault();
    d.state = servos[i].state();
  }
  line_counts_ = bank_.health().counts();
}

}  // namespace stetro_driver::linux_io
