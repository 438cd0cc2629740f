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

#ifndef STETRO_DRIVER__COMMAND_GATE_HPP_
#define STETRO_DRIVER__COMMAND_GATE_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// A command as it arrived: who asks, in which order, for how long.
struct CommandRequest
{
  std::string issuer;
  bool issuer_cut = false;  ///< it fills its field, so it may be the stump of a longer name
  std::uint64_t issuer_instance = 0;  ///< drawn anew when the issuer's process starts
  std::uint64_t sequence_number = 0;
  Time stamp{0};  ///< time of issue, on the robot's clock
  Time valid_for{
    0};  ///< how long it may act from its stamp, or from its reception if that is earlier
  JointCommand motion{};
};

/// Why a command was refused. Numbered as on the wire (CommandStatus, REASON_*).
enum class Refusal : std::uint8_t {
  kNone = 0,
  kOutOfOrder = 1,
  kForeignIssuer = 2,
  kNotFinite = 3,
  kOutOfBounds = 4,
  kWrongSteering = 5,
  kNotActive = 6,
  kEmergencyStop = 7,
  kFault = 8,
  kBadStamp = 9,
  kNotSupported = 10,
  kUnknownKind = 11,
  kBadIssuer = 12,
  kBusy = 13,
  kUnsafe = 14,
};
constexpr std::size_t kRefusals = 15;

/// A word for a counter or a log, such as "out_of_order".
[[nodiscard]] std::string_view to_string(Refusal reason);

/// What is accepted.
struct GateLimits
{
  double max_vx_m_s = 0.30;              ///< along x, either way [m/s]
  double max_vy_m_s = 0.30;              ///< along y, either way [m/s]
  double max_wz_rad_s = 0.50;            ///< turn, either way [rad/s]
  Time max_valid_for{200'000'000};       ///< longest life of a command
  Time max_skew{20'000'000};             ///< how far a stamp may lie in the future
  Time stall_limit{200'000'000};         ///< a robot clock that stands still this long has stalled
  double steering_tolerance_rad = 0.03;  ///< wheels nearer than this stand in a direction
};

/// Both clocks at one moment.
struct GateClocks
{
  Time now{0};     ///< the robot's clock: system time, or simulated time
  Time steady{0};  ///< a clock that never stops or jumps
};

/// What the gate has to know of the robot.
struct GateSituation
{
  bool active = false;                  ///< motors have power
  bool emergency_stop = false;          ///< latched
  bool emergency_stop_pressed = false;  ///< its button is down
  bool fault = false;                   ///< the hardware has a fault
  bool refused_power = false;           ///< it should have power, and could not be given it
  double steering_rad = 0.0;
  bool steering_moving = false;
  std::array<bool, 3> standing{true, true, true};  ///< blocks 1, 2, 3 carry weight
};

/// The answer to one command.
struct Verdict
{
  Refusal reason = Refusal::kNone;
  std::string detail;  ///< field, value, what is accepted; empty when accepted

  [[nodiscard]] bool accepted() const { return reason == Refusal::kNone; }
};

/// Whose command ran out.
struct Expiry
{
  std::string issuer;
  std::uint64_t issuer_instance = 0;
  std::uint64_t sequence_number = 0;
};

/// What acts at one moment.
struct InForce
{
  JointCommand command{};         ///< kHold when nothing is in force
  Time until{0};                  ///< robot time at which it runs out; zero for that hold
  std::optional<Expiry> expired;  ///< a command ran out since the last call
};

struct GateCounters
{
  std::uint64_t accepted = 0;
  std::uint64_t expired = 0;  ///< times the robot was put on hold for want of a command
  std::uint64_t stalls = 0;   ///< of these, because the robot's clock stood still
  std::array<std::uint64_t, kRefusals> refused{};

  [[nodiscard]] std::uint64_t refused_for(Refusal reason) const
  {
    return refused[static_cast<std::size_t>(reason)];
  }
};

/// Who may command the robot, and for how long.
/**
 *   Free    --(valid command)--------------->  Leased    its issuer holds the lease
 *   Leased  --(valid command of the holder)->  Leased    the old command is replaced
 *   Leased  --(command of another)---------->  Leased    refused: kForeignIssuer
 *   Leased  --(valid_for is over)----------->  Free      hold
 *   Leased  --(robot's clock stalls)-------->  Free      hold
 *   any     --(emergency stop)-------------->  Stopped   hold; left only by reset_emergency_stop()
 *
 * A command expires `valid_for` after its stamp, or after its reception if that is earlier, so
 * that the robot stands at most `max_valid_for` after the last valid command was issued. The next
 * valid command heals. Pure: it reads no clock. One thread.
 *
 * While the emergency stop is latched, the hardware has a fault or was refused its power, nothing
 * acts, and yet it is listened to: an issuer in a fault asks to STOP, and to HOLD as soon as a
 * person has cleared the fault. A STOP and then a HOLD of the same instance, the button released,
 * ask for the reset.
 */
class CommandGate
{
public:
  /// \throws std::invalid_argument naming the limit, its value and what is accepted
  explicit CommandGate(const GateLimits & limits);

  /// Judges a command and lets it act if it is valid.
  Verdict offer(
    const CommandRequest & request, const GateClocks & clocks, const GateSituation & situation);

  /// What acts now. Call it each cycle: it is what makes commands expire.
  InForce in_force(const GateClocks & clocks);

  /// Drops what acts; the lease is free. Nothing is refused afterwards because of it.
  void drop();

  /// From here on everything is refused, until reset_emergency_stop().
  void latch_emergency_stop();
  void reset_emergency_stop();
  /// Somebody has asked for the reset; true once.
  [[nodiscard]] bool take_reset_request() { return std::exchange(reset_asked_, false); }
  [[nodiscard]] bool emergency_stop_latched() const { return emergency_stop_; }

  [[nodiscard]] const GateCounters & counters() const { return counters_; }

private:
  struct Issuer
  {
    std::string name;
    std::uint64_t instance = 0;
    std::uint64_t last_sequence = 0;
  };
  struct Lease
  {
    Expiry holder;
    JointCommand command{};
    Time deadline{0};         // on the robot's clock
    Time received_steady{0};  // on the steady one
  };

  [[nodiscard]] Verdict judge_content(const CommandRequest & request) const;
  [[nodiscard]] Verdict judge_stamp(const CommandRequest & request, Time now) const;
  [[nodiscard]] Verdict judge_issuer(const CommandRequest & request) const;
  [[nodiscard]] Verdict judge_situation(
    const JointCommand & motion, const GateSituation & situation) const;
  [[nodiscard]] const Issuer * find_issuer(const CommandRequest & request) const;
  void remember(const CommandRequest & request);
  void observe(const GateClocks & clocks);
  void listen_for_reset(const CommandRequest & request, const GateSituation & situation);

  GateLimits limits_;
  std::optional<Lease> lease_;
  std::optional<Expiry> expired_;
  std::deque<Issuer> issuers_;  ///< the last few, so that an old one cannot replay
  GateClocks last_advance_{};
  bool clock_seen_ = false;
  bool emergency_stop_ = false;
  std::deque<Expiry> stoppers_;  ///< who may ask for the reset next
  bool reset_asked_ = false;
  GateCounters counters_{};
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__COMMAND_GATE_HPP_
