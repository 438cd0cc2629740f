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

#ifndef STETRO_DDS__DIAGNOSTICS_HPP_
#define STETRO_DDS__DIAGNOSTICS_HPP_

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stetro_dds
{

class Node;

/// The levels of diagnostic_msgs/DiagnosticStatus.
enum class Health : std::uint8_t { kOk = 0, kWarn = 1, kError = 2, kStale = 3 };

/// One task's answer to "how are you?".
class DiagnosticReport
{
public:
  /// Sets level and message; of several calls the worst level wins, and the first of its kind.
  void summarise(Health health, std::string message);
  void value(std::string key, std::string value);
  void value(std::string key, std::int64_t value);
  void value(std::string key, std::uint64_t value);
  void value(std::string key, double value);

  [[nodiscard]] Health health() const { return health_; }
  [[nodiscard]] const std::string & message() const { return message_; }
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>> & values() const
  {
    return values_;
  }

private:
  Health health_ = Health::kOk;
  std::string message_ = "OK";
  std::vector<std::pair<std::string, std::string>> values_;
};

/// A node's entries in `/diagnostics`: one status "node: task" per task, sent every second.
/**
 * Three tasks report for every node without being asked: "lifecycle", "clock" and "topics", which
 * has per topic the peers matched, what was received, refused for which reason, malformed, lost or
 * not sent, and the peers that cannot match and why.
 */
class Diagnostics
{
public:
  using Task = std::function<void(DiagnosticReport &)>;

  Diagnostics(Node & node, std::string hardware_id);
  ~Diagnostics();
  Diagnostics(const Diagnostics &) = delete;
  Diagnostics & operator=(const Diagnostics &) = delete;

  /// \throws std::invalid_argument if the node has a task of that name
  void add(std::string task, Task report);

  /// Asks every task and sends the answers, now; the node does it each second of steady time.
  void publish();

  /// What the tasks say now, by name and in order.
  [[nodiscard]] std::vector<std::pair<std::string, DiagnosticReport>> reports() const;

private:
  struct Wire;
  Node & node_;
  std::string hardware_id_;
  std::vector<std::pair<std::string, Task>> tasks_;
  std::unique_ptr<Wire> wire_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__DIAGNOSTICS_HPP_
