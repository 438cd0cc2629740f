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

#ifndef TESTS__BENCHMARK__STANDING_ROBOT_HPP_
#define TESTS__BENCHMARK__STANDING_ROBOT_HPP_

#include <chrono>

#include "stetro_msgs/BlockStates.hpp"
#include "stetro_msgs/Contacts.hpp"
#include "stetro_msgs/Imu.hpp"
#include "stetro_msgs/Odometry.hpp"
#include "stetro_msgs/RangeArray.hpp"

/// What the driver of a robot says that stands in the middle before the papers' first riser, its
/// front sensors 11 cm from it.
namespace bench::standing
{

stetro_msgs::msg::RangeArray ranges(std::chrono::nanoseconds stamp);
stetro_msgs::msg::Contacts contacts(std::chrono::nanoseconds stamp);
stetro_msgs::msg::BlockStates blocks(std::chrono::nanoseconds stamp);
sensor_msgs::msg::Imu imu(std::chrono::nanoseconds stamp);
nav_msgs::msg::Odometry odometry(std::chrono::nanoseconds stamp);

}  // namespace bench::standing

#endif  // TESTS__BENCHMARK__STANDING_ROBOT_HPP_
