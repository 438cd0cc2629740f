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

// A hand on the command line: moves one part of the robot and prints what became of it.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "CLI/CLI.hpp"
#include "person_at_terminal.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/instance_id.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"

namespace
{

namespace kind = stetro_msgs::msg::Command_Constants;
namespace status = stetro_msgs::msg::CommandStatus_Constants;
namespace qos = stetro_dds::qos;
using std::chrono_literals::operator""ms;
using Clock = std::chrono::steady_clock;
using stetro_bringup::kDone;
using stetro_bringup::kRefused;
using stetro_bringup::no_answer;
using stetro_msgs::msg::Command;
using stetro_msgs::msg::CommandStatus;

constexpr auto kRenewal = 50ms;
constexpr std::chrono::nanoseconds kValidFor = 200ms;  // what the driver takes at most
constexpr double kLetGo_s = 2.0;
constexpr double kDegree = M_PI / 180.0;

struct Motion
{
  std::string what;
  double vx_m_s = 0.0;
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;
  double seconds = 1.0;
  double angle_deg = 0.0;
  int block = 0;
  double patience_s = 10.0;

  [[nodiscard]] bool lasts() const { return what == "roll"; }
};

const std::map<std::string, std::uint8_t> kKinds = {
  {"roll", kind::KIND_TWIST},
  {"steer", kind::KIND_STEER},
  {"lift", kind::KIND_LIFT},
  {"lower", kind::KIND_LOWER}};

/// A hand on the robot: commands, renewed as long as they are to act, and what became of them.
class Hand
{
public:
  Hand(stetro_dds::Context & context, const stetro_dds::NodeOptions & options)
  : node_(context, options),
    commands_(node_.advertise<Command>("command", qos::kCommand)),
    instance_(stetro_dds::draw_instance_id())
  {
    node_.subscribe<CommandStatus>(
      "command_status", qos::kCommandStatus, [this](const CommandStatus & heard) {
        if (heard.issuer_instance() == instance_) {
          heard_ = heard;
        }
      });
  }

  stetro_dds::Node & node() { return node_; }
  [[nodiscard]] bool reaches_a_driver() const
  {
    return commands_.matched() > 0 && node_.clock().known();
  }
  [[nodiscard]] const std::optional<CommandStatus> & heard() const { return heard_; }

  void send(Command command)
  {
    sent_ = node_.clock().now();
    command.header().stamp() = stetro_dds::stamp_of(sent_);
    command.header().frame_id() = "base_link";
    command.issuer() = "stetro_jog";
    command.issuer_instance() = instance_;
    command.sequence_number() = ++sequence_;
    command.valid_for().nanosec() = static_cast<std::uint32_t>(kValidFor.count());
    commands_.publish(command);
  }

