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

#ifndef STETRO_LOCALIZER__FLOOR__FLOOR_PARAMS_HPP_
#define STETRO_LOCALIZER__FLOOR__FLOOR_PARAMS_HPP_

#include <cstdint>

#include "stetro_config/rule.hpp"

namespace stetro_localizer
{

/// How fast each state on a floor wanders: square roots of spectral densities.
struct FloorNoise
{
  double turn = 2e-4;        ///< of the gyroscope's reading [rad/s/sqrt(Hz)]
  double blind_turn = 0.1;   ///< the same without a gyroscope, by the wheels [rad/s/sqrt(Hz)]
  double gyro_bias = 1e-5;   ///< [rad/s/sqrt(s)]
  double odom_scale = 1e-5;  ///< [1/sqrt(s)]
  double slip = 3e-3;        ///< position along the motion: 5 to 20 mm once in 20 s [m/sqrt(s)]
  double across = 5e-4;      ///< position across it [m/sqrt(s)]
  double blocked = 0.02;     ///< along the motion of a robot that pushes a wall [m/sqrt(s)]
};

/// What is not OK on a floor.
struct FloorAlerts
{
  double along_m = 0.3;             ///< protection level of the position [m]
  double heading_rad = 0.15;        ///< of the heading [rad]
  double unseen_slip_m = 0.02;      ///< a whole slip, which nothing on a floor tells at once [m]
  double unseen_turn_rad = 0.01;    ///< what the heading may have turned by unseen [rad]
  double turn_conflict_rad = 0.15;  ///< wheels and gyroscope differ by more within seconds [rad]
};

/// The filter on floors, and where it takes over from a flight's estimator and hands over to it.
struct FloorParams
{
  FloorNoise noise;
  FloorAlerts alerts;
  double window_s = 2.0;                ///< corrections are applied at their time within this [s]
  double gate_false_alarm = 1e-4;       ///< share of sound corrections that the gate refuses [-]
  double correction_sigma_m = 0.01;     ///< what several corrections have wrong alike [m]
  double correction_sigma_rad = 0.005;  ///< the same of the heading [rad]
  std::int64_t lost_streak = 3;         ///< refused in a row, agreeing with each other: LOST
  double reset_sigma_m = 0.3;           ///< two corrections must tell the position so well [m]
  double reset_sigma_rad = 0.15;        ///< and the heading [rad]
  double approach_m = 1.0;              ///< before a flight, its estimator takes over [m]
  double wall_margin_m = 0.15;          ///< and so far from its sides [m]
  double approach_yaw_rad = 0.436;      ///< and facing it within this, 25 deg [rad]
  double approach_sigma_m = 0.1;        ///< and the position known so well [m]
  double retreat_m = 0.3;          ///< further back than `approach_m` it is the floor again [m]
  double retreat_yaw_rad = 0.698;  ///< and when turned away further, 40 deg [rad]
  double top_m = 0.05;             ///< before the end of the last tread the floor begins [m]
};

template <class Visitor>
void visit(FloorParams & p, Visitor && each)
{
  using stetro_config::Within;
  FloorNoise & q = p.noise;
  each("noise.turn", q.turn, Within{0.0, 0.1}, "gyroscope's noise density [rad/s/sqrt(Hz)]");
  each("noise.blind_turn", q.blind_turn, Within{0.0, 10.0}, "without it [rad/s/sqrt(Hz)]");
  each("noise.gyro_bias", q.gyro_bias, Within{0.0, 0.01}, "bias walk [rad/s/sqrt(s)]");
  each("noise.odom_scale", q.odom_scale, Within{0.0, 0.01}, "scale walk [1/sqrt(s)]");
  each("noise.slip", q.slip, Within{0.0, 0.1}, "position along the motion [m/sqrt(s)]");
  each("noise.across", q.across, Within{0.0, 0.1}, "position across it [m/sqrt(s)]");
  each("noise.blocked", q.blocked, Within{0.0, 1.0}, "along it, against a wall [m/sqrt(s)]");
  FloorAlerts & alert = p.alerts;
  each("alert_along_m", alert.along_m, Within{0.01, 5.0}, "protection level of the position [m]");
  each("alert_heading_rad", alert.heading_rad, Within{0.01, 1.5}, "of the heading [rad]");
  each("unseen_slip_m", alert.unseen_slip_m, Within{0.0, 0.5}, "a slip that nothing tells [m]");
  each("unseen_turn_rad", alert.unseen_turn_rad, Within{0.0, 0.5}, "a turn of that kind [rad]");
  each(
    "turn_conflict_rad", alert.turn_conflict_rad, Within{0.01, 3.0},
    "wheels and gyroscope contradict each other by more [rad]");
  each("window_s", p.window_s, Within{0.1, 4.0}, "corrections are used at their time within [s]");
  each(
    "gate_false_alarm", p.gate_false_alarm, Within{1e-9, 0.1},
    "share of sound corrections that the gate refuses");
  each(
    "correction_sigma_m", p.correction_sigma_m, Within{0.0, 0.5},
    "what corrections have wrong alike [m]");
  each("correction_sigma_rad", p.correction_sigma_rad, Within{0.0, 0.5}, "of the heading [rad]");
  each(
    "lost_streak", p.lost_streak, Within{2, 100},
    "corrections refused in a row that agree with each other: LOST");
  each(
    "reset_sigma_m", p.reset_sigma_m, Within{0.01, 5.0},
    "two corrections that reset the pose tell the position so well [m]");
  each("reset_sigma_rad", p.reset_sigma_rad, Within{0.01, 3.0}, "and the heading [rad]");
  each("approach_m", p.approach_m, Within{0.3, 5.0}, "a flight begins so far before it [m]");
  each("wall_margin_m", p.wall_margin_m, Within{0.0, 1.0}, "and so far from its sides [m]");
  each("approach_yaw_rad", p.approach_yaw_rad, Within{0.05, 0.6}, "facing it within [rad]");
  each("approach_sigma_m", p.approach_sigma_m, Within{0.01, 1.0}, "position known so well [m]");
  each("retreat_m", p.retreat_m, Within{0.05, 5.0}, "further back it is the floor again [m]");
  each("retreat_yaw_rad", p.retreat_yaw_rad, Within{0.1, 1.5}, "turned away further, too [rad]");
  each("top_m", p.top_m, Within{0.0, 0.3}, "the floor begins before the end of the tread [m]");
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FLOOR__FLOOR_PARAMS_HPP_
