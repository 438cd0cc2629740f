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

#include "integration/simulated_time.hpp"

#include <algorithm>
#include <sstream>

#include "stetro_msgs/CommandStatus.hpp"

namespace stetro_tests
{

using std::chrono::nanoseconds;

nanoseconds now_simulated(const RobotRun & run)
{
  const auto last = run.truth.last();
  return last ? time_of(*last) : nanoseconds{0};
}

bool let_pass(RobotRun & run, nanoseconds duration)
{
  const nanoseconds until = now_simulated(run) + duration;
  return poll_until([&] { return now_simulated(run) >= until; }, kPatience);
}

std::ostream & operator<<(std::ostream & out, const Moment & moment)
{
  return out << moment.state << "_on_step_" << moment.step;
}

std::string wait_moment(RobotRun & run, const Moment & moment)
{
  const auto there = [&](const Operator::Status & status) {
    return moment.state == status.state().c_str() && status.step() == moment.step;
  };
  const auto trouble = [](const Operator::Status & status) {
    return status.mission() == stetro_msgs::msg::MissionStatus_Constants::MISSION_FAULT;
  };
  const auto found = run.operators.status().wait_for(
    [&](const Operator::Status & status) { return there(status) || trouble(status); }, kPatience);
  if (found && there(*found)) {
    return "";
  }
  std::ostringstream text;
  text << moment << " was not reached; the supervisor said last: ";
  if (const auto last = run.operators.status().last()) {
    text << last->state() << " on step " << last->step() << ", fault '" << last->fault() << "' "
         << last->fault_detail();
  } else {
    text << "nothing";
  }
  text << "\n" << run.stack.tails();
  return text.str();
}

Truths truths_after(const RobotRun & run, std::size_t first, nanoseconds from)
{
  Truths truths = run.truth.samples(first);
  truths.erase(truths.begin(), std::find_if(truths.begin(), truths.end(), [&](const auto & t) {
                 return time_of(t.message) >= from;
               }));
  return truths;
}

nanoseconds last_command(const RobotRun & run)
{
  namespace outcome = stetro_msgs::msg::CommandStatus_Constants;
  nanoseconds result{0};
  if (const auto command = run.commands.last()) {
    result = time_of(*command);
  }
  for (const auto & status : run.command_status.samples()) {
    if (status.message.outcome() == outcome::OUTCOME_ACCEPTED) {
      result = std::max(result, time_of(status.message));
    }
  }
  return result;
}

std::string contradicted_step(const RobotRun & run, std::size_t first_truth)
{
  const Truths truths = run.truth.samples(first_truth);
  for (const auto & status : run.operators.status().samples()) {
    const auto later = std::find_if(truths.begin(), truths.end(), [&](const auto & truth) {
      return truth.steady >= status.steady;
    });
    if (later == truths.begin() || later == truths.end() || status.message.step() < 0) {
      continue;
    }
    const int at_most = later->message.step_index();
    const auto before = std::find_if(truths.begin(), later, [&](const auto & truth) {
      return time_of(truth.message) >= time_of(later->message) - 2s;
    });
    const int at_least = before->message.step_index();
    if (status.message.step() < at_least || status.message.step() > at_most) {
      return "the supervisor says step " + std::to_string(status.message.step()) + " in state " +
             status.message.state().c_str() + ", truth is " + to_string(later->message);
    }
  }
  return "";
}

}  // namespace stetro_tests
