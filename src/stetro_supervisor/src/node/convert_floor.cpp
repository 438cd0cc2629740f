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

#include "convert_floor.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "stetro_dds/stamp.hpp"
#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn_rad = 6.283185307179586;
constexpr double kLevel_rad2 = 1e-4;  // a floor is level, and the robot stands on it
constexpr double kHeight_m2 = 1e-4;
constexpr std::size_t kFewestBeams = 16;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

geometry_msgs::msg::Quaternion turned(double yaw_rad)
{
  geometry_msgs::msg::Quaternion q;
  q.z(std::sin(0.5 * yaw_rad));
  q.w(std::cos(0.5 * yaw_rad));
  return q;
}

stetro_site::Covariance spatial(const Eigen::Matrix3d & planar)
{
  stetro_site::Covariance all = stetro_site::Covariance::Zero();
  stetro_site::set_planar(all, planar);
  all(2, 2) = kHeight_m2;
  all(3, 3) = all(4, 4) = kLevel_rad2;
  return all;
}

void fill(
  geometry_msgs::msg::PoseWithCovariance & message, const stetro_site::Pose & pose,
  const stetro_site::Covariance & covariance)
{
  message.pose().position().x(pose.x_m);
  message.pose().position().y(pose.y_m);
  message.pose().position().z(pose.z_m);
  message.pose().orientation(turned(pose.yaw_rad));
  for (int i = 0; i < 36; ++i) {
    message.covariance()[static_cast<std::size_t>(i)] = covariance(i / 6, i % 6);
  }
}

stetro_site::Pose pose_of(const FloorPlace & place)
{
  return {place.position_m.x(), place.position_m.y(), 0.0, place.yaw_rad};
}

void fill_unknown(geometry_msgs::msg::PoseWithCovariance & message)
{
  const double nan = kUnknown;
  fill(message, {nan, nan, nan, 0.0}, stetro_site::Covariance::Constant(nan));
}

void fill_on_map(
  geometry_msgs::msg::PoseWithCovariance & message, const std::optional<FloorPlace> & place,
  const stetro_site::Floor * floor)
{
  if (!place || floor == nullptr) {
    fill_unknown(message);
    return;
  }
  const stetro_site::FrameTransform T_map_floor{floor->pose_in_map};
  fill(
    message, T_map_floor.to_map(pose_of(*place)), T_map_floor.to_map(spatial(place->covariance)));
}

geometry_msgs::msg::Point on_map(
  const Eigen::Vector2d & point_m, bool known, const stetro_site::Floor * floor)
{
  geometry_msgs::msg::Point message;
  const double nan = kUnknown;
  Eigen::Vector3d at{nan, nan, nan};
  if (known && floor != nullptr) {
    at = stetro_site::FrameTransform{floor->pose_in_map}.to_map(
      Eigen::Vector3d{point_m.x(), point_m.y(), 0.0});
  }
  message.x(at.x());
  message.y(at.y());
  message.z(at.z());
  return message;
}

std::uint8_t wire_of(Verdict verdict)
{
  namespace wire = stetro_msgs::msg::ProfileCheck_Constants;
  switch (verdict) {
    case Verdict::kAgrees:
      return wire::VERDICT_AGREES;
    case Verdict::kCorrected:
      return wire::VERDICT_CORRECTED;
    case Verdict::kAmbiguous:
      return wire::VERDICT_AMBIGUOUS;
    case Verdict::kNoVerdict:
      return wire::VERDICT_NO_VERDICT;
  }
  return wire::VERDICT_UNKNOWN;
}

