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

#include "linux/imu/vn100.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace stetro_driver::linux_io
{
namespace
{

constexpr Time kGiveUp = std::chrono::milliseconds{500};  // and open it again
constexpr Time kFirstSamples = std::chrono::seconds{1};   // beyond those it waits for

Vn100Config checked(const Vn100Config & config)
{
  stetro_config::Faults faults;
  check(config, faults);
  if (!faults.empty()) {
    throw HardwareError("VN-100: " + to_string(faults[0]));
  }
  return config;
}

std::string in_seconds(Time time) { return std::to_string(time_to_seconds(time)) + " s"; }

}  // namespace

Vn100::Vn100(const Vn100Config & config, const DeviceClock & clock)
: config_(checked(config)),
  clock_(clock),
  mounting_(config.mounting_roll_rad, config.mounting_pitch_rad, config.mounting_yaw_rad),
  limit_(
    config.silent_periods * vn100_period(config) + seconds_to_time(config.latency_s) +
    vn100_wire_time(config, vn100_frame_size(config))),
  health_("VN-100")
{
  identity_.serial_number = config.serial_number;
  open();  // here, so that what is wrong at the start is thrown
  if (health_.faulty()) {
    throw HardwareError(health_.last_fault()->detail);
  }
  thread_ = std::thread([this] { run(); });
  await_first();
}

Vn100::~Vn100() { stop(); }

void Vn100::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Vn100::await_first()
{
  const Time patience = clock_.real(kFirstSamples + (kTrustAfter + 1) * vn100_period(config_));
  std::optional<std::string> trouble;
  {
    std::unique_lock<std::mutex> lock(mutex_);
    const bool came =
      changed_.wait_for(lock, patience, [this] { return health_.counts().good > 0; });
    if (!came) {
      trouble = health_.last_fault() ? health_.last_fault()->detail : "VN-100: no measurement";
    }
  }
  if (trouble) {
    stop();
    throw HardwareError(*trouble + ", accepted: " + config_.output + " output as configured");
  }
}

void Vn100::open()
{
  try {
    session_ = std::make_unique<Vn100Session>(config_, clock_, stop_);
  } catch (const HardwareError & error) {
    complain({IoFaultKind::kSilent, error.what()});
    close();
    return;
  }
  const auto identity = session_->identify();
  std::optional<IoFault> fault;
  if (!identity) {
    fault = identity.fault();
  } else if (identity.value().model.rfind(config_.model, 0) != 0) {
    fault = IoFault{
      IoFaultKind::kBadAnswer,
      "VN-100: model '" + identity.value().model + "' answers, accepted: " + config_.model};
  } else if (
    !identity_.serial_number.empty() && identity.value().serial_number != identity_.serial_number) {
    fault = IoFault{
      IoFaultKind::kBadAnswer, "VN-100: replaced by serial number " +
                                 identity.value().serial_number +
                                 ", accepted: " + identity_.serial_number};
  } else {
    fault = session_->configure();
  }
  if (fault) {
    complain(*fault);
    close();
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  identity_ = identity.value();
  health_.opened();
  opened_at_ = clock_.now();
  stamp_ = opened_at_;  // silence counts from here
}

void Vn100::close()
{
  session_.reset();
  timeline_ = {};
  uptime_.reset();
  in_time_ = 0;
  hurt_before_ = 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.closed(clock_.now());
}

void Vn100::run()
{
  while (!stop_) {
    if (session_) {
      converse();
      continue;
    }
    std::optional<Time> open_at;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      open_at = health_.open_at();
    }
    if (!wait_until(open_at.value_or(clock_.now()))) {
      open();
    }
  }
}

bool Vn100::wait_until(Time then)
{
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, clock_.real(then - clock_.now()), [this] { return stop_.load(); });
}

