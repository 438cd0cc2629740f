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

#include "stetro_supervisor/floor/pose_history.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kKept_s = 3.0;
constexpr double kJustAfter_s = 0.02;  // a pose that much older than the scan is of its time
constexpr double kMargin_s = 0.1;

using stetro_site::wrap_angle;

}  // namespace

void PoseHistory::take(const Told & told)
{
  if (!told_.empty()) {
    const Told & last = told_.back();
    if (told.time == last.time) {
      return;
    }
    const bool goes_on = told.time > last.time && told.resets == last.resets &&
                         told.place.floor_id == last.place.floor_id;
    if (!goes_on) {
      told_.clear();
    }
  }
  told_.push_back(told);
  while (seconds_between(told_.front().time, told.time) > kKept_s) {
    told_.pop_front();
  }
}

std::optional<PoseHistory::Told> PoseHistory::at(Time time) const
{
  const auto after = std::find_if(
    told_.begin(), told_.end(), [time](const Told & told) { return told.time >= time; });
  if (after == told_.end()) {
    const bool just = !told_.empty() && seconds_between(told_.back().time, time) <= kJustAfter_s;
    return just ? std::optional<Told>{told_.back()} : std::nullopt;
  }
  if (after->time == time) {
    return *after;
  }
  if (after == told_.begin()) {
    return std::nullopt;
  }
  const Told & before = *std::prev(after);
  const double share =
    seconds_between(before.time, time) / seconds_between(before.time, after->time);
  Told between = *after;
  between.time = time;
  between.place.position_m += (1.0 - share) * (before.place.position_m - after->place.position_m);
  between.place.yaw_rad = wrap_angle(
    before.place.yaw_rad + share * wrap_angle(after->place.yaw_rad - before.place.yaw_rad));
  return between;
}

void TurnWatch::take(Time time, double yaw_rad)
{
  if (!headings_.empty() && time <= headings_.back().time) {
    if (time == headings_.back().time) {
      return;
    }
    headings_.clear();
  }
  headings_.push_back({time, yaw_rad});
  while (seconds_between(headings_.front().time, time) > kKept_s) {
    headings_.pop_front();
  }
}

std::optional<double> TurnWatch::greatest_rate(Time time, double duration_s) const
{
  const bool reaches = !headings_.empty() && headings_.front().time <= time &&
                       seconds_between(time, headings_.back().time) >= duration_s - kJustAfter_s;
  if (!reaches) {
    return std::nullopt;
  }
  double greatest = 0.0;
  for (std::size_t i = 1; i < headings_.size(); ++i) {
    const bool before = seconds_between(headings_[i].time, time) > kMargin_s;
    const bool after = seconds_between(time, headings_[i - 1].time) > duration_s + kMargin_s;
    if (!before && !after) {
      const double dt_s = seconds_between(headings_[i - 1].time, headings_[i].time);
      const double turn = wrap_angle(headings_[i].yaw_rad - headings_[i - 1].yaw_rad);
      greatest = std::max(greatest, std::abs(turn) / dt_s);
    }
  }
  return greatest;
}

}  // namespace stetro_supervisor
