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

#include "accuracy/accuracy_markdown.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

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

std::string number(double value, const char * format = "%.2f")
{
  if (!std::isfinite(value)) {
    return "–";
  }
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string row(std::initializer_list<std::string> cells)
{
  std::string text = "|";
  for (const std::string & cell : cells) {
    text += ' ' + cell + " |";
  }
  return text + '\n';
}

/// \param words columns on the left that are words; the others are numbers, to the right
std::string head(std::initializer_list<std::string> cells, std::size_t words = 1)
{
  std::string rule = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    rule += i < words ? "---|" : "--:|";
  }
  return row(cells) + rule + '\n';
}

std::string out_of(std::uint64_t count, std::uint64_t of)
{
  return std::to_string(count) + " of " + std::to_string(of);
}

std::string bounds_of(const Interval & bounds)
{
  const std::string low = bounds.low > 0.0 ? number(bounds.low, "%.1e") : "0";
  return low + " to " + number(bounds.high, "%.1e");
}

std::string percent(std::uint64_t part, std::uint64_t whole)
{
  return number(100.0 * share_of(part, whole), "%.2f %%");
}

std::string bounds_of(std::uint64_t count, std::uint64_t of)
{
  return of == 0 ? "–" : bounds_of(clopper_pearson(count, of));
}

std::string rate_row(const std::string & name, std::uint64_t count, std::uint64_t of)
{
  return row({name, out_of(count, of), bounds_of(count, of)});
}

/// A step may have several; what one step cannot have twice is rare enough to be counted alike.
std::string times_row(const std::string & name, std::uint64_t times, std::uint64_t steps)
{
  const std::string found = std::to_string(times) + " in " + std::to_string(steps) + " steps";
  return row({name, found, bounds_of(garwood(times, steps))});
}

std::string risk_row(const RiskShown & risk)
{
  const std::string claim =
    risk.carried()
      ? "carried by these steps"
      : "not carried: needs " + number(risk.clean_steps_needed, "%.0f") + " clean steps";
  return row(
    {"integrity risk stated, per step", number(risk.stated, "%.1e"),
     std::isfinite(risk.stated)
       ? "below " + number(risk.at_most_95, "%.1e") + " with 95 % confidence; " + claim
       : ""});
}

std::string origin(const AccuracyReport & report, const Provenance & provenance)
{
  const ScenarioTotals & climbs = report.overall;
  const std::uint64_t last_seed = report.first_seed + report.runs - 1;
  const std::string cores =
    provenance.machine.cores == 0 ? "–" : std::to_string(provenance.machine.cores);
  std::string text = head({"run", ""}, 2);
  text += row({"command", '`' + provenance.command + '`'});
  text += row({"commit", provenance.commit.empty() ? "–" : '`' + provenance.commit + '`'});
  text += row(
    {"machine",
     cores + " cores, " + (provenance.machine.cpu.empty() ? "–" : provenance.machine.cpu)});
  text += row({"seeds", std::to_string(report.first_seed) + " to " + std::to_string(last_seed)});
  text += row(
    {"stairs", '`' + report.flight + "`, " + std::to_string(report.steps) + " steps; world `" +
                 report.world + "`, calibration `" + report.calibration + '`'});
  text += row(
    {"climbs", out_of(climbs.finished, climbs.climbs) + " finished, " +
                 std::to_string(climbs.steps_climbed) + " steps, " +
                 number(climbs.simulated_s / 3600.0, "%.1f") + " h simulated"});
  return text;
}

std::string errors_table(const EstimatorTotals & totals)
{
  std::string text = head({"error", "unit", "rms", "mean", "std", "95 %", "99.9 %", "max"}, 2);
  for (const ErrorRow & error : error_rows(totals)) {
    const auto scaled = [&](double value) { return number(error.scale * value); };
    text += row(
      {error.name, error.unit, scaled(error.errors.rmse()), scaled(error.errors.mean()),
       scaled(error.errors.standard_deviation()), scaled(error.errors.percentile(0.95)),
       scaled(error.errors.percentile(0.999)), scaled(error.errors.max())});
  }
  return text;
}

std::string step_rows(const StepTally & steps)
{
  const MiscountNoticing miscounts = noticing_of(steps.miscounts);
  std::string text = rate_row("step wrong before a climb", steps.wrong, steps.checks);
  text += rate_row("of these, with integrity OK", steps.undetected, steps.checks);
  text += rate_row(
    "miscounts noticed before the next climb", miscounts.before_next_climb, miscounts.began);
  text += rate_row("miscounts noticed within one step", miscounts.within_one_step, miscounts.began);
  return text;
}

