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

#include "emulator/vn100_emulator.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <vector>

#include "linux/imu/vn100_ascii.hpp"
#include "linux/imu/vn100_binary.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::Axes;

constexpr Time kIdle = std::chrono::milliseconds{5};    // looks at what it is told so often
constexpr Time kBusy = std::chrono::microseconds{500};  // delivers bytes so often
constexpr std::size_t kLongestCommand = 256;
constexpr int kMostBehind = 20;  // measurements a starved thread makes up for

void wait_for(int fd, Time patience)
{
  pollfd host{fd, POLLIN, 0};
  const std::time_t seconds = patience.count() / 1'000'000'000;
  const timespec limit{seconds, static_cast<long>(patience.count() % 1'000'000'000)};  // NOLINT
  ppoll(&host, 1, &limit, nullptr);
}

}  // namespace

Vn100Emulator::Vn100Emulator(
  const Vn100EmulatorOptions & options, const linux_io::DeviceClock & clock)
: options_(options),
  clock_(clock),
  mounting_(options.mounting_roll_rad, options.mounting_pitch_rad, options.mounting_yaw_rad),
  pty_(options.link),
  registers_(options.model, options.serial_number, options.baud),
  moved_at_(clock.now()),
  started_(moved_at_),
  last_(started_),
  interval_began_(started_),
  random_(options.seed)
{
  thread_ = std::thread([this] { run(); });
}

Vn100Emulator::~Vn100Emulator()
{
  stop_ = true;
  thread_.join();
}

void Vn100Emulator::set_motion(const ImuMotion & motion, Time since)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (pty_.plugged()) {
    measure(since);  // what is due until then, it was another motion
  }
  turned_before_rad_ = turned_rad(since);
  moved_at_ = since;
  motion_ = motion;
}

Axes Vn100Emulator::turned_rad(Time until) const
{
  Axes turned = turned_before_rad_;
  for (std::size_t i = 0; i < turned.size(); ++i) {
    turned[i] += motion_.rate_rad_s[i] * time_to_seconds(until - moved_at_);
  }
  return turned;
}

void Vn100Emulator::begin_interval()
{
  interval_began_ = last_;
  turned_at_begin_rad_ = turned_rad(last_);
}

void Vn100Emulator::set_trouble(const Vn100Trouble & trouble)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (trouble.slow != trouble_.slow) {
    last_ = clock_.now();  // a measurement that was due at the other speed is not made up for
  }
  trouble_ = trouble;
}

void Vn100Emulator::unplug()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  pty_.unplug();
}

void Vn100Emulator::plug()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!pty_.plugged()) {
    pty_.plug();
    start_anew();
  }
}

void Vn100Emulator::replace(const std::string & model, const std::string & serial_number)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  pty_.unplug();
  options_.model = model;
  options_.serial_number = serial_number;
}

void Vn100Emulator::start_anew()
{
  registers_ = Vn100Registers(options_.model, options_.serial_number, options_.baud);
  line_.clear();
  heard_.clear();
  started_ = clock_.now();
  last_ = started_;
  begin_interval();
}

void Vn100Emulator::run()
{
  while (!stop_) {
    int fd = -1;
    Time patience{0};
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      patience = serve(clock_.now());
      fd = pty_.fd();
    }
    wait_for(fd, clock_.real(patience));
  }
}

/// What is due. \return for how long nothing will be
Time Vn100Emulator::serve(Time now)
{
  if (!pty_.plugged()) {
    return kIdle;
  }
  hear(now);
  measure(now);
  deliver(now);
  return line_.all_arrived() ? kBusy : kIdle;
}

void Vn100Emulator::hear(Time now)
{
  std::array<std::uint8_t, kLongestCommand> bytes{};
  const std::size_t count = pty_.read(bytes.data(), bytes.size());
  if (trouble_.silent || pty_.baud() != registers_.baud()) {
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (happens(trouble_.lose_per_byte)) {
      continue;
    }
    const auto c = static_cast<char>(bytes[i] ^ (happens(trouble_.flip_per_byte) ? 0x04 : 0));
    if (c == '$' || heard_.size() > kLongestCommand) {
      heard_.clear();
    }
    if (c != '\n' && c != '\r') {
      heard_ += c;
    } else if (!heard_.empty() && heard_[0] == '$') {
      const std::uint32_t baud = registers_.baud();  // an answer comes before the speed changes
      const std::string answer = registers_.answer(heard_);
      heard_.clear();
      send(answer, now, baud);
    }
  }
}

void Vn100Emulator::measure(Time now)
{
  const bool binary = registers_.binary_rate_hz() > 0.0;
  const double rate_hz = binary ? registers_.binary_rate_hz() : registers_.ascii_rate_hz();
  if (rate_hz <= 0.0) {
    last_ = std::max(last_, now);
    begin_interval();
    return;
  }
  const Time period = seconds_to_time(trouble_.slow / rate_hz);
  last_ = std::max(last_, now - kMostBehind * period);
  while (last_ + period <= now) {
    last_ += period;
    std::string frame;
    if (binary) {
      const auto packet = linux_io::to_binary(sample());
      frame.assign(packet.begin(), packet.end());
    } else {
      frame = linux_io::to_ascii(linux_io::ymr_body(sample()), registers_.checksum());
    }
    send(frame, last_, registers_.baud());
  }
}

linux_io::Vn100Sample Vn100Emulator::sample()
{
  const double lasted_s = time_to_seconds(last_ - interval_began_);
  Axes rate_rad_s = turned_rad(last_);
  for (std::size_t i = 0; i < rate_rad_s.size(); ++i) {
    rate_rad_s[i] = (rate_rad_s[i] - turned_at_begin_rad_[i]) / lasted_s;
  }
  begin_interval();
  return {
    mounting_.to_sensor(motion_.base_in_world), mounting_.to_sensor(rate_rad_s),
    mounting_.to_sensor(motion_.acceleration_m_s2), last_ - started_};
}

bool Vn100Emulator::happens(double probability)
{
  return probability > 0.0 && std::uniform_real_distribution<double>{}(random_) < probability;
}

void Vn100Emulator::send(const std::string & frame, Time now, std::uint32_t baud)
{
  if (trouble_.silent) {
    return;
  }
  const bool wrong_baud = pty_.baud() != baud;
  std::vector<std::uint8_t> bytes;
  for (const char c : frame) {
    auto byte = static_cast<std::uint8_t>(c);
    if (wrong_baud) {
      byte = static_cast<std::uint8_t>(random_());
    } else if (happens(trouble_.flip_per_byte)) {
      byte = static_cast<std::uint8_t>(byte ^ (1U << (random_() % 8)));
    }
    if (!happens(trouble_.lose_per_byte)) {
      bytes.push_back(byte);
    }
  }
  line_.send(bytes.data(), bytes.size(), now, baud);
}

void Vn100Emulator::deliver(Time now)
{
  std::array<std::uint8_t, 512> bytes{};
  for (std::size_t count = bytes.size(); count == bytes.size();) {
    count = line_.receive(bytes.data(), bytes.size(), now);
    pty_.write(bytes.data(), count);
  }
}

}  // namespace stetro_driver::emulator
