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

#include "linux/linux_robot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "command_rules.hpp"
#include "linux/device_status.hpp"

namespace stetro_driver::linux_io
{
namespace
{

/// A VL53L0X has 2 mm of noise: whole seconds of one millimetre are no measurement.
constexpr std::uint32_t kStuckRepeats = 60;

constexpr JointCommand kStop{MotionKind::kStop};

constexpr Time kBriefSilence = std::chrono::seconds{1};
std::string place_name(std::size_t place) { return std::string(kRangeNames[place]); }

/// Servos do not feel weight: blocks that stand are taken to carry equal shares of it.
void share_weight(std::array<BlockReading, kBlocks> & blocks)
{
  const auto feet = std::count_if(
    blocks.begin(), blocks.end(), [](const BlockReading & block) { return block.at_lower_lock; });
  for (BlockReading & block : blocks) {
    block.load = block.at_lower_lock ? 1.0 / static_cast<double>(feet) : 0.0;
  }
}

bool is_stuck(const TofLatest & latest)
{
  return latest.repeats >= kStuckRepeats && std::isfinite(latest.reading.range_m);
}

}  // namespace

LinuxRobot::LinuxRobot(
  const Devices & devices, const TofLimits & limits, const DeviceClock & clock,
  const LinuxDoors & doors)
: devices_(devices), limits_(limits), clock_(clock), doors_(doors)
{
}

LinuxRobot::~LinuxRobot()
{
  LinuxRobot::make_safe();
  release();
}

void LinuxRobot::release()
{
  const std::lock_guard<std::mutex> lock{chassis_mutex_};
  chassis_.reset();
  ranges_.reset();
  contacts_.reset();
  imu_.reset();
}

void LinuxRobot::configure()
{
  if (configured_) {
    return;
  }
  openings_.clear();
  open("contacts", [this] {
    contacts_ = std::make_unique<ContactLines>(devices_.contacts, doors_.lines, clock_);
    contacts_->start();
  });
  open("servos", [this] {
    auto chassis = std::make_unique<Chassis>(devices_.chassis, clock_);
    chassis->configure();
    const std::lock_guard<std::mutex> lock{chassis_mutex_};
    chassis_ = std::move(chassis);
  });
  open("range sensors", [this] {
    ranges_ = std::make_unique<TofArray>(devices_.range_sensors, limits_, doors_.files, clock_);
    ranges_->start();
  });
  open("imu", [this] { imu_ = std::make_unique<Vn100>(devices_.imu, clock_); });
  std::string wrong;
  for (const DeviceStatus & kind : openings_) {
    if (kind.fault) {
      wrong += (wrong.empty() ? "" : "\n") + kind.fault->detail;
    }
  }
  if (!wrong.empty()) {
    release();
    throw HardwareError(wrong);
  }
  configured_ = true;
}

void LinuxRobot::open(const std::string & kind, const std::function<void()> & action)
{
  DeviceStatus status;
  status.name = kind;
  try {
    action();
  } catch (const std::exception & error) {
    // Also what a library throws: the other devices are looked at, and people are told of all.
    status.fault = IoFault{IoFaultKind::kNotConfigured, error.what()};
  }
  openings_.push_back(std::move(status));
}

void LinuxRobot::activate()
{
  if (!configured_) {
    throw HardwareError("the robot is not configured");
  }
  safe_ = false;  // from now on: what makes it safe in between is not forgotten
  sense(frame_.time);
  if (switches_.emergency_stop_latched) {
    throw HardwareError("the emergency stop is latched, accepted: after its reset");
  }
  chassis_->activate();  // before its trouble is looked at: latched errors are cleared by it
  sense(frame_.time);
  if (trouble_) {
    chassis_->deactivate();
    throw HardwareError(trouble_->detail);
  }
  active_ = true;
}

void LinuxRobot::deactivate()
{
  active_ = false;
  if (chassis_ != nullptr) {
    chassis_->deactivate();
  }
}

void LinuxRobot::reset_emergency_stop()
{
  if (!configured_) {
    throw HardwareError("the robot is not configured");
  }
  if (const auto fault = contacts_->reset_emergency_stop()) {
    throw HardwareError(fault->detail);
  }
  static_cast<void>(chassis_->command(kStop));
  sense(frame_.time);
}

Result<SensorFrame> LinuxRobot::read(Time now)
{
  if (!configured_) {
    return IoFault{IoFaultKind::kNotConfigured, "the robot is not configured"};
  }
  if (now < frame_.time) {
    return IoFault{
      IoFaultKind::kTime, "asked for " + std::to_string(time_to_seconds(now)) + " s after " +
                            std::to_string(time_to_seconds(frame_.time)) + " s"};
  }
  sense(now);
  if (active_ && (switches_.emergency_stop_latched || trouble_)) {
    static_cast<void>(chassis_->command(kStop));  // also when nobody writes any more
  }
  return frame_;
}

void LinuxRobot::sense(Time now)
{
  const Time device_now = clock_.now();
  const Time shift = shift_.take(now, device_now);
  const auto moved = [shift](Time stamp) {
    return stamp > Time::zero() ? stamp + shift : Time::zero();
  };
  frame_.time = std::max(now, device_now + shift);  // the later of both is when we looked
  sense_ranges(device_now, shift);
  sense_contacts(device_now, shift);
  frame_.gyro = imu_->reading(device_now);
  frame_.gyro.stamp = moved(frame_.gyro.stamp);
  motion_ = chassis_->reading();
  sense_blocks(device_now, shift);
  frame_.steering = motion_.steering;
  frame_.odometry = motion_.odometry;
  frame_.odometry.stamp = moved(motion_.odometry.stamp);
  find_trouble(device_now);
}

void LinuxRobot::sense_ranges(Time device_now, Time shift)
{
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto place = static_cast<RangePlace>(i);
    if (!ranges_->fitted(place)) {
      continue;  // reads kFault since ever
    }
    latest_[i] = ranges_->latest(place, device_now);
    RangeReading & reading = frame_.ranges[i];
    reading = latest_[i].reading;
    if (reading.stamp > Time::zero()) {
      reading.stamp += shift;
    }
    if (is_stuck(latest_[i])) {
      reading.status = RangeStatus::kFault;
    }
  }
  frame_.ranges_complete = cycle_complete(device_now);
}

