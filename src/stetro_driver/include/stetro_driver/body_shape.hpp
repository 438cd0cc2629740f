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

#ifndef STETRO_DRIVER__BODY_SHAPE_HPP_
#define STETRO_DRIVER__BODY_SHAPE_HPP_

#include <array>
#include <cstddef>

#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver
{

/// A point or a direction [m].
struct Vector3
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

/// A range sensor on its block.
struct TofMounting
{
  int block = 1;                     ///< it rides on this block, 1 front to 3 rear
  Vector3 position_m{};              ///< x, y in base_link, z above the block's underside
  Vector3 direction{1.0, 0.0, 0.0};  ///< unit, in base_link
};

/// The lidar on block 2.
struct LidarShape
{
  double x_m = 0.0;  ///< in base_link
  double y_m = 0.0;
  double height_m = 0.45;  ///< above block 2's underside
  double yaw_rad = 0.0;    ///< of its x axis in base_link
  double min_range_m = 0.15;
  double max_range_m = 12.0;
  std::size_t beams = 720;  ///< of one turn
  double rate_hz = 10.0;
};

/// The robot's body: three blocks in a row, joined by vertical sliders.
struct BodyShape
{
  double block_length_m = 0.15;
  double body_width_m = 0.20;
  double block_height_m = 0.40;
  double contact_width_m = 0.23;  ///< over the bumpers (D1-1)
  double stroke_m = 0.18;         ///< of a lift, from where its block stood
  double lift_speed_m_s = 0.06;
  double steer_speed_rad_s = 1.6;
  double bumper_travel_m = 0.002;  ///< how far a bumper yields after it closed
  double switch_travel_m = 0.001;  ///< how far a riser switch yields after it closed
  double switch_y_m = 0.08;        ///< riser switches on block 2's front edge, at +-y
  std::array<TofMounting, kRangePlaces> tof{{
    {2, {0.0, 0.05, 0.33}, {0.0, 1.0, 0.0}},
    {2, {0.0, -0.05, 0.33}, {0.0, -1.0, 0.0}},
    {1, {0.19, 0.10, 0.07}, {1.0, 0.0, 0.0}},
    {1, {0.19, -0.10, 0.07}, {1.0, 0.0, 0.0}},
    {1, {0.19, 0.0, 0.07}, {1.0, 0.0, 0.0}},
    {1, {0.15, 0.0, 0.035}, {0.0, 0.0, -1.0}},
    {2, {0.0, 0.0, 0.035}, {0.0, 0.0, -1.0}},
    {3, {-0.11, 0.0, 0.07}, {1.0, 0.0, 0.0}},
  }};
  LidarShape lidar{};

  /// x of a block's centre in base_link. \param block 1 front to 3 rear
  [[nodiscard]] double block_x_m(int block) const { return (2 - block) * block_length_m; }
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__BODY_SHAPE_HPP_