std::string integrity_table(const EstimatorTotals & totals, bool fault_free)
{
  const ClimbScore & counts = totals.counts;
  const std::uint64_t ticks = counts.ticks_ok + counts.ticks_degraded + counts.ticks_lost;
  std::string text = head({"integrity", "found", "95 % bounds of the rate"});
  text += row({"time OK", percent(counts.ticks_ok, ticks), ""});
  text += row({"time DEGRADED", percent(counts.ticks_degraded, ticks), ""});
  text += row({"time LOST", percent(counts.ticks_lost, ticks), ""});
  if (fault_free) {
    text += times_row("false alarms after the first tread", counts.alarms, counts.steps.on_stairs);
  }
  text += step_rows(counts.steps);
  text += times_row(
    "treads with an error beyond its protection while OK", counts.treads_exceeded, counts.treads);
  text += times_row("of these, for longer than 1 s", counts.treads_misled, counts.treads);
  text += risk_row(risk_shown(totals));
  text +=
    row({"longest beyond protection while OK", number(totals.longest_exceedance_s) + " s", ""});
  text += row(
    {"protection along, median",
     number(kMillimetres * totals.protection_along_m.percentile(0.5)) + " mm", ""});
  text += row(
    {"protection across, median",
     number(kMillimetres * totals.protection_across_m.percentile(0.5)) + " mm", ""});
  text += row(
    {"protection of the heading, median",
     number(kDegrees * totals.protection_heading_rad.percentile(0.5)) + " deg", ""});
  text += row({"NEES inside its 95 %", percent(totals.nees.inside, totals.nees.known()), ""});
  return text;
}

std::string fault_row(const std::string & scenario, const EstimatorTotals & totals)
{
  const FaultNoticing noticing = noticing_of(totals.detections);
  const auto latest = [&](double time_s) {
    return number(noticing.struck > noticing.missed ? time_s : std::nan(""), "%.1f");
  };
  return row(
    {scenario, std::to_string(noticing.struck), std::to_string(noticing.missed),
     bounds_of(noticing.missed, noticing.struck), out_of(noticing.in_telling_time, noticing.struck),
     latest(noticing.latest_s), latest(noticing.latest_telling_s),
     number(kMillimetres * totals.after_onset.x_m.max(), "%.1f"),
     number(kMillimetres * totals.after_onset.y_m.max(), "%.1f"),
     number(kDegrees * totals.after_onset.heading_rad.max()), number(totals.longest_exceedance_s),
     out_of(totals.counts.steps.undetected, totals.counts.steps.checks)});
}

std::string faults_table(const AccuracyReport & report, std::size_t estimator)
{
  std::string text = head(
    {"fault", "struck", "missed", "95 % bounds", "within 1 s of telling motion", "latest [s]",
     "latest, telling motion [s]", "max x [mm]", "max y [mm]", "max heading [deg]",
     "longest beyond protection while OK [s]", "wrong step unnoticed"});
  for (const ScenarioTotals & scenario : report.scenarios) {
    text += fault_row(scenario.name, scenario.estimators[estimator]);
  }
  return text;
}

std::string treads_table(const EstimatorTotals & totals)
{
  std::string text = head(
    {"tread", "x rms [mm]", "x said [mm]", "y rms [mm]", "y said [mm]", "heading rms [deg]",
     "heading said [deg]", "NEES inside its 95 %"});
  for (std::size_t step = 1; step < totals.treads.size(); ++step) {
    const TreadTotals & tread = totals.treads[step];
    text += row(
      {std::to_string(step), number(kMillimetres * tread.x_m.rmse()),
       number(kMillimetres * tread.sigma_x_m.rms()), number(kMillimetres * tread.y_m.rmse()),
       number(kMillimetres * tread.sigma_y_m.rms()), number(kDegrees * tread.heading_rad.rmse()),
       number(kDegrees * tread.sigma_heading_rad.rms()),
       percent(tread.nees.inside, tread.nees.known())});
  }
  return text;
}

}  // namespace

std::string summary_markdown(const AccuracyReport & report, const Provenance & provenance)
{
  std::string text = origin(report, provenance);
  for (std::size_t i = 0; i < report.estimators.size(); ++i) {
    const EstimatorTotals & totals = report.overall.estimators[i];
    text += "\n## `" + report.estimators[i] + "`, " + (i == 0 ? "driving" : "listening") + "\n\n" +
            std::to_string(totals.errors.y_m.count()) + " estimates from the second tread on.\n\n" +
            errors_table(totals) + '\n' + integrity_table(totals, report.scenarios.empty()) + '\n';
    if (!report.scenarios.empty()) {
      text += faults_table(report, i) + '\n';
    }
    text += treads_table(totals);
  }
  return text;
}

}  // namespace stetro_bringup
