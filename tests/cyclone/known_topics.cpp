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

#include "cyclone/known_topics.hpp"

#include <BlockStates.h>
#include <Clock.h>
#include <Command.h>
#include <CommandStatus.h>
#include <Contacts.h>
#include <DiagnosticArray.h>
#include <Imu.h>
#include <Innovations.h>
#include <MissionStatus.h>
#include <Odometry.h>
#include <PoseWithCovarianceStamped.h>
#include <RangeArray.h>
#include <StairPose.h>
#include <TFMessage.h>

namespace stetro_tests::cyclone
{

const std::vector<KnownTopic> & published_topics()
{
  constexpr bool kLatched = true;
  constexpr bool kVolatile = false;
  constexpr bool kSensor = true;
  constexpr bool kPlain = false;
  static const std::vector<KnownTopic> topics = {
    {"/stetro/ranges", "driver", &stetro_msgs_msg_dds__RangeArray__desc, kVolatile, kSensor, true},
    {"/stetro/contacts", "driver", &stetro_msgs_msg_dds__Contacts__desc, kLatched, kPlain, true},
    {"/stetro/blocks", "driver", &stetro_msgs_msg_dds__BlockStates__desc, kVolatile, kSensor, true},
    {"/stetro/imu/data", "driver", &sensor_msgs_msg_dds__Imu__desc, kVolatile, kSensor, true},
    {"/stetro/odom", "driver", &nav_msgs_msg_dds__Odometry__desc, kVolatile, kSensor, true},
    {"/stetro/command", "supervisor", &stetro_msgs_msg_dds__Command__desc, kVolatile, kPlain,
     false},
    {"/stetro/command_status", "driver", &stetro_msgs_msg_dds__CommandStatus__desc, kVolatile,
     kPlain, false},
    {"/stetro/pose", "localizer", &geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc,
     kVolatile, kPlain, true},
    {"/stetro/stair_pose", "localizer", &stetro_msgs_msg_dds__StairPose__desc, kLatched, kPlain,
     true},
    {"/stetro/innovations", "localizer", &stetro_msgs_msg_dds__Innovations__desc, kVolatile,
     kSensor, true},
    {"/tf", "", &tf2_msgs_msg_dds__TFMessage__desc, kVolatile, kPlain, true},
    {"/stetro/mission_status", "supervisor", &stetro_msgs_msg_dds__MissionStatus__desc, kLatched,
     kPlain, true},
    {"/diagnostics", "", &diagnostic_msgs_msg_dds__DiagnosticArray__desc, kVolatile, kPlain, true},
    {"/clock", "driver", &rosgraph_msgs_msg_dds__Clock__desc, kVolatile, kSensor, true},
    {"/stetro/ground_truth", "driver", &stetro_msgs_msg_dds__StairPose__desc, kVolatile, kSensor,
     true},
  };
  return topics;
}

}  // namespace stetro_tests::cyclone
