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
#include "stetro_supervisor/situation.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "stetro_supervisor/pose_reason.hpp"
#include "stetro_supervisor/robot_health.hpp"

namespace stetro_supervisor
{
namespace
{

bool closed(const Contact & contact)
{
  return contact.state == ContactState::kClosed && !contact.fault;
}

bool any_closed(const std::array<Contact, 3> & bumpers)
{
  return std::any_of(bumpers.begin(), bumpers.end(), closed);
}

}  // namespace

bool Situation::pose_sound() const { return pose_doubt().empty(); }

bool Situation::pose_usable() const
{
  const bool bearable = seen.pose && seen.pose->integrity == Integrity::kDegraded &&
                        (seen.pose->reasons & ~kBearableReasons) == 0u;
  return bearable ? unusable_because().empty() : pose_sound();
}

bool Situation::pose_lets_approach() const
{
  const bool far_off = pose_usable() && seen.pose->step == 0 &&
                       seen.pose->reasons == static_cast<std::uint32_t>(kNoFrontReference);
  return pose_sound() || far_off;
}

std::string Situation::pose_doubt() const
{
  const auto & pose = seen.pose;
  if (!older_than(pose, now, params.pose_silence_s) && pose->integrity != Integrity::kOk) {
    const bool degraded = pose->integrity == Integrity::kDegraded;
    const bool lost = pose->integrity == Integrity::kLost;
    return std::string("integrity is ") +
           (degraded ? "DEGRADED"
            : lost   ? "LOST"
                     : "UNKNOWN") +
           ": " + reasons_in_words(pose->reasons) + "; accepted: OK";
  }
  return unusable_because();
}

std::string Situation::unusable_because() const
{
  const auto & pose = seen.pose;
  if (older_than(pose, now, params.pose_silence_s)) {
    return "the localizer is silent";
  }
  if (!pose->on_flight || pose->segment_id != geometry.segment_id) {
    return "the pose is on '" + pose->segment_id + "', accepted: flight '" + geometry.segment_id +
           "'";
  }
  if (!std::isfinite(pose->heading_rad) || !std::isfinite(pose->y_m) || pose->step < 0) {
    return "step, y or heading is unknown";
  }
  return "";
}

bool Situation::pose_settled() const
{
  return pose_sound() && memory.pose_sound_since &&
         seconds_between(*memory.pose_sound_since, now) >= params.pose_settle_s;
}

double Situation::heading_rad() const { return pose_usable() ? seen.pose->heading_rad : 0.0; }

bool Situation::driver_silent() const
{
  return is_driver_silent(seen, now, params.driver_silence_s);
}

std::optional<double> Situation::range_m(Place place) const
{
  const RangeMedian & median = memory.medians[static_cast<std::size_t>(place)];
  if (seconds_between(median.time(), now) > params.driver_silence_s) {
    return std::nullopt;
  }
  return median.value_m();
}

std::optional<double> Situation::gap_m(Place place) const
{
  const auto range = range_m(place);
  return range ? std::optional<double>(*range - geometry.contact_reading(place)) : std::nullopt;
}

std::optional<double> Situation::front_gap_m() const
{
  std::optional<double> least;
  for (const Place place : {Place::kFrontLeft, Place::kFrontRight, Place::kStairFront}) {
    const auto gap = gap_m(place);
    if (gap && (!least || *gap < *least)) {
      least = gap;
    }
  }
  return least;
}

std::optional<double> Situation::front_pair_m() const
{
  const auto left = range_m(Place::kFrontLeft);
  const auto right = range_m(Place::kFrontRight);
  if (!left || !right || !std::isfinite(*left) || !std::isfinite(*right)) {
    return std::nullopt;
  }
  return (*left + *right) / 2.0 * std::cos(heading_rad());
}

std::optional<double> Situation::front_middle_m() const
{
  const auto middle = range_m(Place::kStairFront);
  if (!middle || !std::isfinite(*middle)) {
    return std::nullopt;
  }
  return *middle * std::cos(heading_rad());
}

bool Situation::stalled() const
{
  return memory.nearest_m < params.stall_zone_m &&
         seconds_between(memory.nearest_time, now) > params.stall_s;
}

bool Situation::in_doubt_and_still(Place place) const
{
  return memory.nearest_m <= geometry.contact_doubt_m(place, params) &&
         seconds_between(memory.nearest_time, now) > params.stall_s;
}

bool Situation::pushes(Place place) const
{
  return in_doubt_and_still(place) &&
         memory.path.along_m - memory.nearest_along_m >= params.stall_roll_m;
}

bool Situation::left_contact() const { return seen.contacts && any_closed(seen.contacts->left); }

bool Situation::right_contact() const { return seen.contacts && any_closed(seen.contacts->right); }

bool Situation::riser_left() const { return seen.contacts && closed(seen.contacts->riser_left); }

bool Situation::riser_right() const { return seen.contacts && closed(seen.contacts->riser_right); }

const Block & Situation::block(int number) const
{
  static const Block kUnknownBlock{};
  return seen.blocks ? seen.blocks->block.at(static_cast<std::size_t>(number - 1)) : kUnknownBlock;
}

double Situation::height_m(int number) const { return block(number).height_m; }

bool Situation::lifted(int number) const
{
  return block(number).at_upper_lock && !block(number).moving;
}

bool Situation::stands(int number) const
{
  const Block & b = block(number);
  const bool bears = std::isnan(b.load) || b.load >= params.touch_down_load;
  return seen.blocks && !b.moving && bears;
}

bool Situation::bears(int number) const
{
  return stands(number) && !std::isnan(block(number).load);
}

bool Situation::steering_at(double angle_rad) const
{
  return seen.blocks && !seen.blocks->steering_moving &&
         std::abs(seen.blocks->steering_rad - angle_rad) <= params.steering_tolerance_rad;
}

}  // namespace stetro_supervisor