/// What is wrong with the scan as a whole, in words; empty if nothing.
std::string flaw_of(const sensor_msgs::msg::LaserScan & m)
{
  const double first = m.angle_min();
  const double last = m.angle_max();
  const double step = m.angle_increment();
  const std::size_t count = m.ranges().size();
  if (!std::isfinite(first + last + step) || step == 0.0) {
    return "angles not finite or no angle_increment";
  }
  if (count < kFewestBeams) {
    return std::to_string(count) + " ranges, accepted: " + std::to_string(kFewestBeams) +
           " or more";
  }
  const double beams = static_cast<double>(count);
  if (std::abs(step) * (beams - 1.0) > kTurn_rad * (1.0 + 1e-4)) {
    return std::to_string(count) + " ranges of angle_increment " + std::to_string(step) +
           ", accepted: a turn at most";
  }
  if (std::abs((last - first) / step + 1.0 - beams) > 1.5) {
    return "angle_min, angle_max and angle_increment do not make " + std::to_string(count) +
           " ranges";
  }
  const bool span = m.range_min() >= 0.0F && m.range_min() < m.range_max();
  if (!span || !std::isfinite(m.range_max())) {
    return "range_min " + std::to_string(m.range_min()) + ", range_max " +
           std::to_string(m.range_max()) + ", accepted: 0 <= range_min < range_max";
  }
  const double increment_s = m.time_increment();
  if (!(increment_s >= 0.0 && increment_s * beams < 10.0)) {
    return "time_increment " + std::to_string(increment_s) +
           ", accepted: 0 or more, a turn in 10 s";
  }
  return "";
}

}  // namespace

std::optional<Refusal> take(
  const sensor_msgs::msg::LaserScan & message, Time measured, std::shared_ptr<const Scan> & scan)
{
  if (const std::string flaw = flaw_of(message); !flaw.empty()) {
    return Refusal{"bad_scan", flaw};
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  auto taken = std::make_shared<Scan>();
  taken->time = measured;
  taken->profile.fan = {message.angle_min(), message.angle_increment(), message.ranges().size()};
  taken->profile.ranges_m.reserve(message.ranges().size());
  for (const float range : message.ranges()) {
    const bool too_near = range < message.range_min();
    const bool too_far = range > message.range_max();
    taken->profile.ranges_m.push_back(
      too_near  ? -kInfinity
      : too_far ? kInfinity
                : static_cast<double>(range));
  }
  taken->duration_s = message.time_increment() * static_cast<double>(message.ranges().size() - 1);
  scan = std::move(taken);
  return std::nullopt;
}

stetro_msgs::msg::ProfileCheck to_message(
  const CheckReport & report, const stetro_site::Floor * floor)
{
  const ProfileFinding & finding = report.testimony.finding;
  const bool compared = finding.expected && finding.measured;
  const double nan = kUnknown;
  stetro_msgs::msg::ProfileCheck message;
  message.header().stamp(stetro_dds::stamp_of(report.time));
  message.header().frame_id("map");
  message.segment_id(report.floor_id);
  fill_on_map(message.pose(), report.told, floor);
  message.expected_centroid(on_map(report.testimony.expected_centroid_m, compared, floor));
  message.measured_centroid(on_map(report.testimony.measured_centroid_m, compared, floor));
  message.expected_area(compared ? finding.expected->area_m2 : nan);
  message.measured_area(compared ? finding.measured->area_m2 : nan);
  message.valid_beam_share(finding.valid_share);
  message.iterations(static_cast<std::uint32_t>(finding.casts));
  fill_on_map(message.corrected_pose(), report.testimony.found, floor);
  message.residual(compared ? report.testimony.residual_m : nan);
  message.agreeing_beam_share(compared ? finding.best.beams.agreeing_share() : nan);
  message.verdict(wire_of(report.verdict));
  message.reason(report.reason.substr(0, 127));
  return message;
}

stetro_msgs::msg::PoseCorrection to_message(const Correction & correction, std::uint64_t sequence)
{
  stetro_msgs::msg::PoseCorrection message;
  message.header().stamp(stetro_dds::stamp_of(correction.time));
  message.header().frame_id(correction.place.floor_id);
  message.sequence_number(sequence);
  message.source(stetro_msgs::msg::PoseCorrection_Constants::SOURCE_PROFILE);
  message.segment_id(correction.place.floor_id);
  message.step_index(0);
  fill(message.pose(), pose_of(correction.place), spatial(correction.place.covariance));
  message.reset_counter(correction.resets);
  return message;
}

}  // namespace stetro_supervisor
