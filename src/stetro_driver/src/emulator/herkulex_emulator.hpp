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

#ifndef EMULATOR__HERKULEX_EMULATOR_HPP_
#define EMULATOR__HERKULEX_EMULATOR_HPP_

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "emulator/emulated_servo.hpp"
#include "emulator/line_pacer.hpp"
#include "emulator/pty.hpp"
#include "linux/device_clock.hpp"
#include "linux/servo/herkulex_packet.hpp"

namespace stetro_driver::emulator
{

/// The line the emulated servos hang on.
struct HerkulexLine
{
  std::string link;              ///< the host opens this path
  std::uint32_t baud = 115'200;  ///< of the servos: a host at another speed is not understood
  Time turn_round = std::chrono::microseconds{200};  ///< from request to reply
  /// Servos whose power a relay cuts while the host says nothing: on a robot, the wheels.
  std::set<std::uint8_t> on_relay{};
  Time relay_after = std::chrono::milliseconds{100};
};

/// What is wrong with the line or its servos.
struct HerkulexFaults
{
  std::set<std::uint8_t> silent{};  ///< ids that hear and act, and do not reply
  Time delay{0};                    ///< added to every reply
  double garbled = 0.0;             ///< share of the replies that lose a byte or flip a bit
};

/// HerkuleX servos on one pseudo-terminal, at the speed of a real line, with faults on demand.
/**
 * A thread of its own listens and replies; all else is thread safe. Requests and replies take their
 * time on the wire. Two servos of one id reply over each other, and what arrives is neither.
 * Randomness comes from a fixed seed.
 */
class HerkulexEmulator
{
public:
  /// \throws std::system_error when there is no pseudo-terminal or no place for its link
  HerkulexEmulator(
    const HerkulexLine & line, const std::vector<std::uint8_t> & ids, linux_io::DeviceClock clock);
  ~HerkulexEmulator();
  HerkulexEmulator(const HerkulexEmulator &) = delete;
  HerkulexEmulator & operator=(const HerkulexEmulator &) = delete;

  /// Brings a servo up to the present and gives it to `act(EmulatedServo &)`.
  /** \throws std::out_of_range when no servo has that id */
  template <class Act>
  auto with(std::uint8_t id, Act && act)
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (EmulatedServo * const servo = find(id)) {
      return act(*servo);
    }
    throw std::out_of_range("no emulated servo " + std::to_string(id));
  }

  /// The same, and nothing happens when no servo has that id: it may have been replaced.
  template <class Act>
  void if_there(std::uint8_t id, Act && act)
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (EmulatedServo * const servo = find(id)) {
      act(*servo);
    }
  }

  void set_faults(const HerkulexFaults & faults);
  void unplug();
  void plug();

  /// Packets heard since the start.
  [[nodiscard]] std::uint64_t heard() const;

private:
  struct Reply
  {
    Time due;
    linux_io::HerkulexBytes wire;
  };

  /// Brought up to the present; null: there is none.
  [[nodiscard]] EmulatedServo * find(std::uint8_t id);
  void run();
  void listen(Time now);
  void ask(const linux_io::HerkulexPacket & packet, Time now);
  void talk(Time now);
  void garble(linux_io::HerkulexBytes & wire);
  void watch_relay(Time now);
  [[nodiscard]] std::optional<Time> next_event() const;
  void sleep(int pty_fd, std::optional<Time> until) const;
  void wake() const;

  HerkulexLine line_;
  linux_io::DeviceClock clock_;
  mutable std::mutex mutex_;
  Pty pty_;
  std::vector<EmulatedServo> servos_;
  HerkulexFaults faults_{};
  LinePacer to_servos_;
  LinePacer to_host_;
  linux_io::HerkulexDecoder decoder_;
  std::deque<Reply> replies_;
  std::mt19937 random_{20260403};
  std::uint64_t heard_ = 0;
  Time heard_at_{0};
  bool relay_open_ = false;
  bool stop_ = false;
  int wake_fd_;
  std::thread thread_;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__HERKULEX_EMULATOR_HPP_
