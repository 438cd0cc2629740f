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

#ifndef ACCURACY__CONVERT_HPP_
#define ACCURACY__CONVERT_HPP_

#include <cstdint>
#include <optional>
#include <string>

#include "stetro_driver/command_gate.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_supervisor/motion_command.hpp"
#include "stetro_supervisor/observation.hpp"

// The only place in a closed loop without middleware that knows two packages' types at once. Each
// function is what two nodes' convert.hpp do one after the other: type to message to type.
namespace stetro_bringup
{

/// What the localizer takes of a frame.
[[nodiscard]] stetro_localizer::OdometrySample to_odometry(
  const stetro_driver::SensorFrame & frame);
[[nodiscard]] stetro_localizer::ContactSample to_contacts(const stetro_driver::SensorFrame & frame);
[[nodiscard]] stetro_localizer::BlockSample to_blocks(const stetro_driver::SensorFrame & frame);

/// Nothing while the gyroscope does not answer: its topic is silent then.
[[nodiscard]] std::optional<stetro_localizer::GyroSample> to_gyro(
  const stetro_driver::SensorFrame & frame);

/// Each reading keeps the time of its measurement, 20 ms before the cycle's own stamp.
/** Nothing if one reading breaks the rules of the wire: the whole array is refused then.
 * \param stale_after a valid reading older than this is marked stale */
[[nodiscard]] std::optional<stetro_localizer::RangeSample> to_ranges(
  const stetro_driver::SensorFrame & frame, stetro_localizer::Nanoseconds stale_after);

/// What the supervisor takes of a frame, written into what it has seen so far.
void observe_ranges(
  const stetro_driver::SensorFrame & frame, stetro_supervisor::Observation & seen);
void observe_contacts(
  const stetro_driver::SensorFrame & frame, stetro_supervisor::Observation & seen);
void observe_blocks(
  const stetro_driver::SensorFrame & frame, stetro_supervisor::Observation & seen);
void observe_odometry(
  const stetro_driver::SensorFrame & frame, stetro_supervisor::Observation & seen);

/// What the supervisor takes of an estimate. A pose older than the last one is not taken.
void observe_pose(
  const stetro_localizer::StairEstimate & estimate, const std::string & segment_id,
  stetro_supervisor::Observation & seen);

/// A command as the driver's gate receives it.
[[nodiscard]] stetro_driver::CommandRequest to_request(
  const stetro_supervisor::MotionCommand & command, std::uint64_t sequence_number,
  stetro_driver::Time now, stetro_driver::Time valid_for);

}  // namespace stetro_bringup

#endif  // ACCURACY__CONVERT_HPP_
