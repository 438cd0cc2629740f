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

#ifndef STETRO_TESTS__ROBOT_RUN_HPP_
#define STETRO_TESTS__ROBOT_RUN_HPP_

#include <chrono>
#include <string>

#include "stetro_msgs/Command.hpp"
#include "stetro_msgs/CommandStatus.hpp"
#include "stetro_msgs/DiagnosticArray.hpp"
#include "stetro_msgs/StairPose.hpp"
#include "stetro_tests/observer.hpp"
#include "stetro_tests/operator.hpp"
#include "stetro_tests/stack.hpp"
#include "stetro_tests/truth.hpp"

namespace stetro_tests
{

/// The three processes on a domain of their own, an operator, and ears on what matters.
class RobotRun
{
public:
  explicit RobotRun(const StackOptions & options = {});

  /// Waits until the localizer is sure and the supervisor speaks. \return what is missing, or ""
  std::string wait_ready();

  /// Ready, and the climb accepted. \return what went wrong, or ""
  std::string start_climb();

  LoopbackDomain domain;
  Observer observer{domain};
  Operator operators{observer};
  Probe<Truth> & truth;
  Probe<stetro_msgs::msg::StairPose> & pose;
  Probe<stetro_msgs::msg::Command> & commands;
  Probe<stetro_msgs::msg::CommandStatus> & command_status;
  Probe<diagnostic_msgs::msg::DiagnosticArray> & diagnostics;
  Stack stack;
};

}  // namespace stetro_tests

#endif  // STETRO_TESTS__ROBOT_RUN_HPP_