// Each sensor measures at its own pace. A cycle ends when all that are well have something new.
bool LinuxRobot::cycle_complete(Time device_now)
{
  const Time longest = 2 * seconds_to_time(devices_.range_sensors.period_s);
  bool any = false;
  bool all = true;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    if (ranges_->fitted(static_cast<RangePlace>(i)) && !latest_[i].fault) {
      const bool fresh = latest_[i].number != told_[i];
      any = any || fresh;
      all = all && fresh;
    }
  }
  if (!(any && all) && device_now - cycle_ended_ < longest) {
    return false;
  }
  cycle_ended_ = device_now;
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    told_[i] = latest_[i].number;
  }
  return true;
}

bool LinuxRobot::BriefTrouble::lets_pass(bool in_trouble, Time device_now)
{
  if (!in_trouble) {
    well_ = device_now;
  }
  return !in_trouble || device_now - well_ > kBriefSilence;
}

void LinuxRobot::sense_contacts(Time device_now, Time shift)
{
  switches_ = contacts_->latest(device_now);
  frame_.emergency_stop_latched = switches_.emergency_stop_latched;
  if (!of_contacts_.lets_pass(switches_.fault.has_value(), device_now)) {
    return;
  }
  frame_.contacts = switches_.contacts;
  for (ContactReading & contact : frame_.contacts) {
    if (contact.last_change > Time::zero()) {
      contact.last_change += shift;
    }
  }
}

void LinuxRobot::sense_blocks(Time device_now, Time shift)
{
  if (of_chassis_.lets_pass(motion_.fault.has_value(), device_now)) {
    frame_.blocks_stamp = motion_.stamp > Time::zero() ? motion_.stamp + shift : Time::zero();
    frame_.blocks = motion_.blocks;
    share_weight(frame_.blocks);
  }
}

/// Its words are copied only when it is another fault than before.
void LinuxRobot::find_trouble(Time device_now)
{
  const auto set = [this](const IoFault & fault) {
    if (!trouble_ || trouble_->kind != fault.kind || trouble_->detail != fault.detail) {
      trouble_ = fault;
    }
  };
  if (motion_.fault) {
    set(*motion_.fault);
    return;
  }
  if (switches_.fault) {
    set(words_of(contacts_->report().health, *switches_.fault));
    return;
  }
  if (const auto fault = imu_->fault(device_now)) {
    set(*fault);
    return;
  }
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto place = static_cast<RangePlace>(i);
    if (ranges_->fitted(place) && (latest_[i].fault || is_stuck(latest_[i]))) {
      set(range_trouble(place));
      return;
    }
  }
  trouble_.reset();
}

IoFault LinuxRobot::range_trouble(RangePlace place) const
{
  const auto i = static_cast<std::size_t>(place);
  if (latest_[i].fault) {
    return words_of(ranges_->report(place).health, *latest_[i].fault);
  }
  return {IoFaultKind::kBadAnswer, place_name(i) + ": the same millimetre over and over, stuck"};
}

std::optional<IoFault> LinuxRobot::write(const JointCommand & command)
{
  auto fault = refusal(command);
  if (chassis_ == nullptr) {
    return fault;
  }
  auto untold = chassis_->command(fault ? kStop : command);
  return fault ? fault : untold;
}

std::optional<IoFault> LinuxRobot::refusal(const JointCommand & command)
{
  if (!active_ || safe_) {
    return IoFault{IoFaultKind::kNotActive, "the motors have no power"};
  }
  if (switches_.emergency_stop_latched) {
    return IoFault{IoFaultKind::kEmergencyStop, "the emergency stop is latched"};
  }
  if (trouble_) {
    return trouble_;
  }
  if (auto fault = nonsense_in(command)) {
    return fault;
  }
  return wheels_refuse(command, frame_.steering.angle_rad);
}

void LinuxRobot::make_safe() noexcept
{
  safe_ = true;
  const std::lock_guard<std::mutex> lock{chassis_mutex_};
  if (chassis_ != nullptr) {
    chassis_->make_safe();
  }
}

std::vector<DeviceStatus> LinuxRobot::devices() const
{
  if (!configured_) {
    return openings_;
  }
  std::vector<DeviceStatus> all;
  const Time now = clock_.now();
  for (const ServoDiagnostics & servo : chassis_->diagnostics()) {
    all.push_back(status_of(servo));
  }
  if (std::string trouble = chassis_->blocks_trouble(); !trouble.empty()) {
    all.push_back({"blocks_file", IoFault{IoFaultKind::kBadAnswer, std::move(trouble)}, {}});
  }
  all.push_back(status_of(contacts_->report()));
  all.push_back(status_of(*imu_, now));
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const auto place = static_cast<RangePlace>(i);
    if (ranges_->fitted(place)) {
      all.push_back(status_of(place_name(i), ranges_->report(place)));
    }
  }
  return all;
}

}  // namespace stetro_driver::linux_io
