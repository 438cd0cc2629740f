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

#ifndef STETRO_DRIVER__SIMULATED_WORLD_HPP_
#define STETRO_DRIVER__SIMULATED_WORLD_HPP_

#include <array>
#include <string>

#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_driver
{

/// What is really so. For looking only: nothing of the robot may read it.
/**
 * On a floor that somebody has drawn, while base_link is neither on nor over the stairs, the
 * segment is the floor; its frame is the floor's, `step` is 0, and what is said of treads is NaN.
 * Else it is the flight, also on the floors before and behind it.
 */
struct GroundTruth
{
  Time time{0};
  std::string segment{};  ///< id of the flight or floor, which is also the name of its frame
  bool on_floor = false;  ///< the segment is a floor
  int step = 0;           ///< tread block 2 stands, or last stood, on; 0 the floor below
  double x_m = 0.0;       ///< base_link in the segment's frame
  double y_m = 0.0;
  double z_m = 0.0;  ///< of the surface of `step`
  double yaw_rad = 0.0;
  stetro_site::Pose in_map{};  ///< the same pose in `map`, heights as built
  double tread_x_m = 0.0;      ///< from the riser behind, the tread's own edge, at the robot's y
  double riser_ahead_m = 0.0;  ///< to the next riser's face; NaN on the last step
  double tread_width_m = 0.0;  ///< from wall to wall at the robot's x
  double heading_rad = 0.0;    ///< yaw against the next riser's direction; yaw on the last step
  std::array<double, kBlocks> block_heights_m{};  ///< undersides in the segment's frame
  bool fallen = false;
};

/// What became of an old snapshot.
enum class ResumeOutcome {
  kFresh,    ///< there was none
  kResumed,  ///< the world goes on from it, standing and holding
  kDamaged,  ///< not used, kept beside as `<path>.refused`
  kForeign,  ///< of another world, not used, kept beside
};

/// What a simulation has beside its robot: a time of its own, and the truth.
class SimulatedWorld
{
public:
  SimulatedWorld() = default;
  virtual ~SimulatedWorld() = default;
  SimulatedWorld(const SimulatedWorld &) = delete;
  SimulatedWorld & operator=(const SimulatedWorld &) = delete;

  /// Time in the world, well above zero; from any thread if the world moves by itself.
  [[nodiscard]] virtual Time time() const = 0;
  [[nodiscard]] virtual GroundTruth truth() const = 0;
};

/// A world that stands still until it is told to go on, so that a run can be repeated.
class SteppedWorld : public SimulatedWorld
{
public:
  static constexpr Time kTick = std::chrono::milliseconds{10};

  /// Lets the world go on by one tick.
  virtual void step() = 0;

  [[nodiscard]] virtual ResumeOutcome resume_outcome() const = 0;
  [[nodiscard]] virtual const std::string & resume_detail() const = 0;  ///< in words, for a log
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__SIMULATED_WORLD_HPP_
