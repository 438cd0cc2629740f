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

#include "emulator/herkulex_emulator.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace stetro_driver::emulator
{
namespace
{

using linux_io::HerkulexBytes;
using linux_io::HerkulexPacket;

// What a host hears when two replies are on the line at once.
HerkulexBytes collide(const HerkulexBytes & a, const HerkulexBytes & b)
{
  HerkulexBytes both = a.size > b.size ? a : b;
  for (std::size_t i = 0; i < std::min(a.size, b.size); ++i) {
    both.bytes[i] = a.bytes[i] & b.bytes[i];
  }
  return both;
}

}  // namespace

HerkulexEmulator::HerkulexEmulator(
  const HerkulexLine & line, const std::vector<std::uint8_t> & ids, linux_io::DeviceClock clock)
: line_(line),
  clock_(clock),
  pty_(line.link),
  servos_(ids.begin(), ids.end()),
  wake_fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
  thread_([this] { run(); })
{
}

HerkulexEmulator::~HerkulexEmulator()
{
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    stop_ = true;
  }
  wake();
  thread_.join();
  close(wake_fd_);
}

EmulatedServo * HerkulexEmulator::find(std::uint8_t id)
{
  for (EmulatedServo & servo : servos_) {
    if (servo.id() == id) {
      servo.advance(clock_.now());
      return &servo;
    }
  }
  return nullptr;
}

void HerkulexEmulator::set_faults(const HerkulexFaults & faults)
{
  const std::lock_guard<std::mutex> lock{mutex_};
  faults_ = faults;
}

void HerkulexEmulator::unplug()
{
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    pty_.unplug();
    to_servos_.clear();
    to_host_.clear();
    replies_.clear();
    decoder_.reset();
  }
  wake();
}

void HerkulexEmulator::plug()
{
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    pty_.plug();
  }
  wake();
}

std::uint64_t HerkulexEmulator::heard() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return heard_;
}

void HerkulexEmulator::run()
{
  while (true) {
    int pty_fd = -1;
    std::optional<Time> until;
    {
      const std::lock_guard<std::mutex> lock{mutex_};
      if (stop_) {
        return;
      }
      const Time now = clock_.now();
      listen(now);
      watch_relay(now);
      talk(now);
      pty_fd = pty_.fd();
      until = next_event();
    }
    sleep(pty_fd, until);
  }
}

void HerkulexEmulator::listen(Time now)
{
  std::array<std::uint8_t, 256> chunk{};
  const bool understood = pty_.baud() == line_.baud;
  while (const std::size_t count = pty_.read(chunk.data(), chunk.size())) {
    heard_at_ = now;
    if (understood) {
      to_servos_.send(chunk.data(), count, now, line_.baud);
    }
  }
  while (const std::size_t count = to_servos_.receive(chunk.data(), chunk.size(), now)) {
    const std::uint64_t bad = decoder_.bad_checksums();
    decoder_.feed(chunk.data(), count, [&](const HerkulexPacket & packet) { ask(packet, now); });
    if (decoder_.bad_checksums() != bad) {
      std::for_each(servos_.begin(), servos_.end(), [](auto & servo) { servo.hear_garbage(); });
    }
  }
}

// A timer that every byte of the host starts anew holds the relay.
void HerkulexEmulator::watch_relay(Time now)
{
  const bool open = now >= heard_at_ + line_.relay_after;
  if (open && !relay_open_) {
    for (EmulatedServo & servo : servos_) {
      if (line_.on_relay.count(servo.id()) != 0) {
        servo.power_cycle();
      }
    }
  }
  relay_open_ = open;
}

void HerkulexEmulator::ask(const HerkulexPacket & packet, Time now)
{
  ++heard_;
  std::optional<HerkulexBytes> wire;
  for (EmulatedServo & servo : servos_) {
    const auto reply = servo.hear(packet, now);
    if (reply && faults_.silent.count(servo.id()) == 0) {
      wire = wire ? collide(*wire, encode(*reply)) : encode(*reply);
    }
  }
  if (wire) {
    replies_.push_back({now + line_.turn_round + faults_.delay, *wire});
  }
}

void HerkulexEmulator::talk(Time now)
{
  while (!replies_.empty() && replies_.front().due <= now) {
    HerkulexBytes wire = replies_.front().wire;
    replies_.pop_front();
    if (std::uniform_real_distribution<double>{}(random_) < faults_.garbled) {
      garble(wire);
    }
    to_host_.send(wire.bytes.data(), wire.size, now, line_.baud);
  }
  std::array<std::uint8_t, 256> chunk{};
  while (const std::size_t count = to_host_.receive(chunk.data(), chunk.size(), now)) {
    pty_.write(chunk.data(), count);
  }
}

void HerkulexEmulator::garble(HerkulexBytes & wire)
{
  const std::size_t at = random_() % wire.size;
  if (random_() % 2 == 0) {
    // Not bit 0: the checksums of this protocol do not see it in a payload.
    wire.bytes[at] = static_cast<std::uint8_t>(wire.bytes[at] ^ (2U << (random_() % 7)));
    return;
  }
  std::copy(
    wire.bytes.begin() + static_cast<std::ptrdiff_t>(at) + 1,
    wire.bytes.begin() + static_cast<std::ptrdiff_t>(wire.size),
    wire.bytes.begin() + static_cast<std::ptrdiff_t>(at));
  --wire.size;
}

std::optional<Time> HerkulexEmulator::next_event() const
{
  std::optional<Time> next;
  const auto offer = [&](std::optional<Time> time) {
    if (time && (!next || *time < *next)) {
      next = time;
    }
  };
  offer(to_servos_.all_arrived());
  offer(to_host_.all_arrived());
  offer(relay_open_ ? std::nullopt : std::optional<Time>{heard_at_ + line_.relay_after});
  offer(replies_.empty() ? std::nullopt : std::optional<Time>{replies_.front().due});
  return next;
}

void HerkulexEmulator::sleep(int pty_fd, std::optional<Time> until) const
{
  timespec span{};
  if (until) {
    const Time left = std::max(Time::zero(), clock_.real(*until - clock_.now()));
    span.tv_sec = left.count() / 1'000'000'000;
    span.tv_nsec = left.count() % 1'000'000'000;
  }
  std::array<pollfd, 2> lines{{{wake_fd_, POLLIN, 0}, {pty_fd, POLLIN, 0}}};  // poll() skips -1
  ppoll(lines.data(), lines.size(), until ? &span : nullptr, nullptr);
  std::uint64_t count = 0;
  [[maybe_unused]] const auto got = read(wake_fd_, &count, sizeof(count));
}

void HerkulexEmulator::wake() const
{
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto put = write(wake_fd_, &one, sizeof(one));
}

}  // namespace stetro_driver::emulator
