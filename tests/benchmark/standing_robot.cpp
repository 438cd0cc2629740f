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

#include "benchmark/standing_robot.hpp"

#include <array>
#include <string>
#include <utility>

#include "stetro_dds/stamp.hpp"

namespace bench::standing
{

namespace
{

constexpr double kHalfPi = 1.5707963267948966;

/// Sensor by place and what it reads [m]; the walls are 2.05 m apart, the robot in the middle.
const std::array<std::pair<const char *, double>, 8> kReadings = {{
  {"side_left", 0.975},
  {"side_right", 0.975},
  {"front_left", 0.11},
  {"front_right", 0.11},
  {"stair_front", 0.11},
  {"block1_down", 0.035},
  {"block2_down", 0.035},
  {"block3_front", 0.035},
}};

std_msgs::msg::Header header(std::chrono::nanoseconds stamp, const char * frame)
{
  std_msgs::msg::Header result;
  result.stamp(stetro_dds::stamp_of(stamp));
  result.frame_id(frame);
  return result;
}

stetro_msgs::msg::ContactState open_switch()
{
  stetro_msgs::msg::ContactState result;
  result.state(stetro_msgs::msg::ContactState_Constants::STATE_OPEN);
  return result;
}

stetro_msgs::msg::BlockState block_on_the_floor()
{
  stetro_msgs::msg::BlockState result;
  result.height(0.0);
  result.target(0.0);
  result.at_lower_lock(true);
  result.load(1.0 / 3.0);
  return result;
}

}  // namespace

stetro_msgs::msg::RangeArray ranges(std::chrono::nanoseconds stamp)
{
  stetro_msgs::msg::RangeArray result;
  result.header(header(stamp, "base_link"));
  for (const auto & [sensor, range_m] : kReadings) {
    stetro_msgs::msg::RangeReading reading;
    reading.stamp(stetro_dds::stamp_of(stamp));
    reading.sensor(sensor);
    reading.range(range_m);
    reading.standard_deviation(0.01);
    reading.status(stetro_msgs::msg::RangeReading_Constants::STATUS_VALID);
    result.readings().push_back(reading);
  }
  return result;
}

stetro_msgs::msg::Contacts contacts(std::chrono::nanoseconds stamp)
{
  stetro_msgs::msg::Contacts result;
  result.header(header(stamp, "base_link"));
  for (auto * contact :
       {&result.left_front(), &result.left_middle(), &result.left_rear(), &result.right_front(),
        &result.right_middle(), &result.right_rear(), &result.riser_left(), &result.riser_right(),
        &result.emergency_stop()}) {
    *contact = open_switch();
  }
  return result;
}

stetro_msgs::msg::BlockStates blocks(std::chrono::nanoseconds stamp)
{
  stetro_msgs::msg::BlockStates result;
  result.header(header(stamp, "base_link"));
  for (auto * block : {&result.block1(), &result.block2(), &result.block3()}) {
    *block = block_on_the_floor();
  }
  result.steering_angle(kHalfPi);
  result.steering_target(kHalfPi);
  return result;
}

sensor_msgs::msg::Imu imu(std::chrono::nanoseconds stamp)
{
  sensor_msgs::msg::Imu result;
  result.header(header(stamp, "base_link"));
  result.orientation_covariance()[0] = -1.0;  // REP 145: no orientation is measured
  result.angular_velocity_covariance() = {3e-6, 0, 0, 0, 3e-6, 0, 0, 0, 3e-6};
  result.linear_acceleration().z(9.81);
  result.linear_acceleration_covariance() = {1e-2, 0, 0, 0, 1e-2, 0, 0, 0, 1e-2};
  return result;
}

nav_msgs::msg::Odometry odometry(std::chrono::nanoseconds stamp)
{
  nav_msgs::msg::Odometry result;
  result.header(header(stamp, "odom"));
  result.child_frame_id("base_link");
  result.pose().pose().orientation().w(1.0);
  for (std::size_t i = 0; i < 36; i += 7) {
    result.pose().covariance()[i] = 1e-4;
    result.twist().covariance()[i] = 1e-4;
  }
  return result;
}

}  // namespace bench::standing
