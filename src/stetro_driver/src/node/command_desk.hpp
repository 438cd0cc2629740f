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

#ifndef NODE__COMMAND_DESK_HPP_
#define NODE__COMMAND_DESK_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "node/convert.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_driver/command_gate.hpp"
#include "stetro_driver/result.hpp"

namespace stetro_driver
{

/// Takes commands from the wire, and says on it what became of each.
class CommandDesk
{
public:
  CommandDesk(stetro_dds::Node & node, const GateLimits & limits);

  /// Judges a command. \return why it is refused, for the subscription to count
  std::optional<stetro_dds::Refusal> offer(
    const CommandRequest & request, const GateClocks & clocks, const GateSituation & situation);

  /// What acts now; says so when something ran out.
  InForce in_force(const GateClocks & clocks);

  /// Says once when what acts has reached what it asked for.
  void observe(const SensorFrame & frame);

  /// Says once when the hardware gave up on what acts.
  void give_up(const IoFault & fault, Time now);

  [[nodiscard]] CommandGate & gate() { return gate_; }
  [[nodiscard]] const CommandGate & gate() const { return gate_; }

private:
  /// Whose command acts, and what has been said of it.
  struct Current
  {
    Expiry who;
    JointCommand motion{};
    bool concluded = false;
  };
  void tell(
    const Expiry & who, std::uint8_t outcome, std::uint8_t reason, const std::string & detail,
    Time now);
  [[nodiscard]] std::uint8_t driver_state() const;

  stetro_dds::Node & node_;
  CommandGate gate_;
  const std::uint64_t driver_instance_;
  std::optional<Current> current_;
  stetro_dds::Publisher<stetro_msgs::msg::CommandStatus> & status_;
};

}  // namespace stetro_driver

#endif  // NODE__COMMAND_DESK_HPP_
