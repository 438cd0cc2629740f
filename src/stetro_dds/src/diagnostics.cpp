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

#include "stetro_dds/diagnostics.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stetro_dds/node.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/DiagnosticArray.hpp"

namespace stetro_dds
{

namespace msg = diagnostic_msgs::msg;

void DiagnosticReport::summarise(Health health, std::string message)
{
  if (health > health_) {
    health_ = health;
    message_ = std::move(message);
  }
}

void DiagnosticReport::value(std::string key, std::string value)
{
  values_.emplace_back(std::move(key), std::move(value));
}

void DiagnosticReport::value(std::string key, std::int64_t number)
{
  value(std::move(key), std::to_string(number));
}

void DiagnosticReport::value(std::string key, std::uint64_t number)
{
  value(std::move(key), std::to_string(number));
}

void DiagnosticReport::value(std::string key, double number)
{
  value(std::move(key), std::to_string(number));
}

struct Diagnostics::Wire
{
  Publisher<msg::DiagnosticArray> & publisher;
};

Diagnostics::Diagnostics(Node & node, std::string hardware_id)
: node_(node),
  hardware_id_(std::move(hardware_id)),
  wire_(new Wire{node.advertise<msg::DiagnosticArray>("/diagnostics", qos::kDiagnostics)})
{
}

Diagnostics::~Diagnostics() = default;

void Diagnostics::add(std::string task, Task report)
{
  const auto same = [&](const auto & known) { return known.first == task; };
  if (std::any_of(tasks_.begin(), tasks_.end(), same)) {
    throw std::invalid_argument("diagnostic task '" + task + "': accepted is a new name");
  }
  tasks_.emplace_back(std::move(task), std::move(report));
}

std::vector<std::pair<std::string, DiagnosticReport>> Diagnostics::reports() const
{
  std::vector<std::pair<std::string, DiagnosticReport>> reports;
  for (const auto & [name, task] : tasks_) {
    DiagnosticReport report;
    task(report);
    reports.emplace_back(name, std::move(report));
  }
  return reports;
}

void Diagnostics::publish()
{
  msg::DiagnosticArray message;
  message.header().stamp(stamp_of(node_.clock().now()));
  for (const auto & [name, report] : reports()) {
    msg::DiagnosticStatus status;
    status.level(static_cast<std::uint8_t>(report.health()));
    status.name(node_.name().name + ": " + name);
    status.message(report.message());
    status.hardware_id(hardware_id_);
    for (const auto & [key, value] : report.values()) {
      msg::KeyValue pair;
      pair.key(key);
      pair.value(value);
      status.values().push_back(pair);
    }
    message.status().push_back(status);
  }
  wire_->publisher.publish(message);
}

}  // namespace stetro_dds
