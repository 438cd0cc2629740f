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

#ifndef STETRO_DRIVER__SENSOR_FRAME_HPP_
#define STETRO_DRIVER__SENSOR_FRAME_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// Places of the range sensors (D1-14: names by place, never numbers on the wire).
enum class RangePlace : std::uint8_t {
  kSideLeft,
  kSideRight,
  kFrontLeft,
  kFrontRight,
  kStairFront,
  kBlock1Down,
  kBlock2Down,
  kBlock3Front,
};
constexpr std::size_t kRangePlaces = 8;

/// Places of the switches. Left is +y of base_link; front, middle, rear are blocks 1, 2, 3.
enum class ContactPlace : std::uint8_t {
  kLeftFront,
  kLeftMiddle,
  kLeftRear,
  kRightFront,
  kRightMiddle,
  kRightRear,
  kRiserLeft,
  kRiserRight,
  kEmergencyStop,
};
constexpr std::size_t kContactPlaces = 9;
constexpr std::size_t kBumpers = 6;
constexpr std::size_t kBlocks = 3;

/// Names as on the wire and in files, in the order of the enumerations.
constexpr std::array<std::string_view, kRangePlaces> kRangeNames{
  "side_left",   "side_right",  "front_left",  "front_right",
  "stair_front", "block1_down", "block2_down", "block3_front"};
constexpr std::array<std::string_view, kContactPlaces> kContactNames{
  "left_front", "left_middle", "left_rear",   "right_front",   "right_middle",
  "right_rear", "riser_left",  "riser_right", "emergency_stop"};

/// Whether a range may be believed.
enum class RangeStatus : std::uint8_t {
  kValid,
  kTooNear,   ///< a target nearer than the sensor can measure
  kNoTarget,  ///< healthy, and nothing within reach
  kWeak,      ///< an echo beyond the sensor's own limit of trust
  kStale,     ///< late, or an old measurement again
  kFault,     ///< does not answer
};

/// One range, as REP 117: -inf too near, +inf nothing within reach, NaN no measurement.
struct RangeReading
{
  Time stamp{0};  ///< of the measurement; zero when there never was one
  double range_m = std::numeric_limits<double>::quiet_NaN();
  double std_dev_m = std::numeric_limits<double>::quiet_NaN();
  RangeStatus status = RangeStatus::kFault;
};

/// One switch.
struct ContactReading
{
  bool closed = false;
  bool fault = false;   ///< known to be broken: `closed` is not to be used
  Time last_change{0};  ///< zero when it has not changed since the start
};

/// One block and its lift.
struct BlockReading
{
  double height_m = 0.0;  ///< underside above the lowest of the three undersides
  double target_m = 0.0;  ///< what the lift is told to reach, measured as height_m
  bool moving = false;
  bool at_lower_lock = false;  ///< lowered and standing
  bool at_upper_lock = false;  ///< lifted by the whole stroke
  double load = 0.0;           ///< share of the robot's weight on this block, 0 to 1
  bool fault = false;
};

/// The wheels' steering.
struct SteeringReading
{
  double angle_rad = 0.0;  ///< 0 rolls along x, pi/2 along y
  double target_rad = 0.0;
  bool moving = false;
};

/// A rotation. Applied to a vector of the turned frame it gives the vector in the frame outside.
struct Quaternion
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};

/// How base_link lies in the world.
struct AttitudeReading
{
  Quaternion base_in_world;       ///< world: x east, y north, z up (REP 103)
  double tilt_std_dev_rad = 0.0;  ///< of roll and of pitch
  double yaw_std_dev_rad = 0.0;   ///< of the heading, which magnetism disturbs indoors
};

/// What an inertial sensor says, in base_link. Rates of turn are counter-clockwise positive.
/**
 * The rate is the mean since the stamp of the reading before it, however many samples came between:
 * rates times the differences of their stamps add up to the angle turned. The same stamp again is
 * the same reading again. The rest was measured at the stamp.
 */
struct GyroReading
{
  Time stamp{0};
  std::array<double, 3> rate_rad_s{0.0, 0.0, 0.0};
  double std_dev_rad_s = 0.0;  ///< white noise of the rate
  bool fault = false;
  std::optional<AttitudeReading> attitude{};  ///< nothing: a plain gyroscope
  /// Specific force [m/s^2]: +9.8 about along z at rest. Nothing: not measured.
  std::optional<std::array<double, 3>> acceleration_m_s2{};
  double acceleration_std_dev_m_s2 = 0.0;  ///< white noise of one sample
};

/// What the wheels say: velocity in base_link, and dead reckoning since the start in `odom`.
struct OdometryReading
{
  Time stamp{0};
  double vx_m_s = 0.0;
  double vy_m_s = 0.0;
  double wz_rad_s = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
  double rolled_m = 0.0;    ///< in all, whichever way: what the pose has drifted over
  double turned_rad = 0.0;  ///< in all, either way
};

/// One turn of the lidar, taken in an instant. Ranges as REP 117, see RangeReading.
struct LidarScan
{
  Time stamp{0};                     ///< of the first beam; zero when there never was one
  double angle_min_rad = 0.0;        ///< of the first beam in the frame `lidar`
  double angle_increment_rad = 0.0;  ///< counter-clockwise
  double min_range_m = 0.0;
  double max_range_m = 0.0;
  double period_s = 0.0;  ///< from scan to scan
  std::vector<float> ranges_m{};
};

/// Everything the robot's sensors say at one time.
struct SensorFrame
{
  Time time{0};                  ///< of this reading
  bool ranges_complete = false;  ///< a cycle of the range sensors has just ended
  std::array<RangeReading, kRangePlaces> ranges{};
  std::array<ContactReading, kContactPlaces> contacts{};
  bool emergency_stop_latched = false;  ///< its button was pressed, and nobody has reset it since
  Time blocks_stamp{0};                 ///< when blocks and steering were measured
  std::array<BlockReading, kBlocks> blocks{};
  SteeringReading steering{};
  GyroReading gyro{};
  OdometryReading odometry{};
  bool scan_complete = false;  ///< a turn of the lidar has just ended
  const LidarScan * scan =
    nullptr;  ///< the hardware's, good until it is read again; null: no lidar

  [[nodiscard]] const RangeReading & range(RangePlace place) const
  {
    return ranges[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] const ContactReading & contact(ContactPlace place) const
  {
    return contacts[static_cast<std::size_t>(place)];
  }
  /// \param number 1 front, 2 middle, 3 rear
  [[nodiscard]] const BlockReading & block(int number) const
  {
    return blocks[static_cast<std::size_t>(number - 1)];
  }
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SENSOR_FRAME_HPP_
