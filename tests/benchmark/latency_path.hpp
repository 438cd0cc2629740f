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

#ifndef TESTS__BENCHMARK__LATENCY_PATH_HPP_
#define TESTS__BENCHMARK__LATENCY_PATH_HPP_

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "benchmark/bare_endpoints.hpp"
#include "benchmark/latency_record.hpp"
#include "stetro_msgs/PoseWithCovarianceStamped.hpp"
#include "stetro_msgs/RangeArray.hpp"

/// The two paths that are compared, sample by sample in turn: an array of ranges is written,
/// something answers it with a pose, a subscriber receives the pose. On one path that something is
/// the localizer, on the other a relay without robot code. All else is shared: what answers the
/// gyroscope is sent on both, too, and not counted.
namespace bench
{

constexpr const char * kRobot = "/stetro";  ///< namespace of the localizer's path
constexpr const char * kBare = "/bare";     ///< namespace of the relay's path

/// The driver's place: what a standing robot senses, in its order and at its rates, on both paths.
/** Everything on the bare path happens 15 ms after the same on the robot's path. */
class Source
{
public:
  explicit Source(std::uint32_t domain_id);
  ~Source();

  /// Whether the localizer and the relay both listen to the ranges.
  [[nodiscard]] bool matched() const;
  void start();

private:
  struct Feed;
  struct Stream;
  std::vector<Stream> streams() const;
  void run();

  bare::Participant participant_;
  std::unique_ptr<Feed> robot_;
  std::unique_ptr<Feed> bare_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

/// The localizer's place: answers ranges and gyroscope with a pose of the same stamp, no more.
class Relay
{
public:
  explicit Relay(std::uint32_t domain_id);
  void start() { dispatch_.start(); }

private:
  bare::Participant participant_;
  bare::Writer<geometry_msgs::msg::PoseWithCovarianceStamped> pose_;
  geometry_msgs::msg::PoseWithCovarianceStamped message_;
  bare::Dispatch dispatch_;
};

/// The subscriber: how old the stamp of each pose is, the moment its range sample was written.
class Sink
{
public:
  explicit Sink(std::uint32_t domain_id);
  void start() { dispatch_.start(); }
  void stop() { dispatch_.stop(); }

  /// Poses of both paths so far; any thread may ask.
  [[nodiscard]] std::size_t robot_count() const { return robot_count_; }
  [[nodiscard]] std::size_t bare_count() const { return bare_count_; }

  /// After `stop()`.
  [[nodiscard]] const LatencyRecord & robot() const { return robot_; }
  [[nodiscard]] const LatencyRecord & bare() const { return bare_; }

  /// The first samples of each path are not counted: caches, pools and threads warm up.
  static constexpr std::size_t kWarmUp = 60;

private:
  bare::Participant participant_;
  LatencyRecord robot_;
  LatencyRecord bare_;
  std::atomic<std::size_t> robot_count_{0};
  std::atomic<std::size_t> bare_count_{0};
  bare::Dispatch dispatch_;
};

}  // namespace bench

#endif  // TESTS__BENCHMARK__LATENCY_PATH_HPP_
