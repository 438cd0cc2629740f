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

#ifndef STETRO_LOCALIZER__FUSED__FUSED_PARAMS_HPP_
#define STETRO_LOCALIZER__FUSED__FUSED_PARAMS_HPP_

#include <cstdint>

#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_localizer/fused/error_state_filter.hpp"
#include "stetro_localizer/step_model.hpp"

namespace stetro_localizer
{

/// What is known before anything is measured: standard deviations about the files' values.
struct FusedPriors
{
  double range_offset_m = 0.010;         ///< of each range sensor, uncalibrated [m]
  double range_gain = 0.03;              ///< [-]
  double odom_scale = 0.02;              ///< [-]
  double tread_m = 0.0025;               ///< of each tread against the site file [m]
  double riser_m = 0.0015;               ///< of each riser against the site file [m]
  double riser_direction_rad = 0.00175;  ///< 0.1 deg
  double width_m = 0.0025;               ///< between the walls, against the site file [m]
  double width_change_m = 0.0007;        ///< of the width from tread to tread [m]
  double yaw_rad = 0.175;                ///< of a robot that has just been set down [rad]
};

/// How exactly each source measures: standard deviations.
struct FusedNoise
{
  double wheels_mps = 0.001;       ///< of a wheel speed [m/s]
  double blocked_mps = 0.02;       ///< of a robot that pushes against a wall [m/s]
  double unseen_mps = 0.15;        ///< of a robot whose wheels have stopped to tell [m/s]
  double gyro_radps = 0.00175;     ///< of one gyroscope sample [rad/s]
  double bumper_m = 0.001;         ///< where a bumper closes [m]
  double riser_switch_m = 0.0005;  ///< where a riser switch closes [m]
  double clipped_share = 0.03;     ///< of the range, when the cone takes in more than the riser [-]
};

/// What is watched, and what counts as too much.
struct FusedAlerts
{
  double along_m = 0.25;              ///< protection level of x that is not OK [m]
  double across_m = 0.11;             ///< of y [m]
  double heading_rad = 0.45;          ///< of the heading, 26 deg: before any calibration [rad]
  double unnoticed_slip_m = 0.002;    ///< of it no measurement tells yet [m]
  double unseen_slip_m = 0.02;        ///< the same where nothing is in sight that could tell [m]
  double unnoticed_turn_rad = 0.006;  ///< of it no measurement tells yet [rad]
  double unseen_turn_rad = 0.1;       ///< the same where the front pair sees no riser [rad]
  double dead_s = 0.5;                ///< a sensor is silent for so long [s]
  double stuck_s = 0.5;               ///< the gyroscope is stuck after so long [s]
  double offset_m = 0.05;             ///< an offset beyond this is not trusted [m]
  double gain = 0.15;                 ///< nor is such a gain [-]
  double off_tread_m = 0.01;          ///< x off the tread by more than its level and this [m]
  double as_built_m = 0.02;           ///< a tread or width off the site file by more is told [m]
  std::int64_t reject_streak = 15;    ///< gated in a row: a sensor contradicts the others
};

/// The fused estimator's own parameters.
struct FusedParams
{
  ProcessNoise process;
  FusedPriors priors;
  FusedNoise noise;
  FusedAlerts alerts;
  StepFilterParams steps;
  double gate_false_alarm = 1e-4;  ///< share of sound measurements that a gate refuses [-]
  double window_s = 0.3;           ///< late samples are applied at their time within this [s]
  double contact_gate_m = 0.05;    ///< a contact that surprises by more is not believed [m]
  double slip_m = 0.012;           ///< a usual slip [m]
  double most_slip_m = 0.04;       ///< what shifts ranges by more within seconds is no slip [m]
  double slip_false_alarm =
    3e-4;                    ///< slips noticed for each innovation of a robot that has none [-]
  double slipping = 0.01;    ///< process.slip while a slip goes on [m/sqrt(s)]
  double hand_over_s = 0.1;  ///< in which a sensor that comes into sight moves the pose [s]
  /// Probability per step that the error of x, y or heading exceeds its protection level for longer
  /// than 1 s while the state is OK [-].
  double integrity_risk = 1e-4;
};

template <class Visitor>
void visit(FusedParams & p, Visitor && each)
{
  using stetro_config::Within;
  ProcessNoise & q = p.process;
  each("process.acceleration", q.acceleration, Within{0.0, 10.0}, "unmodelled motion [m/s/tick]");
  each("process.turn", q.turn, Within{0.0, 0.1}, "gyroscope's noise density [rad/s/sqrt(Hz)]");
  each("process.gyro_bias", q.gyro_bias, Within{0.0, 0.01}, "bias walk [rad/s/sqrt(s)]");
  each("process.odom_scale", q.odom_scale, Within{0.0, 0.01}, "scale walk [1/sqrt(s)]");
  each("process.range_offset", q.range_offset, Within{0.0, 0.01}, "offset walk [m/sqrt(s)]");
  each("process.range_gain", q.range_gain, Within{0.0, 0.01}, "gain walk [1/sqrt(s)]");
  each("process.creep", q.creep, Within{0.0, 0.1}, "position, wheels standing [m/sqrt(s)]");
  each("process.slip", q.slip, Within{0.0, 0.1}, "position along the motion [m/sqrt(s)]");
  FusedPriors & prior = p.priors;
  each("priors.range_offset_m", prior.range_offset_m, Within{1e-4, 0.1}, "uncalibrated [m]");
  each("priors.range_gain", prior.range_gain, Within{0.0, 0.2}, "of a range sensor [-]");
  each("priors.odom_scale", prior.odom_scale, Within{0.0, 0.2}, "of the wheels [-]");
  each("priors.tread_m", prior.tread_m, Within{1e-5, 0.05}, "tread against the site file [m]");
  each("priors.riser_m", prior.riser_m, Within{1e-5, 0.05}, "riser against the site file [m]");
  each(
    "priors.riser_direction_rad", prior.riser_direction_rad, Within{0.0, 0.1},
    "direction of a riser [rad]");
  each("priors.width_m", prior.width_m, Within{1e-5, 0.1}, "width against the site file [m]");
  each(
    "priors.width_change_m", prior.width_change_m, Within{0.0, 0.05},
    "width from tread to tread [m]");
  each("priors.yaw_rad", prior.yaw_rad, Within{0.01, 3.0}, "heading before a reference [rad]");
  FusedNoise & noise = p.noise;
  each("noise.wheels_mps", noise.wheels_mps, Within{1e-5, 1.0}, "of a wheel speed [m/s]");
  each("noise.blocked_mps", noise.blocked_mps, Within{1e-4, 1.0}, "against a wall [m/s]");
  each("noise.unseen_mps", noise.unseen_mps, Within{1e-3, 5.0}, "wheels are silent [m/s]");
  each("noise.gyro_radps", noise.gyro_radps, Within{1e-6, 1.0}, "of a gyroscope sample [rad/s]");
  each("noise.bumper_m", noise.bumper_m, Within{1e-4, 0.05}, "where a bumper closes [m]");
  each("noise.riser_switch_m", noise.riser_switch_m, Within{1e-5, 0.05}, "where one closes [m]");
  each("noise.clipped_share", noise.clipped_share, Within{0.0, 1.0}, "cone beyond the riser [-]");
  visit_step_filter(p.steps, stetro_config::Group("steps", each));
  FusedAlerts & alert = p.alerts;
  each("alerts.along_m", alert.along_m, Within{0.001, 1.0}, "protection level along [m]");
  each("alerts.across_m", alert.across_m, Within{0.001, 1.0}, "protection level across [m]");
  each("alerts.heading_rad", alert.heading_rad, Within{0.001, 1.0}, "and of the heading [rad]");
  each(
    "alerts.unnoticed_slip_m", alert.unnoticed_slip_m, Within{0.0, 0.1},
    "what a slip does before it is noticed [m]");
  each(
    "alerts.unseen_slip_m", alert.unseen_slip_m, Within{0.0, 0.2},
    "a whole slip, where nothing in sight could tell [m]");
  each(
    "alerts.unnoticed_turn_rad", alert.unnoticed_turn_rad, Within{0.0, 0.5},
    "what the gyroscope's bias does before it is noticed [rad]");
  each(
    "alerts.unseen_turn_rad", alert.unseen_turn_rad, Within{0.0, 0.5},
    "the same where the front pair sees no riser [rad]");
  each("alerts.dead_s", alert.dead_s, Within{0.05, 10.0}, "a silent sensor is dead after [s]");
  each(
    "alerts.stuck_s", alert.stuck_s, Within{0.05, 10.0},
    "the gyroscope repeats itself in motion: stuck after [s]");
  each("alerts.offset_m", alert.offset_m, Within{0.001, 0.5}, "larger offset is not trusted [m]");
  each("alerts.gain", alert.gain, Within{0.001, 1.0}, "larger gain error is not trusted [-]");
  each(
    "alerts.off_tread_m", alert.off_tread_m, Within{0.0, 0.2},
    "x off the tread by this beyond its protection level [m]");
  each(
    "alerts.as_built_m", alert.as_built_m, Within{0.001, 0.5},
    "a tread or width off the site file by more is reported [m]");
  each(
    "alerts.reject_streak", alert.reject_streak, Within{2, 1000},
    "gated in a row: a sensor contradicts the others");
  each(
    "gate_false_alarm", p.gate_false_alarm, Within{1e-9, 0.1},
    "share of sound measurements that a gate refuses");
  each("window_s", p.window_s, Within{0.0, 0.5}, "late samples are used within this [s]");
  each(
    "contact_gate_m", p.contact_gate_m, Within{0.001, 0.5},
    "a contact that surprises by more is not believed [m]");
  each("slip_m", p.slip_m, Within{0.001, 0.2}, "a usual slip [m]");
  each("most_slip_m", p.most_slip_m, Within{0.001, 1.0}, "what shifts by more is no slip [m]");
  each(
    "slip_false_alarm", p.slip_false_alarm, Within{1e-9, 0.1},
    "slips noticed for each innovation of a robot that has none");
  each("slipping", p.slipping, Within{0.0, 1.0}, "process.slip while one goes on [m/sqrt(s)]");
  each(
    "hand_over_s", p.hand_over_s, Within{0.0, 5.0},
    "a sensor that comes into sight moves the published pose over such a time [s]");
  each(
    "integrity_risk", p.integrity_risk, Within{1e-9, 0.1},
    "probability per step that the error of x, y or heading exceeds its protection level for "
    "longer than 1 s while the state is OK");
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__FUSED_PARAMS_HPP_
