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

#ifndef STETRO_DDS__QOS_HPP_
#define STETRO_DDS__QOS_HPP_

#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace stetro_dds
{

enum class Reliability { kBestEffort, kReliable };
enum class Durability { kVolatile, kTransientLocal };

/// What one endpoint offers (a writer) or requests (a reader). History is always KEEP_LAST.
struct EndpointQos
{
  Reliability reliability;
  Durability durability;
  std::int32_t depth;  ///< samples kept [1]
};

/// The quality of service of one kind of stream, for its writer and its reader.
/**
 * Deadline, lifespan, liveliness, ownership and partition are those of ROS 2 (infinite, automatic,
 * shared, none) and data sharing is off, so no profile has fields for them.
 */
struct QosProfile
{
  std::string_view name;
  EndpointQos offered;    ///< by the writer
  EndpointQos requested;  ///< by the reader
  /// How long a lost sample may wait to be noticed; the reader of a late join waits this long too.
  std::chrono::milliseconds heartbeat;
  std::string_view used_for;
};

/// Every profile there is; nothing else in the tree decides about quality of service.
/**
 * Sensor writers are RELIABLE and sensor readers BEST_EFFORT: a reliable reader such as an RViz
 * display and a best-effort reader both match the writer, and ours never waits for a
 * retransmission of a value that a newer one replaces.
 */
namespace qos
{

inline constexpr EndpointQos reliable(std::int32_t depth)
{
  return {Reliability::kReliable, Durability::kVolatile, depth};
}
inline constexpr EndpointQos latched(std::int32_t depth)
{
  return {Reliability::kReliable, Durability::kTransientLocal, depth};
}
inline constexpr EndpointQos best_effort(std::int32_t depth)
{
  return {Reliability::kBestEffort, Durability::kVolatile, depth};
}

using std::chrono_literals::operator""ms;

inline constexpr QosProfile kSensor{
  "sensor", reliable(5), best_effort(5), 20ms,
  "ranges, range/*, blocks, imu/data, odom, scan, innovations, ground_truth"};
inline constexpr QosProfile kContacts{"contacts", latched(1), latched(1), 20ms, "contacts"};
inline constexpr QosProfile kLatched{
  "latched", latched(1), latched(1), 50ms, "stair_pose, profile_check, mission_status"};
inline constexpr QosProfile kCommand{"command", reliable(1), reliable(1), 20ms, "command"};
inline constexpr QosProfile kCommandStatus{
  "command_status", reliable(10), reliable(10), 20ms, "command_status"};
inline constexpr QosProfile kPose{"pose", reliable(5), reliable(5), 20ms, "pose"};
inline constexpr QosProfile kCorrection{
  "correction", reliable(5), reliable(5), 50ms, "initialpose, pose_correction"};
inline constexpr QosProfile kMission{"mission", reliable(10), reliable(10), 50ms, "mission"};
inline constexpr QosProfile kTf{"tf", reliable(100), reliable(100), 50ms, "/tf"};
inline constexpr QosProfile kTfStatic{"tf_static", latched(1), latched(100), 100ms, "/tf_static"};
inline constexpr QosProfile kFleetState{
  "fleet_state", reliable(10), reliable(10), 100ms, "/fleet_states"};
inline constexpr QosProfile kDiagnostics{
  "diagnostics", reliable(10), reliable(100), 100ms, "/diagnostics"};
inline constexpr QosProfile kClock{"clock", reliable(5), best_effort(1), 20ms, "/clock"};
inline constexpr QosProfile kDiscoveryInfo{
  "discovery_info", latched(1), latched(100), 100ms, "ros_discovery_info"};

/// All of the above, in that order, for tests and for the documentation.
const std::vector<QosProfile> & table();

}  // namespace qos

}  // namespace stetro_dds

#endif  // STETRO_DDS__QOS_HPP_