  /// The driver takes commands of nobody else as long as the last one of ours is good.
  [[nodiscard]] bool has_let_go() const { return node_.clock().now() > sent_ + kValidFor; }

private:
  stetro_dds::Node node_;
  stetro_dds::Publisher<Command> & commands_;
  const std::uint64_t instance_;
  std::chrono::nanoseconds sent_{0};
  std::uint64_t sequence_ = 0;
  std::optional<CommandStatus> heard_{};
};

Command command_of(std::uint8_t kind)
{
  Command command;
  command.kind() = kind;
  return command;
}

Command command_of(const Motion & motion)
{
  Command command = command_of(kKinds.at(motion.what));
  command.vx() = motion.vx_m_s;
  command.vy() = motion.vy_m_s;
  command.wz() = motion.wz_rad_s;
  command.block() = static_cast<std::uint8_t>(motion.block);
  command.steering_angle() = motion.angle_deg * kDegree;
  return command;
}

int refused(const std::string & what, const CommandStatus & told)
{
  std::cout << what << " refused: " << told.detail().c_str() << std::endl;
  return kRefused;
}

struct Loop
{
  stetro_dds::Executor & executor;
  const stetro_dds::Launch & launch;  // knows when a signal wants an end
};

/// Spins until `ready` or until patience ends. \return whether it is ready
bool wait(const Loop & loop, double patience_s, const std::function<bool()> & ready)
{
  const auto patience = std::chrono::duration<double>(patience_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  bool is_ready = ready();
  while (!is_ready && Clock::now() < deadline && !loop.launch.stop_requested()) {
    loop.executor.spin_some(5ms);
    is_ready = ready();
  }
  return is_ready;
}

/// Spins with a command renewed until `over`, or until the span ends. \return whether it is over
bool renew(
  const Command & command, double span_s, Hand & hand, const Loop & loop,
  const std::function<bool()> & over)
{
  Clock::time_point renewed{};
  return wait(loop, span_s, [&] {
    if (Clock::now() - renewed >= kRenewal) {
      renewed = Clock::now();
      hand.send(command);
    }
    return over();
  });
}

/// A STOP and then a HOLD ask the driver for the reset. Neither moves anything.
int reset(const Motion & motion, Hand & hand, const Loop & loop)
{
  hand.send(command_of(kind::KIND_STOP));
  const bool heard = wait(loop, motion.patience_s, [&hand] { return hand.heard().has_value(); });
  if (!heard) {
    return no_answer("driver", motion.patience_s);
  }
  const bool accepted = renew(command_of(kind::KIND_HOLD), motion.patience_s, hand, loop, [&hand] {
    const CommandStatus & told = *hand.heard();
    return told.sequence_number() > 1 && told.outcome() == status::OUTCOME_ACCEPTED;
  });
  if (!accepted) {
    return refused(motion.what, *hand.heard());
  }
  std::cout << "reset: the driver takes commands" << std::endl;
  return kDone;
}

/// What came too late or was renewed too late goes on with the next one: the computer was busy.
bool is_over(const CommandStatus & told)
{
  const bool too_late = told.reason() == status::REASON_BAD_STAMP;
  return told.outcome() == status::OUTCOME_DONE ||
         (told.outcome() == status::OUTCOME_REFUSED && !too_late);
}

int move(const Motion & motion, Hand & hand, const Loop & loop)
{
  const double span_s = motion.lasts() ? motion.seconds : motion.patience_s;
  renew(command_of(motion), span_s, hand, loop, [&hand] {
    return hand.heard() && is_over(*hand.heard());
  });
  hand.send(command_of(kind::KIND_STOP));
  if (!hand.heard()) {
    return no_answer("driver", motion.patience_s);
  }
  if (hand.heard()->outcome() == status::OUTCOME_REFUSED) {
    return refused(motion.what, *hand.heard());
  }
  const bool done = motion.lasts() || hand.heard()->outcome() == status::OUTCOME_DONE;
  std::cout << motion.what << (done ? " done" : " not finished, stopped") << std::endl;
  return done ? kDone : kRefused;
}

int carry_out(const Motion & motion, Hand & hand, const Loop & loop)
{
  if (!wait(loop, motion.patience_s, [&hand] { return hand.reaches_a_driver(); })) {
    return no_answer("driver", motion.patience_s);
  }
  const int outcome = motion.what == "reset" ? reset(motion, hand, loop) : move(motion, hand, loop);
  wait(loop, kLetGo_s, [&hand] { return hand.has_let_go(); });  // for whoever commands next
  return outcome;
}

}  // namespace

int main(int argc, char ** argv)
{
  Motion motion;
  const auto options = [&motion](CLI::App & app) {
    std::set<std::string> words{"reset"};
    for (const auto & [word, value] : kKinds) {
      words.insert(word);
    }
    app.add_option("motion", motion.what, "what to do")->required()->check(CLI::IsMember(words));
    app.add_option("--vx", motion.vx_m_s, "of roll, forward [m/s]; wants the steering at 0");
    app.add_option("--vy", motion.vy_m_s, "of roll, to the left [m/s]; wants the steering at 90");
    app.add_option("--wz", motion.wz_rad_s, "of roll, to the left [rad/s]; steering at 90");
    app.add_option("--seconds", motion.seconds, "how long to roll [s]")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
    app.add_option("--angle", motion.angle_deg, "of steer: 0 rolls forward, 90 to the left [deg]")
      ->check(CLI::Range(0.0, 90.0));
    app.add_option("--block", motion.block, "of lift and lower: 1 front, 2 middle, 3 rear")
      ->check(CLI::Range(1, 3));
    app.add_option("--patience", motion.patience_s, "how long to wait, for lifts too [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
    app.footer(
      "reset clears what servos have latched, what jammed and the emergency stop, and powers the\n"
      "motors again. The robot stops when this program does.\n"
      "Exit status: 0 done, 1 refused or not finished (the reason is printed), 3 nobody answered.");
  };
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_jog", "Moves one part of the robot, by hand, without the supervisor.", options},
    [&motion](stetro_dds::Launch & launch) {
      return stetro_bringup::with_person<Hand>(
        launch, "hand", [&](Hand & hand, stetro_dds::Executor & executor) {
          return carry_out(motion, hand, {executor, launch});
        });
    });
}
