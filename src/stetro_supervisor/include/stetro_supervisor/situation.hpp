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
#ifndef STETRO_SUPERVISOR__SITUATION_HPP_
#define STETRO_SUPERVISOR__SITUATION_HPP_

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "stetro_supervisor/climb_geometry.hpp"
#include "stetro_supervisor/climb_params.hpp"
#include "stetro_supervisor/climb_state.hpp"
#include "stetro_supervisor/heading_correction.hpp"
#include "stetro_supervisor/mission_record.hpp"
#include "stetro_supervisor/observation.hpp"
#include "stetro_supervisor/range_median.hpp"
#include "stetro_supervisor/tread_offset.hpp"

namespace stetro_supervisor
{

/// Way travelled since some origin, in the axes of the flight: odometry turned by the heading.
struct Path
{
  double along_m = 0.0;     ///< up the stairs
  double across_m = 0.0;    ///< to the left
  double turned_rad = 0.0;  ///< counter-clockwise
};

/// What an operator asked for, for one tick.
enum class Asked : std::uint8_t {
  kNothing,
  kStart,
  kPause,
  kResume,
  kAbort,
  kClearFault,
  kRelocalise  ///< a person is telling the pose: what waits for it goes on when a person says so
};

/// What the climb remembers between ticks. Only `record` survives a restart.
struct Memory
{
  MissionRecord record;
  Asked asked = Asked::kNothing;
  std::string note;  ///< why the robot is held, waits or has a fault, in words
  Fault fault = Fault::kNone;

  Path path;      ///< since the climb was constructed
  Path mark;      ///< `path` when the state was entered
  Path leg_mark;  ///< `path` when the leg of the sweep began
  TreadOffset offset;
  bool offset_pending = true;  ///< the robot was at the riser: its sweep line starts anew
  HeadingCorrection heading;
  std::array<RangeMedian, kPlaceCount> medians{};

  int trims = 0;                 ///< on this tread
  int realigns = 0;              ///< at this riser
  int relifts = 0;               ///< of block 2 on this tread
  int rejoins = 0;               ///< on this step without an operator, after a doubtful pose
  int resweeps = 0;              ///< of this tread, to touch its walls again
  int skew_side = 0;             ///< riser switch that closed alone: +1 left, -1 right
  double realign_rad = 0.0;      ///< turn that is to square the robot, CCW positive
  double rolled_before_m = 0.0;  ///< of record.rolled_m, before this state was entered
  double trim_target_m = 0.0;    ///< roll along x that restores the sweep line

  double nearest_m = 0.0;  ///< smallest gap since the state was entered
  Time nearest_time{0};
  double nearest_along_m = 0.0;      ///< of `path`, when it was that near
  double farthest_m = 0.0;           ///< largest gap since the state was entered
  std::optional<Time> skewed_since;  ///< exactly one riser switch closed
  std::optional<Time> front_free_since;
  std::optional<Time> pose_sound_since;
  std::optional<Time> refused_since;
  std::optional<std::uint64_t> driver_instance;
  bool driver_changed = false;
  bool clock_went_back = false;
};

/// All that guards, commands and effects may look at. Lives for one tick.
struct Situation
{
  const ClimbParams & params;
  const ClimbGeometry & geometry;
  const Observation & seen;
  const Memory & memory;
  State state;
  Time now;
  Time entered;  ///< when the state was entered

  double in_state_s() const { return seconds_between(entered, now); }
  int step() const { return memory.record.step; }
  bool on_top() const { return step() == geometry.steps(); }

  /// A riser stands in front of block 1 once it is on step `step() + 1`.
  bool riser_ahead() const { return step() + 2 <= geometry.steps(); }

  // odometry since the state was entered, in the axes of the flight
  double along_m() const { return memory.path.along_m - memory.mark.along_m; }
  double across_m() const { return memory.path.across_m - memory.mark.across_m; }
  double turned_rad() const { return memory.path.turned_rad - memory.mark.turned_rad; }

  // the localizer
  bool pose_sound() const;    ///< fresh, on this flight, integrity OK, finite
  bool pose_usable() const;   ///< the same, or DEGRADED by a reason that work under way bears
  bool pose_settled() const;  ///< sound for long enough

  /// Sound, or on the floor and DEGRADED by nothing but a riser that is too far away to tell.
  /** From there only the approach mends that (D3-9); no block is lifted for it. */
  bool pose_lets_approach() const;
  std::string pose_doubt() const;        ///< why it is not sound, in words
  std::string unusable_because() const;  ///< what is wrong beside its integrity, in words
  double heading_rad() const;            ///< psi, 0 when the pose is not usable [rad]

  // the driver
  bool driver_silent() const;
  std::optional<double> range_m(Place place) const;  ///< median; inf for nothing in reach
  std::optional<double> gap_m(Place place) const;    ///< range less the recess of its sensor
  std::optional<double> front_gap_m() const;         ///< smallest of the three at block 1's face
  std::optional<double> front_pair_m() const;        ///< mean of the pair along x, both in reach

  /// The middle front sensor's range along x [m], when something is in reach.
  /** At a wall the outer two have the wall in their cone and read short; this one never has. */
  std::optional<double> front_middle_m() const;
  bool stalled() const;  ///< close by, the gap has stopped shrinking

  // The same where only doubt of the sensor keeps the gap from being none: `contact_doubt_m`. It
  // takes a second witness, for the doubt is wide.
  bool in_doubt_and_still(Place place) const;  ///< the gap may be none, and has stopped shrinking
  bool pushes(Place place) const;  ///< and the wheels have turned several centimetres since

  // switches
  bool left_contact() const;  ///< any of the three left bumpers (D3-13)
  bool right_contact() const;
  bool riser_left() const;
  bool riser_right() const;

  // blocks, 1 to 3
  const Block & block(int number) const;  ///< only with fresh blocks
  double height_m(int number) const;
  bool lifted(int number) const;  ///< at its upper lock and at rest
  bool stands(int number) const;  ///< at rest and bearing load, where load is known
  bool bears(int number) const;   ///< at rest and known to bear load
  bool steering_at(double angle_rad) const;
};

/// Whether both switches, one or none are closed; states that roll to the riser read this.
inline bool both_switches(const Situation & s) { return s.riser_left() && s.riser_right(); }
inline bool any_switch(const Situation & s) { return s.riser_left() || s.riser_right(); }

constexpr double kQuarterTurn_rad = 1.5707963267948966;

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__SITUATION_HPP_
