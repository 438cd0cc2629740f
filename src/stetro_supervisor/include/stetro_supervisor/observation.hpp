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

#ifndef STETRO_SUPERVISOR__OBSERVATION_HPP_
#define STETRO_SUPERVISOR__OBSERVATION_HPP_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "stetro_site/sensor_place.hpp"
#include "stetro_supervisor/floor/scan.hpp"
#include "stetro_supervisor/time.hpp"

namespace stetro_supervisor
{

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using stetro_site::Place;
constexpr std::size_t kPlaceCount = stetro_site::kPlaces.size();

enum class RangeStatus : std::uint8_t {
  kUnknown,
  kValid,
  kTooNear,   ///< something nearer than the sensor can measure
  kNoTarget,  ///< healthy, and nothing within reach
  kWeak,
  kStale,
  kFault
};

struct Range
{
  Time time{0};           ///< when it was received
  double range_m = kNan;  ///< along the beam from the sensor [m]; only with kValid
  RangeStatus status = RangeStatus::kUnknown;
  Time measured{0};  ///< by the sensor's stamp: a reading repeated is not a new one
};

enum class ContactState : std::uint8_t { kUnknown, kOpen, kClosed };

struct Contact
{
  ContactState state = ContactState::kUnknown;
  bool fault = false;  ///< known to be broken: the state is not to be used
};

/// Every switch of the robot; left is +y of base_link.
struct Contacts
{
  Time time{0};
  std::array<Contact, 3> left{};   ///< bumpers, front to rear
  std::array<Contact, 3> right{};  ///< bumpers, front to rear
  Contact riser_left{};            ///< on block 2's front edge (SW1 of S-P)
  Contact riser_right{};           ///< SW2 of S-P
  Contact emergency_stop{};        ///< closed while pressed
};

struct Block
{
  double height_m = kNan;  ///< underside above the lowest of the three undersides [m]
  bool moving = false;
  bool at_lower_lock = false;
  bool at_upper_lock = false;
  double load = kNan;  ///< share of the robot's weight on this block, 0 to 1; NaN unknown
  bool fault = false;
};

struct Blocks
{
  Time time{0};
  std::array<Block, 3> block{};  ///< front (1), middle (2), rear (3)
  double steering_rad = kNan;    ///< wheels about +z: 0 rolls along x, pi/2 along y
  bool steering_moving = false;
};

/// base_link in the frame odom; only differences are used.
struct OdometryPose
{
  Time time{0};
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

enum class Integrity : std::uint8_t { kUnknown, kOk, kDegraded, kLost };

/// What the localizer says, in the frame of the flight or of the floor.
struct StairPose
{
  Time time{0};               ///< when it was received
  std::string segment_id;     ///< flight or floor
  bool on_flight = false;     ///< the segment is a flight
  int step = -1;              ///< tread block 2 stands on; 0 the floor below, -1 unknown
  double y_m = kNan;          ///< of base_link; on a flight its distance from the right wall [m]
  double heading_rad = kNan;  ///< psi, CCW positive, 0 faces the risers (D1-6)
  Integrity integrity = Integrity::kUnknown;
  std::uint32_t reasons = 0;         ///< why integrity is not OK: a sum of PoseReason
  std::uint32_t resets = 0;          ///< jumps of the estimate so far
  double x_m = kNan;                 ///< of base_link [m]
  double tread_x_m = kNan;           ///< of base_link, from the foot of its tread's own riser [m]
  double protection_along_m = kNan;  ///< level of the error of x on the tread [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, heading)
};

/// What the driver said to our last command.
struct DriverAnswer
{
  Time time{0};
  bool refused = false;
  std::string reason;  ///< in words, empty when not refused
};

/// Everything the autonomy sees at one tick. Absent is unknown, never a default.
struct Observation
{
  std::array<std::optional<Range>, kPlaceCount> ranges{};  ///< by `index_of(place)`
  std::optional<Contacts> contacts;
  std::optional<Blocks> blocks;
  std::optional<OdometryPose> odometry;
  std::optional<StairPose> pose;
  std::optional<DriverAnswer> driver_answer;
  std::optional<std::uint64_t> driver_instance;  ///< changes when the driver's process restarts
  std::shared_ptr<const Scan> scan;              ///< the last turn of the lidar

  const std::optional<Range> & range(Place place) const
  {
    return ranges[stetro_site::index_of(place)];
  }
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__OBSERVATION_HPP_
