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

#ifndef STETRO_LOCALIZER__PARAMS_HPP_
#define STETRO_LOCALIZER__PARAMS_HPP_

#include <cstdint>
#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_localizer/carried_average.hpp"
#include "stetro_localizer/floor/floor_params.hpp"
#include "stetro_localizer/fused/fused_params.hpp"
#include "stetro_localizer/gyro_heading.hpp"
#include "stetro_localizer/measurement/tof_noise.hpp"
#include "stetro_localizer/standstill.hpp"
#include "stetro_localizer/step_counter.hpp"

namespace stetro_localizer
{

/// Window of a moving average.
struct AverageParams
{
  std::int64_t window = 6;       ///< readings at most
  std::int64_t least_count = 3;  ///< readings at least
  double max_age_s = 0.25;       ///< an older reading leaves the window [s]
};

/// Side ranges, bumpers and y.
struct LateralParams
{
  TofSystematics systematic;
  AverageParams average{6, 3, 0.25};
  double hysteresis_m = 0.05;      ///< below the reliable range a side is taken again [m]
  double gate_sigma = 4.0;         ///< innovation gate [standard deviations]
  std::int64_t reject_limit = 10;  ///< rejected in a row, after which y is measured anew
  double offset_limit_m = 0.05;    ///< a larger offset is not believed [m]
  double offset_walk_m = 0.001;    ///< growth of the offset's doubt from contact to contact [m]
  double bumper_sigma_m = 0.001;   ///< closing distance of a bumper [m]
  double contact_gate_m = 0.10;  ///< a bumper that closes further from its wall is not believed [m]
  double width_sigma_m = 0.0025;  ///< of the staircase's width against the site file [m]
  double odometry_scale = 0.03;   ///< error of the wheels by distance [m/m]
};

/// Front pair, riser switches and heading.
struct HeadingParams
{
  TofSystematics systematic;
  AverageParams average{15, 5, 0.6};
  double gate_sigma = 4.0;            ///< innovation gate [standard deviations]
  double gate_floor_rad = 0.0175;     ///< doubt of the prediction that no model gives [rad]
  std::int64_t reject_limit = 15;     ///< rejected in a row, after which the heading starts anew
  double max_incidence_rad = 0.61;    ///< flatter readings are no heading [rad]
  double nosing_margin_m = 0.015;     ///< beams closer to a nosing are not used [m]
  double wall_margin_m = 0.010;       ///< cones closer to a side wall are not used [m]
  double switch_sigma_rad = 0.0044;   ///< heading at both riser switches closed [rad]
  double switch_gate_rad = 0.175;     ///< both switches at a larger heading contradict it [rad]
  double initial_sigma_rad = 0.175;   ///< before the first reference [rad]
  double restart_sigma_rad = 0.0524;  ///< after a restart on the stairs: it was kept aligned [rad]
  double sigma_limit_rad = 0.0873;    ///< more doubt without a reference is DEGRADED [rad]
};

/// Everything the localizer lets a person set. Defaults climb the papers' staircase.
struct LocalizerParams
{
  std::string site_file;
  std::string robot_file;
  std::string estimator = "fused";
  std::string flight;  ///< id; empty: the only one of the site, or the first if floors are drawn
  std::string state_file;         ///< step and calibration are kept there; empty: nowhere
  std::int64_t initial_step = 0;  ///< without a state file; -1: unknown until told
  /// Where a robot without a state file is, if the site's floors are drawn; empty: unknown.
  std::string initial_segment;
  double future_tolerance_s = 0.02;
  double max_sample_age_s = 0.3;
  double silence_s = 0.5;
  double rise_sigma_m = 0.0015;  ///< of each riser against the site file [m]
  LateralParams lateral;
  HeadingParams heading;
  GyroParams gyro;
  StandstillParams standstill;
  StepCounterParams steps;
  FusedParams fused;
  FloorParams floor;
};

template <class Visitor>
void visit_systematic(TofSystematics & p, Visitor && each)
{
  using stetro_config::Within;
  each("slow_m", p.slow_m, Within{0.0, 0.05}, "drift that averaging leaves [m]");
  each("gain_sigma", p.gain_sigma, Within{0.0, 0.2}, "standard deviation of the gain [-]");
  each("offset_sigma", p.offset_sigma, Within{1e-4, 0.1}, "offset before any calibration [m]");
}

template <class Visitor>
void visit_average(AverageParams & p, Visitor && each)
{
  using stetro_config::Within;
  each("window", p.window, Within{1, 64}, "readings in the moving average at most");
  each("least_count", p.least_count, Within{1, 64}, "readings that make an average at least");
  each("max_age_s", p.max_age_s, Within{0.01, 10.0}, "an older reading leaves the window [s]");
}

template <class Visitor>
void visit_lateral(LateralParams & p, Visitor && each)
{
  using stetro_config::Group;
  using stetro_config::Within;
  visit_systematic(p.systematic, Group("systematic", each));
  visit_average(p.average, Group("average", each));
  each(
    "hysteresis_m", p.hysteresis_m, Within{0.0, 0.5},
    "a side range is taken again this much below the reliable range [m]");
  each("gate_sigma", p.gate_sigma, Within{1.0, 20.0}, "gate [standard deviations]");
  each(
    "reject_limit", p.reject_limit, Within{1, 1000}, "rejected in a row before y is measured anew");
  each("offset_limit_m", p.offset_limit_m, Within{0.001, 0.5}, "larger offsets are refused [m]");
  each("offset_walk_m", p.offset_walk_m, Within{0.0, 0.05}, "offset drift between contacts [m]");
  each("bumper_sigma_m", p.bumper_sigma_m, Within{1e-4, 0.05}, "closing distance of a bumper [m]");
  each(
    "contact_gate_m", p.contact_gate_m, Within{0.005, 1.0},
    "a bumper that closes further from its wall is refused [m]");
  each("width_sigma_m", p.width_sigma_m, Within{0.0, 0.1}, "width against the site file [m]");
  each("odometry_scale", p.odometry_scale, Within{0.0, 0.5}, "wheel error by distance [m/m]");
}

template <class Visitor>
void visit_heading(HeadingParams & p, Visitor && each)
{
  using stetro_config::Group;
  using stetro_config::Within;
  visit_systematic(p.systematic, Group("systematic", each));
  visit_average(p.average, Group("average", each));
  each("gate_sigma", p.gate_sigma, Within{1.0, 20.0}, "gate [standard deviations]");
  each("gate_floor_rad", p.gate_floor_rad, Within{0.0, 0.5}, "least doubt of a prediction [rad]");
  each(
    "reject_limit", p.reject_limit, Within{1, 1000},
    "rejected in a row before the heading starts anew");
  each("max_incidence_rad", p.max_incidence_rad, Within{0.05, 1.5}, "flatter is no heading [rad]");
  each(
    "nosing_margin_m", p.nosing_margin_m, Within{0.0, 0.1},
    "front beams closer to a nosing are not used [m]");
  each(
    "wall_margin_m", p.wall_margin_m, Within{0.0, 0.2},
    "front beams whose cone comes closer to a side wall are not used [m]");
  each("switch_sigma_rad", p.switch_sigma_rad, Within{1e-4, 0.5}, "both switches closed [rad]");
  each(
    "switch_gate_rad", p.switch_gate_rad, Within{0.01, 1.5},
    "switches that close at a larger heading are refused [rad]");
  each("initial_sigma_rad", p.initial_sigma_rad, Within{0.01, 3.0}, "before a reference [rad]");
  each("restart_sigma_rad", p.restart_sigma_rad, Within{0.001, 3.0}, "after a restart [rad]");
  each(
    "sigma_limit_rad", p.sigma_limit_rad, Within{0.001, 1.0},
    "more doubt without a reference is DEGRADED [rad]");
}

template <class Visitor>
void visit_steps(StepCounterParams & p, Visitor && each)
{
  using stetro_config::Within;
  each(
    "bearing_load", p.bearing_load, Within{0.001, 0.5}, "share of the weight of a standing block");
  each("tolerance_share", p.tolerance_share, Within{0.05, 0.45}, "same height, of the riser [-]");
  each("settle_samples", p.settle_samples, Within{1, 100}, "samples that make a touch-down");
  each(
    "down_tolerance_m", p.down_tolerance_m, Within{0.001, 0.1},
    "block2_down beyond its contact reading [m]");
  each("conflict_s", p.conflict_s, Within{0.1, 60.0}, "contradiction that is reported [s]");
}

/// The one list: it loads, bounds, prints and documents the parameters.
template <class Visitor>
void visit(LocalizerParams & p, Visitor && each)
{
  using stetro_config::Any;
  using stetro_config::Group;
  using stetro_config::NonEmpty;
  using stetro_config::OneOf;
  using stetro_config::Within;
  each("site_file", p.site_file, NonEmpty{}, "flights and floors of the building");
  each("robot_file", p.robot_file, NonEmpty{}, "body and sensors");
  each("estimator", p.estimator, OneOf{"fused", "paper"}, "method that estimates the pose");
  each(
    "flight", p.flight, Any{},
    "id of the flight; empty: the only one, or the first if floors are drawn");
  each("state_file", p.state_file, Any{}, "keeps step and calibration; empty: nothing is kept");
  each(
    "initial_step", p.initial_step, Within{-1, 200},
    "step of a robot without a state file; 0 asks for level blocks; -1: unknown until told");
  each(
    "initial_segment", p.initial_segment, Any{},
    "id of the floor or flight of a robot without a state file, where floors are drawn; empty: "
    "unknown until told or corrected");
  each("future_tolerance_s", p.future_tolerance_s, Within{0.0, 1.0}, "stamp ahead of now [s]");
  each("max_sample_age_s", p.max_sample_age_s, Within{0.01, 10.0}, "older samples are refused [s]");
  each("silence_s", p.silence_s, Within{0.1, 60.0}, "input without samples is silent [s]");
  each("rise_sigma_m", p.rise_sigma_m, Within{0.0, 0.05}, "riser against the site file [m]");
  visit_lateral(p.lateral, Group("lateral", each));
  visit_heading(p.heading, Group("heading", each));
  each("gyro.white_radps", p.gyro.white_radps, Within{1e-6, 1.0}, "noise of a sample [rad/s]");
  each(
    "gyro.bias_sigma_radps", p.gyro.bias_sigma_radps, Within{1e-6, 1.0},
    "bias before it is learned [rad/s]");
  each("gyro.bias_walk", p.gyro.bias_walk, Within{0.0, 0.1}, "random walk of it [rad/s/sqrt(s)]");
  each(
    "gyro.still_limit_radps", p.gyro.still_limit_radps, Within{0.001, 1.0},
    "a faster turn is not learned as bias [rad/s]");
  each("gyro.longest_gap_s", p.gyro.longest_gap_s, Within{0.01, 10.0}, "bridged silence [s]");
  each(
    "gyro.gap_rate_radps", p.gyro.gap_rate_radps, Within{0.0, 10.0},
    "turn assumed possible in a longer one [rad/s]");
  each("standstill.speed_mps", p.standstill.speed_mps, Within{0.0, 0.1}, "slower may stand [m/s]");
  each(
    "standstill.rate_radps", p.standstill.rate_radps, Within{0.0, 0.5}, "slower may stand [rad/s]");
  each("standstill.settle_s", p.standstill.settle_s, Within{0.0, 10.0}, "both must last [s]");
  visit_steps(p.steps, Group("steps", each));
  visit(p.fused, Group("fused", each));
  visit(p.floor, Group("floor", each));
}

/// An empty window of that kind.
[[nodiscard]] inline CarriedAverage window_of(const AverageParams & params)
{
  return {
    static_cast<std::size_t>(params.window), static_cast<std::size_t>(params.least_count),
    nanoseconds(params.max_age_s)};
}

/// What contradicts each other although each value is in its bounds.
void check(const LocalizerParams & params, stetro_config::Faults & faults);

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__PARAMS_HPP_
