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

#include <array>
#include <cmath>
#include <cstdio>

#include "accuracy/accuracy_report.hpp"
#include "accuracy/error_rows.hpp"
#include "accuracy/noticing.hpp"
#include "accuracy/proportion.hpp"
#include "accuracy/risk_shown.hpp"

namespace stetro_bringup
{
namespace
{

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;

template <class... Values>
std::string line(const char * format, Values... values)
{
  std::array<char, 240> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

double percent(std::uint64_t part, std::uint64_t whole) { return 100.0 * share_of(part, whole); }

std::string error_table(const EstimatorTotals & totals)
{
  std::string text = line(
    "  %-18s %9s %9s %9s %9s %9s %9s\n", "error", "rms", "mean", "std", "95 %", "99.9 %", "max");
  for (const ErrorRow & row : error_rows(totals)) {
    text += line(
      "  %-18s %9.2f %9.2f %9.2f %9.2f %9.2f %9.2f  %s\n", row.name, row.scale * row.errors.rmse(),
      row.scale * row.errors.mean(), row.scale * row.errors.standard_deviation(),
      row.scale * row.errors.percentile(0.95), row.scale * row.errors.percentile(0.999),
      row.scale * row.errors.max(), row.unit);
  }
  return text;
}

std::string step_rows(const StepTally & steps)
{
  const Interval bounds = clopper_pearson(steps.undetected, steps.checks);
  std::string text = line(
    "  step wrong before a climb: %.0f of %.0f, unnoticed %.0f (95 %%: %.1e to %.1e a step)\n",
    static_cast<double>(steps.wrong), static_cast<double>(steps.checks),
    static_cast<double>(steps.undetected), bounds.low, bounds.high);
  const MiscountNoticing miscounts = noticing_of(steps.miscounts);
  if (miscounts.began > 0) {
    text += line(
      "  miscounts: %.0f; noticed before the next climb %.0f, within one step %.0f; corrected "
      "unnoticed %.0f, never noticed %.0f\n",
      static_cast<double>(miscounts.began), static_cast<double>(miscounts.before_next_climb),
      static_cast<double>(miscounts.within_one_step), static_cast<double>(miscounts.corrected),
      static_cast<double>(miscounts.unnoticed));
  }
  return text;
}

std::string staircase_row(const EstimatorTotals & totals)
{
  const MeasureTotals & treads = totals.tread_depths;
  const MeasureTotals & widths = totals.widths;
  return line(
    "  staircase as built: tread %.2f mm rms (site file %.2f), inside 95 %%: %.1f %%; width %.2f "
    "mm "
    "(%.2f), %.1f %%; %.0f reported\n",
    kMillimetres * treads.found_m.rmse(), kMillimetres * treads.site_m.rmse(),
    100.0 * treads.sigmas.inside_95(), kMillimetres * widths.found_m.rmse(),
    kMillimetres * widths.site_m.rmse(), 100.0 * widths.sigmas.inside_95(),
    static_cast<double>(totals.deviations_reported));
}

std::string protection_row(const EstimatorTotals & totals)
{
  const RiskShown risk = risk_shown(totals);
  return line(
    "  exceeded while OK: on %.0f of %.0f treads, for longer than 1 s on %.0f, %.2f s at most; "
    "risk "
    "a step below %.1e (95 %%), stated %.1e%s\n",
    static_cast<double>(totals.counts.treads_exceeded), static_cast<double>(risk.steps),
    static_cast<double>(risk.times), totals.longest_exceedance_s, risk.at_most_95, risk.stated,
    risk.carried() ? "" : ", which so few steps do not show");
}

std::string trust_rows(const EstimatorTotals & totals, bool fault_free)
{
  const ClimbScore & counts = totals.counts;
  const std::uint64_t ticks = counts.ticks_ok + counts.ticks_degraded + counts.ticks_lost;
  std::string text = line(
    "  NEES inside 95 %%: %.1f %% (%.1f %% with a riser in sight, %.1f %% without), mean %.2f\n",
    100.0 * totals.nees.inside_share(), 100.0 * totals.nees_with_reference.inside_share(),
    100.0 * totals.nees_without_reference.inside_share(), totals.nees.mean());
  text += line(
    "  flight frame inside 95 %%: x %.1f %%, z %.1f %%\n", 100.0 * totals.flight_x.inside_95(),
    100.0 * totals.flight_z.inside_95());
  if (totals.tread_depths.sigmas.count() > 0) {
    text += staircase_row(totals);
  }
  text += line(
    "  integrity: OK %.2f %%, DEGRADED %.3f %%, LOST %.3f %% of the time\n",
    percent(counts.ticks_ok, ticks), percent(counts.ticks_degraded, ticks),
    percent(counts.ticks_lost, ticks));
  text += step_rows(counts.steps);
  if (fault_free) {
    const Interval bounds = garwood(counts.alarms, counts.steps.on_stairs);
    text += line(
      "  false alarms after the first tread: %.0f in %.0f steps (95 %%: %.1e to %.1e a step)\n",
      static_cast<double>(counts.alarms), static_cast<double>(counts.steps.on_stairs), bounds.low,
      bounds.high);
  }
  if (totals.protection_across_m.count() > 0) {
    text += line(
      "  protection, median: along %.1f mm, across %.1f mm, heading %.2f deg\n",
      kMillimetres * totals.protection_along_m.percentile(0.5),
      kMillimetres * totals.protection_across_m.percentile(0.5),
      kDegrees * totals.protection_heading_rad.percentile(0.5));
    text += protection_row(totals);
  }
  return text;
}

std::string detection_row(const std::string & scenario, const EstimatorTotals & totals)
{
  const FaultNoticing noticing = noticing_of(totals.detections);
  const Interval missed = clopper_pearson(noticing.missed, noticing.struck);
  return line(
    "  %-15s %6.0f %7.0f %9.2f %9.2f %9.1f %9.1f %9.1f %10.1f %8.2f %9.2f %10.0f\n",
    scenario.substr(0, 15).c_str(), static_cast<double>(noticing.struck),
    static_cast<double>(noticing.missed), missed.low, missed.high, noticing.latest_s,
    noticing.latest_telling_s, kMillimetres * totals.after_onset.x_m.max(),
    kMillimetres * totals.after_onset.y_m.max(), kDegrees * totals.after_onset.heading_rad.max(),
    totals.longest_exceedance_s, static_cast<double>(totals.counts.steps.undetected));
}

std::string scenario_table(const AccuracyReport & report, std::size_t estimator)
{
  std::string text = line(
    "  %-15s %6s %7s %9s %9s %9s %9s %9s %10s %8s %9s %10s\n", "fault", "struck", "missed",
    "from 95 %", "to 95 %", "latest s", "telling s", "max x mm", "max y mm", "max deg", "beyond s",
    "wrong step");
  for (const ScenarioTotals & scenario : report.scenarios) {
    text += detection_row(scenario.name, scenario.estimators[estimator]);
  }
  return text;
}

std::string climb_rows(const ScenarioTotals & totals)
{
  constexpr std::size_t kMost = 12;
  std::string text = line(
    "%d of %d climbs finished, %d steps climbed\n", static_cast<int>(totals.finished),
    static_cast<int>(totals.climbs), static_cast<int>(totals.steps_climbed));
  for (std::size_t i = 0; i < totals.unfinished.size() && i < kMost; ++i) {
    const Unfinished & climb = totals.unfinished[i];
    text += "  seed " + std::to_string(climb.seed) + ": " + to_string(climb.end) + " on step " +
            std::to_string(climb.last_step) + ", " + climb.detail +
            (climb.faults.empty() ? "" : " [" + climb.faults.substr(0, 60) + "]") + "\n";
  }
  if (totals.unfinished.size() > kMost) {
    text += "  ... and " + std::to_string(totals.unfinished.size() - kMost) + " more\n";
  }
  return text;
}

}  // namespace

std::string summary_table(const AccuracyReport & report)
{
  std::string text = climb_rows(report.overall);
  for (std::size_t i = 0; i < report.estimators.size(); ++i) {
    const EstimatorTotals & totals = report.overall.estimators[i];
    text += "\n" + report.estimators[i] + (i == 0 ? ", driving" : ", listening") + ": " +
            std::to_string(totals.errors.y_m.count()) + " estimates from the second tread on\n" +
            error_table(totals) + trust_rows(totals, report.scenarios.empty());
    if (!report.scenarios.empty()) {
      text += scenario_table(report, i);
    }
  }
  return text;
}

}  // namespace stetro_bringup
