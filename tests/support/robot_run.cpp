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

#include "stetro_tests/robot_run.hpp"

namespace stetro_tests
{

namespace
{

constexpr auto kStartUp = 20s;

bool sure(const stetro_msgs::msg::StairPose & pose)
{
  return pose.integrity() == stetro_msgs::msg::StairPose_Constants::INTEGRITY_OK;
}

}  // namespace

RobotRun::RobotRun(const StackOptions & options)
: truth(observer.probe<Truth>("ground_truth", stetro_dds::qos::kSensor)),
  pose(observer.probe<stetro_msgs::msg::StairPose>("stair_pose", stetro_dds::qos::kLatched)),
  commands(observer.probe<stetro_msgs::msg::Command>("command", stetro_dds::qos::kCommand)),
  command_status(observer.probe<stetro_msgs::msg::CommandStatus>(
    "command_status", stetro_dds::qos::kCommandStatus)),
  diagnostics(observer.probe<diagnostic_msgs::msg::DiagnosticArray>(
    "/diagnostics", stetro_dds::qos::kDiagnostics)),
  stack(domain, options)
{
  observer.start();
}

std::string RobotRun::wait_ready()
{
  if (!truth.wait_next(kStartUp)) {
    return "no ground truth came\n" + stack.tails();
  }
  if (!operators.status().wait_next(kStartUp)) {
    return "no mission status came\n" + stack.tails();
  }
  if (!pose.wait_for(sure, kStartUp)) {
    return "the localizer is not sure\n" + stack.tails();
  }
  return "";
}

std::string RobotRun::start_climb()
{
  if (auto missing = wait_ready(); !missing.empty()) {
    return missing;
  }
  if (const auto refusal = operators.start_climb(kStartUp); !refusal.empty()) {
    return "the climb was not accepted: " + refusal + "\n" + stack.tails();
  }
  return "";
}

}  // namespace stetro_tests
