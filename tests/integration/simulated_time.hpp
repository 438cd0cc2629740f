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

#ifndef TESTS__INTEGRATION__SIMULATED_TIME_HPP_
#define TESTS__INTEGRATION__SIMULATED_TIME_HPP_

#include <chrono>
#include <iosfwd>
#include <string>

#include "stetro_tests/robot_run.hpp"

namespace stetro_tests
{

/// How long a wait for simulated time may take before the test gives up [real time].
constexpr auto kPatience = 60s;

/// The present simulated time, as the last truth has it.
std::chrono::nanoseconds now_simulated(const RobotRun & run);

/// Lets simulated time pass. \return whether it did
bool let_pass(RobotRun & run, std::chrono::nanoseconds duration);

/// A place in the climb.
struct Moment
{
  std::string state;  ///< of the supervisor
  int step;           ///< the tread block 2 stands on
};
std::ostream & operator<<(std::ostream & out, const Moment & moment);

/// Waits until the supervisor says that it is there.
/** \return what is wrong, or "" */
std::string wait_moment(RobotRun & run, const Moment & moment);

/// The truths from number `first` on whose stamp lies behind `from`.
Truths truths_after(const RobotRun & run, std::size_t first, std::chrono::nanoseconds from);

/// Stamp of the last command that was sent, or whose acceptance was told, whichever is later.
std::chrono::nanoseconds last_command(const RobotRun & run);

/// Every step the supervisor spoke of since its status number `first` against the truth's.
/** It may not yet know of the tread reached within the last 2 s, and never of one not reached.
 * \return the first contradiction, or "" */
std::string contradicted_step(const RobotRun & run, std::size_t first_truth);

}  // namespace stetro_tests

#endif  // TESTS__INTEGRATION__SIMULATED_TIME_HPP_
