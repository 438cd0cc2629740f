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

#include "stetro_localizer/floor/passage.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{
namespace
{

constexpr double kLevel = 0.01;  // undersides that stand on one floor differ by less [m]

/// The largest standard deviation of the position in any direction [m].
double position_sigma_m(const stetro_site::Covariance & covariance)
{
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(mean + std::hypot(half, covariance(0, 1)));
}

bool level_and_at_rest(const BlockSample & sample)
{
  return sample.stamp != Nanoseconds{0} &&
         std::all_of(sample.blocks.begin(), sample.blocks.end(), [](const BlockReading & block) {
           return !block.fault && !block.moving && block.height_m < kLevel;
         });
}

}  // namespace

bool Passage::enters(
  const stetro_site::Pose & in_map, const stetro_site::Covariance & covariance) const
{
  const stetro_site::Pose pose = flight_->T_map_flight().to_frame(in_map);
  const bool before = pose.x_m >= -params_.approach_m && pose.x_m < 0.0;
  const bool between =
    pose.y_m >= params_.wall_margin_m && pose.y_m <= flight_->width_m(0.0) - params_.wall_margin_m;
  return before && between && std::abs(pose.yaw_rad) <= params_.approach_yaw_rad &&
         position_sigma_m(covariance) <= params_.approach_sigma_m;
}

bool Passage::retreats(int step, const stetro_site::Pose & pose) const
{
  return step == 0 && (pose.x_m < -(params_.approach_m + params_.retreat_m) ||
                       std::abs(pose.yaw_rad) > params_.retreat_yaw_rad);
}

bool Passage::may_leave(int step, const BlockSample & blocks) const
{
  return step == flight_->steps() && level_and_at_rest(blocks);
}

bool Passage::leaves(const stetro_site::Pose & in_map) const
{
  return flight_->T_map_flight().to_frame(in_map).x_m >= flight_->total_run_m() - params_.top_m;
}

}  // namespace stetro_localizer
