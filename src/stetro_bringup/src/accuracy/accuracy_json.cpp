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

#include <algorithm>
#include <cmath>

#include "accuracy/accuracy_report.hpp"
#include "accuracy/proportion.hpp"
#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr char kSampling[] =
  "each new estimate while the robot sweeps or climbs, against the truth of its own stamp, from "
  "the "
  "end of the first tread on; without those between a touch-down and its being counted";

// JSON has no NaN: what is not known is null.
Json known(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double share_of(std::uint64_t part, std::uint64_t whole)
{
  return whole == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(whole);
}

/// A count out of so many, and what it says of the rate behind it.
Json rate(std::uint64_t count, std::uint64_t of)
{
  const Interval bounds = clopper_pearson(count, of);
  return {
    {"count", count},
    {"of", of},
    {"share", known(share_of(count, of))},
    {"low_95", bounds.low},
    {"high_95", bounds.high}};
}

Json figures(const ErrorDistribution & errors, const std::string & unit)
{
  return {
    {"rmse_" + unit, known(errors.rmse())},
    {"mean_" + unit, known(errors.mean())},
    {"std_" + unit, known(errors.standard_deviation())},
    {"p95_" + unit, known(errors.percentile(0.95))},
    {"p999_" + unit, known(errors.percentile(0.999))},
    {"max_" + unit, known(errors.max())}};
}

void put(Json & to, const ErrorGroup & errors)
{
  to["samples"] = errors.y_m.count();
  to["x"] = figures(errors.x_m, "m");
  to["x_behind"] = figures(errors.x_behind_m, "m");
  to["y"] = figures(errors.y_m, "m");
  to["z"] = figures(errors.z_m, "m");
  to["heading"] = figures(errors.heading_rad, "rad");
  to["heading_to_riser"] = figures(errors.heading_to_riser_rad, "rad");
}

Json nees_json(const NeesTally & nees)
{
  const double known_count = static_cast<double>(nees.known());
  return {
    {"inside_95", known(nees.inside_share())},
    {"above", known(static_cast<double>(nees.above) / known_count)},
    {"below", known(static_cast<double>(nees.below) / known_count)},
    {"mean", known(nees.mean())},
    {"samples", nees.known()},
    {"unknown", nees.unknown}};
}

Json closure_json(const ErrorDistribution & closure)
{
  return {
    {"mean_m", known(closure.mean())},
    {"std_m", known(closure.standard_deviation())},
    {"max_m", known(closure.max())},
    {"treads", closure.count()}};
}

Json integrity_json(const EstimatorTotals & totals)
{
  const ClimbScore & counts = totals.counts;
  const std::uint64_t ticks = counts.ticks_ok + counts.ticks_degraded + counts.ticks_lost;
  return {
    {"ok_share", known(share_of(counts.ticks_ok, ticks))},
    {"degraded_share", known(share_of(counts.ticks_degraded, ticks))},
    {"lost_share", known(share_of(counts.ticks_lost, ticks))},
    {"watched_s", 0.01 * static_cast<double>(ticks)},
    {"resets", counts.resets},
    {"treads_not_always_ok", rate(counts.treads_alarmed, counts.treads)},
    {"treads_beyond_protection_while_ok", rate(counts.treads_exceeded, counts.treads)},
    {"longest_beyond_protection_while_ok_s", totals.longest_exceedance_s},
    {"climbs_beyond_protection_for_1_s", rate(totals.exceeded_climbs, totals.climbs)},
    {"estimates_without_value", counts.without_value},
    {"estimates_without_truth", counts.out_of_truth}};
}

Json protection_json(const EstimatorTotals & totals)
{
  return {
    {"along_median_m", known(totals.protection_along_m.percentile(0.5))},
    {"across_median_m", known(totals.protection_across_m.percentile(0.5))},
    {"heading_median_rad", known(totals.protection_heading_rad.percentile(0.5))},
    {"samples", totals.protection_across_m.count()}};
}

Json step_errors_json(const EstimatorTotals & totals)
{
  const ClimbScore & counts = totals.counts;
  return {
    {"checks", counts.step_checks},
    {"wrong", rate(counts.wrong_steps, counts.step_checks)},
    {"undetected", rate(counts.undetected_steps, counts.step_checks)}};
}

Json treads_json(const EstimatorTotals & totals)
{
  Json treads = Json::array();
  for (std::size_t step = 1; step < totals.treads.size(); ++step) {
    const TreadTotals & tread = totals.treads[step];
    treads.push_back(
      {{"step", step},
       {"samples", tread.y_m.count()},
       {"x_rmse_m", known(tread.x_m.rmse())},
       {"y_rmse_m", known(tread.y_m.rmse())},
       {"heading_rmse_rad", known(tread.heading_rad.rmse())},
       {"x_sigma_m", known(tread.sigma_x_m.rms())},
       {"y_sigma_m", known(tread.sigma_y_m.rms())},
       {"heading_sigma_rad", known(tread.sigma_heading_rad.rms())},
       {"nees_inside_95", known(tread.nees.inside_share())}});
  }
  return treads;
}

double ranked(std::vector<double> values, double share)
{
  if (values.empty()) {
    return std::nan("");
  }
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

Json times_json(const std::vector<Detection> & detections, double Detection::*time)
{
  std::vector<double> times;
  for (const Detection & detection : detections) {
    if (detection.detected) {
      times.push_back(detection.*time);
    }
  }
  return {
    {"median_s", known(ranked(times, 0.5))},
    {"p95_s", known(ranked(times, 0.95))},
    {"max_s", known(ranked(times, 1.0))}};
}

Json detection_json(const EstimatorTotals & totals)
{
  const auto & all = totals.detections;
  const auto missed = static_cast<std::uint64_t>(
    std::count_if(all.begin(), all.end(), [](const Detection & d) { return !d.detected; }));
  const auto in_time = static_cast<std::uint64_t>(std::count_if(
    all.begin(), all.end(), [](const Detection & d) { return d.detected && d.motion_s <= 1.0; }));
  const auto in_telling_time =
    static_cast<std::uint64_t>(std::count_if(all.begin(), all.end(), [](const Detection & d) {
      return d.detected && d.telling_motion_s <= 1.0;
    }));
  Json json{
    {"struck", all.size()},
    {"missed", rate(missed, all.size())},
    {"within_1_s_of_motion", rate(in_time, all.size())},
    {"within_1_s_of_telling_motion", rate(in_telling_time, all.size())},
    {"time", times_json(all, &Detection::time_s)},
    {"motion", times_json(all, &Detection::motion_s)},
    {"telling_motion", times_json(all, &Detection::telling_motion_s)}};
  put(json["errors_after_onset"], totals.after_onset);
  return json;
}

Json estimator_json(const EstimatorTotals & totals)
{
  Json json;
  put(json, totals.errors);
  json["handover_jump_p999_m"] = known(totals.hand_over_m.percentile(0.999));
  json["handover_jump"] = {
    {"count", totals.hand_over_m.count()},
    {"x", figures(totals.hand_over_x_m, "m")},
    {"y", figures(totals.hand_over_y_m, "m")}};
  json["nees_inside_95"] = known(totals.nees.inside_share());
  json["nees"] = {
    {"all", nees_json(totals.nees)},
    {"with_front_reference", nees_json(totals.nees_with_reference)},
    {"without_front_reference", nees_json(totals.nees_without_reference)}};
  json["undetected_step_errors"] = totals.counts.undetected_steps;
  json["step_errors"] = step_errors_json(totals);
  json["closure_error"] = closure_json(totals.closure_m);
  json["integrity"] = integrity_json(totals);
  json["protection"] = protection_json(totals);
  json["touch_down_confirmation"] = {
    {"estimates_left_out", totals.confirming}, {"longest_s", totals.longest_confirmation_s}};
  put(json["first_tread"], totals.first_tread);
  json["first_tread"]["closure_error"] = closure_json(totals.first_closure_m);
  json["flight_frame"] = {
    {"x", figures(totals.flight_x_m, "m")},
    {"y", figures(totals.errors.y_m, "m")},
    {"z", figures(totals.flight_z_m, "m")},
    {"heading", figures(totals.errors.heading_rad, "rad")}};
  json["treads"] = treads_json(totals);
  if (totals.after_onset.y_m.count() > 0) {
    json["detection"] = detection_json(totals);
  }
  return json;
}

Json climbs_json(const ScenarioTotals & totals)
{
  Json unfinished = Json::array();
  for (const Unfinished & climb : totals.unfinished) {
    unfinished.push_back(
      {{"seed", climb.seed},
       {"end", to_string(climb.end)},
       {"detail", climb.detail},
       {"step", climb.last_step},
       {"faults", climb.faults}});
  }
  return {
    {"made", totals.climbs},
    {"finished", totals.finished},
    {"steps_climbed", totals.steps_climbed},
    {"simulated_s", totals.simulated_s},
    {"unfinished", unfinished}};
}

void put(Json & to, const ScenarioTotals & totals, const std::vector<std::string> & estimators)
{
  to["climbs"] = climbs_json(totals);
  for (std::size_t i = 0; i < estimators.size(); ++i) {
    to[estimators[i]] = estimator_json(totals.estimators[i]);
  }
}

}  // namespace

std::string summary_json(const AccuracyReport & report)
{
  Json json{
    {"runs", report.runs},
    {"first_seed", report.first_seed},
    {"world", report.world},
    {"calibration", report.calibration},
    {"flight", report.flight},
    {"steps", report.steps},
    {"estimators", report.estimators},
    {"driving", report.estimators.front()},
    {"sampling", kSampling}};
  put(json, report.overall, report.estimators);
  for (const ScenarioTotals & scenario : report.scenarios) {
    put(json["faults"][scenario.name], scenario, report.estimators);
  }
  return json.dump(2) + "\n";
}

}  // namespace stetro_bringup
