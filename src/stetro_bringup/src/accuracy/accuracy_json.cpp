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
#include "accuracy/json_figures.hpp"
#include "accuracy/noticing.hpp"
#include "accuracy/proportion.hpp"
#include "accuracy/risk_shown.hpp"

namespace stetro_bringup
{
namespace
{

constexpr char kSampling[] =
  "each new estimate while the robot sweeps or climbs, against the truth of its own stamp, from "
  "the "
  "end of the first tread on; without those between a touch-down and its being counted";

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

Json sigma_json(const SigmaTally & tally)
{
  return {
    {"inside_95", known(tally.inside_95())},
    {"mean_square", known(tally.mean_square())},
    {"samples", tally.count()}};
}

Json measure_json(const MeasureTotals & totals)
{
  return {
    {"found", figures(totals.found_m, "m")},
    {"site_file", figures(totals.site_m, "m")},
    {"sigma", sigma_json(totals.sigmas)}};
}

Json closure_json(const ErrorDistribution & closure)
{
  return {
    {"mean_m", known(closure.mean())},
    {"std_m", known(closure.standard_deviation())},
    {"max_m", known(closure.max())},
    {"treads", closure.count()}};
}

Json risk_json(const EstimatorTotals & totals)
{
  const RiskShown risk = risk_shown(totals);
  return {
    {"stated", known(risk.stated)},
    {"times", risk.times},
    {"steps", risk.steps},
    {"at_most_95", known(risk.at_most_95)},
    {"clean_steps_needed", known(risk.clean_steps_needed)},
    {"carried", risk.carried()}};
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
    {"treads_beyond_protection_while_ok", times_a_step(counts.treads_exceeded, counts.treads)},
    {"treads_beyond_protection_for_1_s", times_a_step(counts.treads_misled, counts.treads)},
    {"longest_beyond_protection_while_ok_s", totals.longest_exceedance_s},
    {"climbs_beyond_protection_for_1_s", rate(totals.exceeded_climbs, totals.climbs)},
    {"risk", risk_json(totals)},
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

Json miscounts_json(const std::vector<Miscount> & miscounts)
{
  const MiscountNoticing all = noticing_of(miscounts);
  return {
    {"began", all.began},
    {"noticed_before_next_climb", rate(all.before_next_climb, all.began)},
    {"noticed_within_one_step", rate(all.within_one_step, all.began)},
    {"noticed_by_climbs_begun", all.by_climbs},
    {"corrected_unnoticed", all.corrected},
    {"never_noticed", all.unnoticed}};
}

Json step_errors_json(const StepTally & steps)
{
  return {
    {"checks", steps.checks},
    {"wrong", rate(steps.wrong, steps.checks)},
    {"undetected", rate(steps.undetected, steps.checks)},
    {"miscounts", miscounts_json(steps.miscounts)}};
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
  const FaultNoticing noticing = noticing_of(all);
  Json json{
    {"struck", noticing.struck + totals.never_ok},
    {"never_ok_again", totals.never_ok},
    {"missed", rate(noticing.missed, noticing.struck)},
    {"within_1_s_of_motion", rate(noticing.in_time, noticing.struck)},
    {"within_1_s_of_telling_motion", rate(noticing.in_telling_time, noticing.struck)},
    {"time", times_json(all, &Detection::time_s)},
    {"motion", times_json(all, &Detection::motion_s)},
    {"telling_motion", times_json(all, &Detection::telling_motion_s)}};
  put(json["errors_after_onset"], totals.after_onset);
  return json;
}

Json estimator_json(const EstimatorTotals & totals, bool fault_free)
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
  json["undetected_step_errors"] = totals.counts.steps.undetected;
  json["step_errors"] = step_errors_json(totals.counts.steps);
  if (fault_free) {
    json["false_alarms"] = times_a_step(totals.counts.alarms, totals.counts.steps.on_stairs);
  }
  json["closure_error"] = closure_json(totals.closure_m);
  json["integrity"] = integrity_json(totals);
  json["protection"] = protection_json(totals);
  json["touch_down_confirmation"] = {
    {"estimates_left_out", totals.confirming}, {"longest_s", totals.longest_confirmation_s}};
  put(json["first_tread"], totals.first_tread);
  json["first_tread"]["closure_error"] = closure_json(totals.first_closure_m);
  json["flight_frame"] = {{"x", figures(totals.flight_x_m, "m")},
                          {"y", figures(totals.errors.y_m, "m")},
                          {"z", figures(totals.flight_z_m, "m")},
                          {"heading", figures(totals.errors.heading_rad, "rad")},
                          {"x_sigma", sigma_json(totals.flight_x)},
                          {"z_sigma", sigma_json(totals.flight_z)}};
  json["staircase_as_built"] = {
    {"tread", measure_json(totals.tread_depths)},
    {"width", measure_json(totals.widths)},
    {"deviations_reported", totals.deviations_reported}};
  json["treads"] = treads_json(totals);
  if (totals.never_ok > 0 || !totals.detections.empty()) {
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

void put(Json & to, const ScenarioTotals & totals, const AccuracyReport & report)
{
  const bool fault_free = report.scenarios.empty();
  to["climbs"] = climbs_json(totals);
  for (std::size_t i = 0; i < report.estimators.size(); ++i) {
    to[report.estimators[i]] = estimator_json(totals.estimators[i], fault_free);
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
  put(json, report.overall, report);
  for (const ScenarioTotals & scenario : report.scenarios) {
    put(json["faults"][scenario.name], scenario, report);
  }
  return json.dump(2) + "\n";
}

}  // namespace stetro_bringup
