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

#ifndef STETRO_DRIVER__COMMISSIONING_HPP_
#define STETRO_DRIVER__COMMISSIONING_HPP_

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "stetro_driver/hardware_interface.hpp"

namespace stetro_driver
{

enum class CheckOutcome { kPassed, kFailed, kSkipped };

/// One line of the table.
struct CheckRow
{
  std::string item;
  CheckOutcome outcome = CheckOutcome::kSkipped;
  std::string found;   ///< what was read, or what happened
  std::string advice;  ///< what to do about it; empty when nothing
};

/// The person beside the robot.
class Assistant
{
public:
  Assistant() = default;
  virtual ~Assistant() = default;
  Assistant(const Assistant &) = delete;
  Assistant & operator=(const Assistant &) = delete;

  /// Asks for a hand, a push or a turn. \return false: this one is to be skipped
  virtual bool ask(const std::string & item, const std::string & request) = 0;
  /// It was seen, or patience has ended: whatever was begun may end.
  virtual void thank(const std::string & item) = 0;
};

/// A person at a terminal: Enter goes on, `s` skips one.
class TerminalAssistant : public Assistant
{
public:
  /// \param in null: nobody presses Enter, and nothing is waited for
  TerminalAssistant(std::istream * in, std::ostream & out) : in_(in), out_(out) {}
  bool ask(const std::string & item, const std::string & request) override;
  void thank(const std::string & item) override;

private:
  std::istream * in_;
  std::ostream & out_;
};

/// Checks a robot that has just been wired: finds each device, reads it once, verifies the signs.
/**
 * Motors stay without power. That a sensor is where the robot file says, a switch is the one it is
 * called, and a turn to the left is counted to the left, only a person can show: a hand before each
 * range sensor, a push of each switch, a small turn of the robot.
 */
class Commissioning
{
public:
  /// \param clock time for the robot's read()
  /// \param person null: the signs are skipped
  Commissioning(HardwareInterface & robot, std::function<Time()> clock, Assistant * person);

  [[nodiscard]] std::vector<CheckRow> run();

private:
  bool find();
  void read_once();
  void check_hands();
  void check_pushes();
  void check_turn();
  void check_hand(RangePlace place);
  void check_push(ContactPlace place);
  /// Reads until `seen(frame)` says something. \return what it said; empty: patience has ended
  [[nodiscard]] std::string watch(const std::function<std::string(const SensorFrame &)> & seen);
  [[nodiscard]] SensorFrame read();
  void add(std::string item, CheckOutcome outcome, std::string found, std::string advice = "");

  HardwareInterface & robot_;
  const std::function<Time()> clock_;
  Assistant * const person_;
  std::vector<CheckRow> rows_{};
};

/// The table as text, and below it how many of each.
void print_check(std::ostream & out, const std::vector<CheckRow> & rows);

/// Whether nothing has failed.
[[nodiscard]] bool all_well(const std::vector<CheckRow> & rows);

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__COMMISSIONING_HPP_
