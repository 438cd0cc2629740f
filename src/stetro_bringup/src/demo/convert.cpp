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
#include "convert.hpp"

#include <cmath>

#include "stetro_msgs/Innovation.hpp"

namespace stetro_bringup
{
namespace
{

namespace integrity = stetro_msgs::msg::StairPose_Constants;
namespace outcome = stetro_msgs::msg::Innovation_Constants;
namespace verdict = stetro_msgs::msg::ProfileCheck_Constants;

double heading_of(const geometry_msgs::msg::Quaternion & q)
{
  return std::atan2(
    2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

std::string verdict_name(std::uint8_t value)
{
  switch (value) {
    case verdict::VERDICT_AGREES:
      return "agrees";
    case verdict::VERDICT_CORRECTED:
      return "corrected";
    case verdict::VERDICT_AMBIGUOUS:
      return "ambiguous";
    default:
      return "no_verdict";
  }
}

}  // namespace

std::optional<StairSample> sample_of(
  const stetro_msgs::msg::StairPose & message, stetro_dds::Refusal & why)
{
  StairSample sample;
  sample.stamp = time_of(message.header().stamp());
  if (sample.stamp.count() <= 0) {
    why = {"zero stamp"};
    return std::nullopt;
  }
  const auto & pose = message.pose().pose();
  sample.segment = message.segment_id().c_str();
  sample.step = message.step_index();
  sample.x_m = pose.position().x();
  sample.y_m = pose.position().y();
  sample.z_m = pose.position().z();
  sample.heading_rad = heading_of(pose.orientation());
  sample.tread_x_m = message.tread_x();
  sample.tread_y_m = message.tread_y();
  for (const double value :
       {sample.x_m, sample.y_m, sample.z_m, sample.heading_rad, sample.tread_x_m,
        sample.tread_y_m}) {
    if (std::isinf(value)) {
      why = {"infinite"};
      return std::nullopt;
    }
  }
  return sample;
}

Estimate estimate_of(const stetro_msgs::msg::StairPose & message, const StairSample & sample)
{
  const auto & covariance = message.pose().covariance();
  const auto sigma = [&covariance](std::size_t axis) { return std::sqrt(covariance[axis * 7]); };
  Estimate estimate;
  estimate.sample = sample;
  estimate.sigma = {sigma(0), sigma(1), sigma(2), sigma(5)};
  estimate.integrity = integrity_name(message.integrity());
  estimate.reasons = message.reasons();
  estimate.block_heights_m = message.block_heights();
  return estimate;
}

StaircaseFound staircase_of(const diagnostic_msgs::msg::DiagnosticStatus & message)
{
  StaircaseFound staircase;
  for (const auto & pair : message.values()) {
    note(staircase, pair.key(), pair.value());
  }
  return staircase;
}

CheckSample check_of(const stetro_msgs::msg::ProfileCheck & message)
{
  CheckSample check;
  check.stamp = time_of(message.header().stamp());
  check.segment = message.segment_id().c_str();
  check.verdict = verdict_name(message.verdict());
  const auto & best = message.corrected_pose().pose();
  check.in_map = {
    best.position().x(), best.position().y(), best.position().z(), heading_of(best.orientation())};
  return check;
}

std::string integrity_name(std::uint8_t value)
{
  switch (value) {
    case integrity::INTEGRITY_OK:
      return "OK";
    case integrity::INTEGRITY_DEGRADED:
      return "DEGRADED";
    case integrity::INTEGRITY_LOST:
      return "LOST";
    default:
      return "UNKNOWN";
  }
}

std::string outcome_name(std::uint8_t value)
{
  switch (value) {
    case outcome::OUTCOME_FUSED:
      return "fused";
    case outcome::OUTCOME_GATED:
      return "gated";
    case outcome::OUTCOME_STALE:
      return "stale";
    case outcome::OUTCOME_NOT_VISIBLE:
      return "not_visible";
    default:
      return "";
  }
}

}  // namespace stetro_bringup
