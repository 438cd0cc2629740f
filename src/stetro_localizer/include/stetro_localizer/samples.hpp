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

#ifndef STETRO_LOCALIZER__SAMPLES_HPP_
#define STETRO_LOCALIZER__SAMPLES_HPP_

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

#include "stetro_site/sensor_place.hpp"

namespace stetro_localizer
{

/// Time of a sample or a tick: since the epoch, or since the origin of simulated time. Never zero.
using Nanoseconds = std::chrono::nanoseconds;

/// Seconds in a duration.
[[nodiscard]] constexpr double seconds(Nanoseconds duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// The inverse; fractions of a nanosecond are cut off.
[[nodiscard]] constexpr Nanoseconds nanoseconds(double duration_s)
{
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(duration_s));
}

using stetro_site::Place;

/// What the sensor says of its own reading. Only `kValid` carries a distance.
enum class RangeStatus { kAbsent, kValid, kTooNear, kNoTarget, kWeak, kStale, kFault };

/// One reading of one beam.
struct RangeReading
{
  Nanoseconds stamp{0};
  double range_m = 0.0;  ///< along the beam, from the sensor [m]; meaningless unless `kValid`
  double sigma_m = 0.0;  ///< the sensor's own standard deviation [m]; 0 if it gives none
  RangeStatus status = RangeStatus::kAbsent;
};

/// The readings of one cycle.
struct RangeSample
{
  Nanoseconds stamp{0};
  std::array<RangeReading, stetro_site::kPlaces.size()> readings;  ///< by `index_of` their place

  [[nodiscard]] const RangeReading & operator[](Place place) const
  {
    return readings[stetro_site::index_of(place)];
  }
  [[nodiscard]] RangeReading & operator[](Place place)
  {
    return readings[stetro_site::index_of(place)];
  }
};

/// One switch. A broken or silent one is not `known`, and then `closed` means nothing.
struct Switch
{
  bool known = false;
  bool closed = false;

  [[nodiscard]] bool is_closed() const { return known && closed; }
};

/// Every switch the estimators use; bumpers from the front block to the rear one.
struct ContactSample
{
  Nanoseconds stamp{0};
  std::array<Switch, 3> left;   ///< bumpers on the +y side
  std::array<Switch, 3> right;  ///< bumpers on the -y side
  Switch riser_left;            ///< on block 2's front edge (SW1 of S-P)
  Switch riser_right;           ///< on block 2's front edge (SW2 of S-P)
};

/// One block and its lift.
struct BlockReading
{
  double height_m = 0.0;  ///< underside above the lowest of the three undersides [m]
  double load = 0.0;      ///< share of the robot's weight that stands on it, 0 to 1
  bool load_known = false;
  bool moving = false;
  bool fault = false;  ///< height and load are not to be used
};

/// The three blocks, front to rear.
struct BlockSample
{
  Nanoseconds stamp{0};
  std::array<BlockReading, 3> blocks;
};

/// Turn rate about +z, counter-clockwise positive.
struct GyroSample
{
  Nanoseconds stamp{0};
  double rate_radps = 0.0;
  /// About +y, nose down positive, of an IMU that knows its attitude [rad]
  std::optional<double> pitch_rad = std::nullopt;
};

/// Speed of `base_link` as the wheels tell it, in `base_link`.
struct OdometrySample
{
  Nanoseconds stamp{0};
  double vx_mps = 0.0;
  double vy_mps = 0.0;
  double wz_radps = 0.0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SAMPLES_HPP_