void Vn100::converse()
{
  const auto sink = [this](const Vn100Frame & frame, Time arrival) { take(frame, arrival); };
  const Time now = clock_.now();
  const Time until = stamp_ + limit_;
  const Time patience = until > now ? until - now : vn100_period(config_);
  if (const auto fault = session_->listen(patience, sink)) {
    complain(*fault);
    close();
    return;
  }
  const Time age = clock_.now() - stamp_;
  if (age > limit_) {
    in_time_ = 0;
    complain(silence(age));
  }
  std::optional<Time> faulty_since;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stream_ = session_->counts();
    faulty_since = health_.faulty_since();
  }
  if (faulty_since && clock_.now() - std::max(*faulty_since, opened_at_) > kGiveUp + limit_) {
    close();
  }
}

std::optional<Vn100Sample> Vn100::sample_in(const Vn100Frame & frame)
{
  const auto * sentence = std::get_if<AsciiSentence>(&frame);
  if ((sentence != nullptr) != (config_.output == "ascii")) {
    return std::nullopt;  // of an output that was switched off, or an answer
  }
  auto sample = sentence ? sample_of(*sentence) : sample_of(std::get<BinaryPacket>(frame));
  if (!sample || !is_plausible(*sample)) {
    return std::nullopt;
  }
  if (sample->uptime && uptime_ && *sample->uptime <= *uptime_) {
    return std::nullopt;  // its clock stands, or it has started again
  }
  uptime_ = sample->uptime;
  return sample;
}

void Vn100::take(const Vn100Frame & frame, Time arrival)
{
  const auto sample = sample_in(frame);
  if (!sample) {
    return;
  }
  const Time sent = arrival - seconds_to_time(config_.latency_s);
  Time stamp = sample->uptime ? timeline_.stamp(*sample->uptime, sent) : sent;
  stamp = std::max(stamp, stamp_ + Time{1});  // it never runs backwards
  const Time lasted = stamp - stamp_;
  in_time_ = lasted > limit_ ? 1 : in_time_ + 1;
  stamp_ = stamp;
  hurt_before_ = session_->counts().lost_bytes;
  if (in_time_ >= kTrustAfter) {
    believe(*sample, stamp, lasted);
  }
}

void Vn100::believe(const Vn100Sample & sample, Time stamp, Time lasted)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    turning_.add(mounting_.to_base(sample.rate_rad_s), lasted);
    reading_.stamp = stamp;
    reading_.attitude = AttitudeReading{
      mounting_.to_base(sample.sensor_in_ned), config_.tilt_std_dev_rad, config_.yaw_std_dev_rad};
    reading_.acceleration_m_s2 = mounting_.to_base(sample.acceleration_m_s2);
    reading_.acceleration_std_dev_m_s2 = config_.acceleration_std_dev_m_s2;
    health_.answered();
  }
  changed_.notify_all();
}

void Vn100::complain(const IoFault & fault)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.failed(clock_.now(), fault);
}

IoFault Vn100::silence(Time age) const
{
  const std::uint64_t hurt = session_->counts().lost_bytes - hurt_before_;
  if (hurt > 0) {
    return {
      IoFaultKind::kBadAnswer,
      "VN-100: garbled, " + std::to_string(hurt) + " bytes of no frame in " + in_seconds(age)};
  }
  return {IoFaultKind::kSilent, "VN-100: no measurement for " + in_seconds(age)};
}

GyroReading Vn100::reading(Time now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const auto mean = turning_.take()) {
    reading_.rate_rad_s = mean->rate_rad_s;
    reading_.std_dev_rad_s =
      config_.rate_std_dev_rad_s / std::sqrt(static_cast<double>(mean->samples));
  }
  GyroReading reading = reading_;
  reading.fault = health_.faulty() || now - reading.stamp > limit_;
  return reading;
}

std::optional<IoFault> Vn100::fault(Time now) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (health_.faulty()) {
    return health_.last_fault();
  }
  if (now - reading_.stamp > limit_) {  // and the reader has not come to say so
    return IoFault{
      IoFaultKind::kSilent, "VN-100: no measurement for " + in_seconds(now - reading_.stamp)};
  }
  return std::nullopt;
}

Vn100Statistics Vn100::statistics() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return {identity_, health_.counts(), stream_.bad_checksums, stream_.lost_bytes};
}

}  // namespace stetro_driver::linux_io
