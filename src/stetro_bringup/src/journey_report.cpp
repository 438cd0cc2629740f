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

#include "stetro_bringup/journey_report.hpp"

#include <cmath>

namespace stetro_bringup
{
namespace
{

using stetro_site::Pose;

constexpr double kCarried_m = 0.3;    // in one row; a robot drives a centimetre
constexpr double kAtRest_m_s = 0.01;  // slower is no motion
constexpr double kAtRest_rad_s = 0.02;
constexpr double kRight_m = 0.3;                  // of the truth
constexpr std::uint32_t kProfileDisagrees = 512;  // REASON_PROFILE_DISAGREES of StairPose

double distance_m(const Pose & a, const Pose & b)
{
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

double turn_rad(const Pose & from, const Pose & to)
{
  return stetro_site::wrap_angle(to.yaw_rad - from.yaw_rad);
}

double seconds(std::chrono::nanoseconds time)
{
  return std::chrono::duration<double>(time).count();
}

}  // namespace

SegmentFrames::SegmentFrames(const stetro_site::Site & site)
{
  for (const stetro_site::Flight & flight : site.flights()) {
    frames_.emplace(flight.id(), flight.T_map_flight());
  }
  for (const stetro_site::Floor & floor : site.floors()) {
    frames_.emplace(floor.id, stetro_site::FrameTransform(floor.pose_in_map));
  }
}

std::optional<Pose> SegmentFrames::in_map(const StairSample & sample) const
{
  const auto frame = frames_.find(sample.segment);
  for (const double value : {sample.x_m, sample.y_m, sample.z_m, sample.heading_rad}) {
    if (!std::isfinite(value)) {
      return std::nullopt;
    }
  }
  if (frame == frames_.end()) {
    return std::nullopt;
  }
  return frame->second.to_map(Pose{sample.x_m, sample.y_m, sample.z_m, sample.heading_rad});
}

void JourneyReport::add(const TraceRow & row)
{
  if (!row.truth) {
    return;
  }
  const std::optional<Pose> truth = frames_.in_map(*row.truth);
  if (!truth) {
    return;
  }
  const Moment now{row, frames_.in_map(row.estimate), *truth};
  if (!last_) {
    started_ = row.estimate.stamp;
  } else {
    look_for_kidnap(now);
    look_for_hand_over(now);
  }
  if (!kidnaps_.empty()) {
    follow_kidnap(now);
  }
  last_ = now;
}

double JourneyReport::since_start_s(const Moment & now) const
{
  return seconds(now.row.estimate.stamp - started_);
}

void JourneyReport::look_for_hand_over(const Moment & now)
{
  const std::string & from = last_->row.estimate.segment;
  const std::string & to = now.row.estimate.segment;
  const bool lost = last_->row.integrity == "LOST" || now.row.integrity == "LOST";
  if (from == to || lost || !last_->estimate || !now.estimate) {
    return;  // a pose that is found anew is handed over by nobody
  }
  const Pose & before = *last_->estimate;
  const double jump = std::hypot(
    now.estimate->x_m - before.x_m - (now.truth.x_m - last_->truth.x_m),
    now.estimate->y_m - before.y_m - (now.truth.y_m - last_->truth.y_m));
  const double turn =
    stetro_site::wrap_angle(turn_rad(before, *now.estimate) - turn_rad(last_->truth, now.truth));
  hand_overs_.push_back({from, to, since_start_s(now), jump, turn});
}

void JourneyReport::look_for_kidnap(const Moment & now)
{
  const double moved = distance_m(last_->truth, now.truth);
  if (moved > kCarried_m) {
    Kidnap kidnap;
    kidnap.segment = now.row.truth->segment;
    kidnap.time_s = since_start_s(now);
    kidnap.distance_m = moved;
    kidnap.turned_rad = turn_rad(last_->truth, now.truth);
    kidnap.from = last_->truth;
    kidnap.to = now.truth;
    kidnaps_.push_back(kidnap);
    moved_s_ = 0.0;
  }
}

void JourneyReport::follow_kidnap(const Moment & now)
{
  Kidnap & kidnap = kidnaps_.back();
  if (kidnap.relocalised_after_s) {
    return;
  }
  const bool ok = now.row.integrity == "OK";
  if (!kidnap.noticed_after_s) {
    const double dt = seconds(now.row.estimate.stamp - last_->row.estimate.stamp);
    const double moved = distance_m(last_->truth, now.truth);
    const bool moves =
      moved > kAtRest_m_s * dt || std::abs(turn_rad(last_->truth, now.truth)) > kAtRest_rad_s * dt;
    moved_s_ += moves && moved <= kCarried_m ? dt : 0.0;
    if (now.row.integrity == "LOST" || (now.row.reasons & kProfileDisagrees) != 0u) {
      kidnap.noticed_after_s = moved_s_;
      noticed_ = now.row.estimate.stamp;
    }
  } else if (ok && now.estimate && distance_m(*now.estimate, now.truth) < kRight_m) {
    kidnap.relocalised_after_s = seconds(now.row.estimate.stamp - noticed_);
  }
}

}  // namespace stetro_bringup
