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

#include "benchmark/latency_path.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "benchmark/standing_robot.hpp"
#include "stetro_dds/qos.hpp"
#include "stetro_dds/stamp.hpp"

namespace bench
{

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""us;
using geometry_msgs::msg::PoseWithCovarianceStamped;
using stetro_msgs::msg::RangeArray;

namespace
{

std::chrono::nanoseconds system_now()
{
  return std::chrono::system_clock::now().time_since_epoch();
}

// What a pose answers is told by its stamp, in nanoseconds: ranges by an even one.
std::chrono::nanoseconds of_ranges(std::chrono::nanoseconds time)
{
  return time - time % std::chrono::nanoseconds{2};
}
std::chrono::nanoseconds of_others(std::chrono::nanoseconds time)
{
  return of_ranges(time) + std::chrono::nanoseconds{1};
}
bool is_of_ranges(std::chrono::nanoseconds stamp) { return of_ranges(stamp) == stamp; }

std::string in(const char * ns, const char * topic) { return std::string(ns) + "/" + topic; }

}  // namespace

/// The driver's topics in one namespace.
struct Source::Feed
{
  Feed(bare::Participant & participant, const char * ns)
  : ranges(participant, in(ns, "ranges"), stetro_dds::qos::kSensor),
    contacts(participant, in(ns, "contacts"), stetro_dds::qos::kContacts),
    blocks(participant, in(ns, "blocks"), stetro_dds::qos::kSensor),
    imu(participant, in(ns, "imu/data"), stetro_dds::qos::kSensor),
    odometry(participant, in(ns, "odom"), stetro_dds::qos::kSensor)
  {
  }

  bare::Writer<RangeArray> ranges;
  bare::Writer<stetro_msgs::msg::Contacts> contacts;
  bare::Writer<stetro_msgs::msg::BlockStates> blocks;
  bare::Writer<sensor_msgs::msg::Imu> imu;
  bare::Writer<nav_msgs::msg::Odometry> odometry;
};

struct Source::Stream
{
  std::chrono::steady_clock::time_point due;
  std::chrono::nanoseconds period;
  std::function<void()> write;
};

Source::Source(std::uint32_t domain_id)
: participant_(domain_id),
  robot_(std::make_unique<Feed>(participant_, kRobot)),
  bare_(std::make_unique<Feed>(participant_, kBare))
{
}

Source::~Source()
{
  stopped_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

bool Source::matched() const { return robot_->ranges.matched() > 0 && bare_->ranges.matched() > 0; }

void Source::start()
{
  thread_ = std::thread([this] { run(); });
}

std::vector<Source::Stream> Source::streams() const
{
  std::vector<Stream> result;
  auto start = std::chrono::steady_clock::now();
  for (Feed * feed : {robot_.get(), bare_.get()}) {
    using namespace standing;  // NOLINT(build/namespaces): one function per message
    result.push_back(
      {start, 10ms, [feed] { feed->odometry.write(odometry(of_others(system_now()))); }});
    result.push_back(
      {start + 1ms, 10ms, [feed] { feed->imu.write(imu(of_others(system_now()))); }});
    result.push_back(
      {start + 2ms, 33333us, [feed] { feed->blocks.write(blocks(of_others(system_now()))); }});
    result.push_back(
      {start + 3ms, 100ms, [feed] { feed->contacts.write(contacts(of_others(system_now()))); }});
    result.push_back(
      {start + 4ms, 33333us, [feed] { feed->ranges.write(ranges(of_ranges(system_now()))); }});
    start += 15ms;
  }
  return result;
}

void Source::run()
{
  std::vector<Stream> all = streams();
  const auto earlier = [](const Stream & a, const Stream & b) { return a.due < b.due; };
  while (!stopped_) {
    Stream & next = *std::min_element(all.begin(), all.end(), earlier);
    std::this_thread::sleep_until(next.due);
    next.write();
    next.due += next.period;
  }
}

Relay::Relay(std::uint32_t domain_id)
: participant_(domain_id), pose_(participant_, in(kBare, "pose"), stetro_dds::qos::kPose)
{
  message_.header().frame_id("map");
  // The readers of the localizer in its order: a round takes what carries the ranges before them.
  using stetro_dds::qos::kSensor;
  const auto ignore = [](const auto &) {};
  const auto answer = [this](const auto & sample) {
    message_.header().stamp(sample.header().stamp());
    pose_.write(message_);
  };
  dispatch_.read<nav_msgs::msg::Odometry>(participant_, in(kBare, "odom"), kSensor, ignore);
  dispatch_.read<sensor_msgs::msg::Imu>(participant_, in(kBare, "imu/data"), kSensor, answer);
  dispatch_.read<stetro_msgs::msg::Contacts>(
    participant_, in(kBare, "contacts"), stetro_dds::qos::kContacts, ignore);
  dispatch_.read<stetro_msgs::msg::BlockStates>(participant_, in(kBare, "blocks"), kSensor, ignore);
  dispatch_.read<RangeArray>(participant_, in(kBare, "ranges"), kSensor, answer);
}

Sink::Sink(std::uint32_t domain_id) : participant_(domain_id)
{
  const auto record = [](LatencyRecord & latencies, std::atomic<std::size_t> & count) {
    return [&latencies, &count](const PoseWithCovarianceStamped & pose) {
      const auto stamp = stetro_dds::time_of(pose.header().stamp());
      const auto age = system_now() - stamp;
      if (is_of_ranges(stamp) && ++count > kWarmUp) {
        latencies.add(age);
      }
    };
  };
  dispatch_.read<PoseWithCovarianceStamped>(
    participant_, in(kRobot, "pose"), stetro_dds::qos::kPose, record(robot_, robot_count_));
  dispatch_.read<PoseWithCovarianceStamped>(
    participant_, in(kBare, "pose"), stetro_dds::qos::kPose, record(bare_, bare_count_));
}

}  // namespace bench
