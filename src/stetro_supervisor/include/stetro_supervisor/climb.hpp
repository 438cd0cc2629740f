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
#ifndef STETRO_SUPERVISOR__CLIMB_HPP_
#define STETRO_SUPERVISOR__CLIMB_HPP_

#include <optional>
#include <string>
#include <vector>

#include "stetro_supervisor/climb_geometry.hpp"
#include "stetro_supervisor/climb_params.hpp"
#include "stetro_supervisor/motion_command.hpp"
#include "stetro_supervisor/observation.hpp"
#include "stetro_supervisor/situation.hpp"
#include "stetro_supervisor/transition_table.hpp"

namespace stetro_supervisor
{

/// A change of state, for the log.
struct Transition
{
  Time time{0};
  State from;
  State to;
  std::string why;
};

/// Walks the transition table: one tick, at most one transition, one command.
/**
 * Reads no clock: every tick brings its time. A tick with a time before the last one holds the
 * robot, because ages and limits mean nothing across such a jump. Not thread-safe.
 */
class Climb
{
public:
  /// \throws std::invalid_argument naming what cannot be climbed, see `check_climbable`
  Climb(ClimbParams params, ClimbGeometry geometry);

  /// Takes up a mission that was under way when the process ended: held until a resume request.
  void restore(const MissionRecord & record);

  /// Begins to clean the flight with the next tick, from where the robot stands.
  void start(const std::string & request_id, const std::string & issuer, int step);

  /// What an operator asks, for the next tick alone.
  void ask(Asked asked) { memory_.asked = asked; }

  bool is_asked() const { return memory_.asked != Asked::kNothing; }

  /// One step: what the robot shall do until the next.
  MotionCommand tick(Time now, const Observation & seen);

  /// Takes in what is seen without a transition or a command: something else is at the wheel.
  void look_on(Time now, const Observation & seen);

  /// Nothing is under way any more: the robot stands elsewhere than before or on its flight.
  void leave();

  /// The situation of the last tick, for refusals and status.
  Situation situation() const;

  State state() const { return state_; }
  Fault fault() const { return memory_.fault; }
  const std::string & note() const { return memory_.note; }
  const MissionRecord & record() const { return memory_.record; }
  const ClimbParams & params() const { return params_; }
  const ClimbGeometry & geometry() const { return geometry_; }
  double time_in_state_s() const { return seconds_between(entered_, now_); }
  double time_limit_s() const;  ///< of the state; +inf where there is none [s]

  /// The transition of the last tick, if there was one.
  const std::optional<Transition> & transition() const { return transition_; }

private:
  void take_time(Time now);
  void follow_path(const OdometryPose & odometry);
  void take_ranges(double dt_s);
  void watch(const Situation & s);
  void watch_gap(std::optional<double> gap_m);
  void watch_driver(const Situation & s);
  const Exit * first_open(const Situation & s, const Row & row) const;
  void enter(const Exit & exit, const Situation & s);
  std::string reason(const Exit & exit, const Situation & s) const;

  ClimbParams params_;
  ClimbGeometry geometry_;
  Memory memory_;
  Observation seen_;
  State state_ = State::kIdle;
  Time now_{0};
  Time entered_{0};
  std::optional<OdometryPose> last_odometry_;
  Time last_front_time_{0};
  std::optional<Transition> transition_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__CLIMB_HPP_
