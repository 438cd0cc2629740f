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

#include "floor_topics.hpp"

#include <algorithm>

namespace stetro_supervisor
{

namespace qos = stetro_dds::qos;

FloorTopics::FloorTopics(
  stetro_dds::Node & node, const stetro_site::Site & site, Time future_tolerance,
  std::shared_ptr<const Scan> & scan)
: node_(node),
  site_(site),
  stamps_(future_tolerance),
  check_(node.advertise<stetro_msgs::msg::ProfileCheck>("profile_check", qos::kLatched)),
  correction_(node.advertise<stetro_msgs::msg::PoseCorrection>("pose_correction", qos::kCorrection))
{
  node.subscribe<sensor_msgs::msg::LaserScan>(
    "scan", qos::kSensor,
    [this, &scan](
      const sensor_msgs::msg::LaserScan & message,
      const stetro_dds::Reception & reception) -> std::optional<Refusal> {
      const Time now = node_.clock().now();
      const Time stamp = stetro_dds::time_of(message.header().stamp());
      if (auto refusal = stamps_.judge(stamp, now, reception.writer)) {
        return refusal;
      }
      return take(message, std::min(now, stamp), scan);
    });
}

void FloorTopics::tell(const CheckReport & report)
{
  ++checks_;
  check_.publish(to_message(report, site_.find_floor(report.floor_id)));
  if (report.correction) {
    correction_.publish(to_message(*report.correction, ++corrections_));
  }
  const std::string verdict = name_of(report.verdict);
  if (verdict != last_ || report.searched) {
    node_.log().info(
      "profile{}: {}: {}", report.searched ? " of the whole floor" : "", verdict, report.reason);
  }
  last_ = verdict;
}

void FloorTopics::report(stetro_dds::DiagnosticReport & report) const
{
  report.value("profile checks", static_cast<std::int64_t>(checks_));
  report.value("pose corrections", static_cast<std::int64_t>(corrections_));
  report.value("last profile", last_);
}

}  // namespace stetro_supervisor
