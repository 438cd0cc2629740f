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

#ifndef STETRO_TESTS__OPERATOR_HPP_
#define STETRO_TESTS__OPERATOR_HPP_

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "stetro_msgs/MissionRequest.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_tests/observer.hpp"

namespace stetro_tests
{

/// Someone who asks for missions and reads the answers.
class Operator
{
public:
  using Request = stetro_msgs::msg::MissionRequest;
  using Status = stetro_msgs::msg::MissionStatus;

  /// Opens the two topics; before the observer is started.
  explicit Operator(Observer & observer);

  /// Sends a request of this kind (MissionRequest_Constants) and waits for its answer.
  /** It is sent again until it is answered: the supervisor takes the same id twice as one.
   * \return the status that echoes the request; nothing if none came */
  std::optional<Status> ask(std::uint8_t kind, std::chrono::nanoseconds limit);

  /// The same with a request that has more to say; id, issuer and stamp are filled in.
  std::optional<Status> ask(Request request, std::chrono::nanoseconds limit);

  /// Asks for the flight `stairs` to be cleaned, again and again until it is accepted.
  /** \return why it was refused last; empty if it was accepted */
  std::string start_climb(std::chrono::nanoseconds limit);

  /// Goes on after a restart or a pause, asked likewise.
  std::string resume(std::chrono::nanoseconds limit);

  [[nodiscard]] Probe<Status> & status() const { return status_; }

private:
  std::string accepted(std::uint8_t kind, std::chrono::nanoseconds limit);

  stetro_dds::Publisher<Request> & requests_;
  Probe<Status> & status_;
  int asked_ = 0;
};

}  // namespace stetro_tests

#endif  // STETRO_TESTS__OPERATOR_HPP_
