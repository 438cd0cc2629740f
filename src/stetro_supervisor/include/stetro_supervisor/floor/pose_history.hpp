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

#ifndef STETRO_SUPERVISOR__FLOOR__POSE_HISTORY_HPP_
#define STETRO_SUPERVISOR__FLOOR__POSE_HISTORY_HPP_

#include <cstdint>
#include <deque>
#include <optional>

#include "stetro_supervisor/floor/floor_place.hpp"
#include "stetro_supervisor/time.hpp"

namespace stetro_supervisor
{

/// Where the localizer said the robot was, for the last seconds: a scan is older than the pose.
class PoseHistory
{
public:
  struct Told
  {
    Time time{0};
    FloorPlace place;
    std::uint32_t resets = 0;
  };

  /// Takes a pose. One of the same time is taken once; one from before, or after a jump of the
  /// estimate or onto another floor, starts anew.
  void take(const Told & told);

  void forget() { told_.clear(); }

  /// Between the poses before and after; at the last one if it is hardly older.
  /** \return nothing for times before the first, or well after the last */
  [[nodiscard]] std::optional<Told> at(Time time) const;

private:
  std::deque<Told> told_;
};

/// How fast the robot turns, from its odometry.
class TurnWatch
{
public:
  void take(Time time, double yaw_rad);

  /// The greatest yaw rate about a time, a tenth of a second to either side [rad/s].
  /** \return nothing where the odometry does not reach to */
  [[nodiscard]] std::optional<double> greatest_rate(Time time, double duration_s) const;

private:
  struct Heading
  {
    Time time;
    double yaw_rad;
  };
  std::deque<Heading> headings_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__POSE_HISTORY_HPP_
