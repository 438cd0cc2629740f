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

#include "stetro_tests/operator.hpp"

#include <unistd.h>

#include <chrono>
#include <utility>

#include "stetro_dds/stamp.hpp"

namespace stetro_tests
{

namespace kind = stetro_msgs::msg::MissionRequest_Constants;
namespace answer = stetro_msgs::msg::MissionStatus_Constants;

namespace
{

builtin_interfaces::msg::Time system_stamp()
{
  return stetro_dds::stamp_of(std::chrono::system_clock::now().time_since_epoch());
}

}  // namespace

Operator::Operator(Observer & observer)
: requests_(observer.publisher<Request>("mission", stetro_dds::qos::kMission)),
  status_(observer.probe<Status>("mission_status", stetro_dds::qos::kLatched))
{
}

std::optional<Operator::Status> Operator::ask(
  std::uint8_t request_kind, std::chrono::nanoseconds limit)
{
  Request request;
  request.kind(request_kind);
  request.step(kind::STEP_UNKNOWN);
  if (request_kind == kind::KIND_CLEAN_FLIGHT) {
    request.segment_id("stairs");
  }
  return ask(std::move(request), limit);
}

std::optional<Operator::Status> Operator::ask(Request request, std::chrono::nanoseconds limit)
{
  request.request_id("request_" + std::to_string(getpid()) + "_" + std::to_string(++asked_));
  request.issuer("tests");
  const auto answers = [&](const Status & status) {
    return status.request_id() == request.request_id();
  };
  const Deadline deadline{limit};
  while (!deadline.passed()) {
    request.header().stamp(system_stamp());
    requests_.publish(request);
    if (auto status = status_.wait_for(answers, 500ms)) {
      return status;
    }
  }
  return std::nullopt;
}

std::string Operator::accepted(std::uint8_t request_kind, std::chrono::nanoseconds limit)
{
  const Deadline deadline{limit};
  std::string refusal = "no answer";
  while (!deadline.passed()) {
    const auto status = ask(request_kind, limit);
    if (status && status->answer() == answer::ANSWER_ACCEPTED) {
      return "";
    }
    if (status) {
      refusal = std::string("refused: ") + status->answer_reason().c_str();
      status_.wait_next(200ms);  // a node that has just started may not have heard the others yet
    }
  }
  return refusal;
}

std::string Operator::start_climb(std::chrono::nanoseconds limit)
{
  return accepted(kind::KIND_CLEAN_FLIGHT, limit);
}

std::string Operator::resume(std::chrono::nanoseconds limit)
{
  return accepted(kind::KIND_RESUME, limit);
}

}  // namespace stetro_tests
