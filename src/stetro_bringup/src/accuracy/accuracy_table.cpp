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
#include <array>
#include <cmath>
#include <cstdio>

#include "accuracy/accuracy_report.hpp"
#include "accuracy/proportion.hpp"

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

double percent(std::uint64_t part, std::uint64_t whole)
{
  return whole == 0 ? std::nan("") : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string row(
  const char * name, const ErrorDistribution & errors, double scale, const char * unit)
{
  return line(
    "  %-18s %9.2f %9.2f %9.2f %9.2f %9.2f %9.2f  %s\n", name, scale * errors.rmse(),
    scale * errors.mean(), scale * errors.standard_deviation(), scale * errors.percentile(0.95),
    scale * errors.percentile(0.999), scale * errors.max(), unit);
}

std::string error_rows(const EstimatorTotals & totals)
{
  const ErrorGroup & errors = totals.errors;
  return line(
           "  %-18s %9s %9s %9s %9s %9s %9s\n", "error", "rms", "mean", "std", "95 %", "99.9 %",
           "max") +
         row("x, riser ahead", errors.x_m, kMillimetres, "mm") +
         row("x, riser behind", errors.x_behind_m, kMillimetres, "mm") +
         row("y, right wall", errors.y_m, kMillimetres, "mm") +
         row("z, tread", errors.z_m, kMillimetres, "mm") +
         row("heading", errors.heading_rad, kDegrees, "deg") +
         row("heading to riser", errors.heading_to_riser_rad, kDegrees, "deg") +
         row("flight frame x", totals.flight_x_m, kMillimetres, "mm") +
         row("flight frame z", totals.flight_z_m, kMillimetres, "mm") +
         row("hand-over jump", totals.hand_over_m, kMillimetres, "mm") +
         row("contact closure", totals.closure_m, kMillimetres, "mm") +
         row("first tread y", totals.first_tread.y_m, kMillimetres, "mm") +
         row("first tread head.", totals.first_tread.heading_rad, kDegrees, "deg");
}

std::string trust_rows(const EstimatorTotals & totals)
{
  const ClimbScore & counts = totals.counts;
  const std::uint64_t ticks = counts.ticks_ok + counts.ticks_degraded + counts.ticks_lost;
  std::string text = line(
    "  NEES inside 95 %%: %.1f %% (%.1f %% with a riser in sight, %.1f %% without), mean %.2f\n",
    100.0 * totals.nees.inside_share(), 100.0 * totals.nees_with_reference.inside_share(),
    100.0 * totals.nees_without_reference.inside_share(), totals.nees.mean());
  text += line(
    "  integrity: OK %.2f %%, DEGRADED %.3f %%, LOST %.3f %% of the time\n",
    percent(counts.ticks_ok, ticks), percent(counts.ticks_degraded, ticks),
    percent(counts.ticks_lost, ticks));
  const Interval steps = clopper_pearson(counts.undetected_steps, counts.step_checks);
  text += line(
    "  step wrong before a climb: %.0f of %.0f, unnoticed %.0f (95 %%: %.1e to %.1e a step)\n",
    static_cast<double>(counts.wrong_steps), static_cast<double>(counts.step_checks),
    static_cast<double>(counts.undetected_steps), steps.low, steps.high);
  if (totals.protection_across_m.count() > 0) {
    text += line(
      "  protection, median: along %.1f mm, across %.1f mm, heading %.2f deg; exceeded while OK "
      "for "
      "%.2f s at most\n",
      kMillimetres * totals.protection_along_m.percentile(0.5),
      kMillimetres * totals.protection_across_m.percentile(0.5),
      kDegrees * totals.protection_heading_rad.percentile(0.5), totals.longest_exceedance_s);
  }
  return text;
}

std::string detection_row(const std::string & scenario, const EstimatorTotals & totals)
{
  double latest_s = 0.0;
  double latest_motion_s = 0.0;
  int missed = 0;
  for (const Detection & detection : totals.detections) {
    missed += detection.detected ? 0 : 1;
    if (detection.detected) {
      latest_s = std::max(latest_s, detection.time_s);
      latest_motion_s = std::max(latest_motion_s, detection.telling_motion_s);
    }
  }
  return line(
    "  %-15s %6d %7d %9.1f %9.1f %9.1f %10.1f %8.2f %9.2f %10.0f\n", scenario.substr(0, 15).c_str(),
    static_cast<int>(totals.detections.size()), missed, latest_s, latest_motion_s,
    kMillimetres * totals.after_onset.x_m.max(), kMillimetres * totals.after_onset.y_m.max(),
    kDegrees * totals.after_onset.heading_rad.max(), totals.longest_exceedance_s,
    static_cast<double>(totals.counts.undetected_steps));
}

std::string scenario_table(const AccuracyReport & report, std::size_t estimator)
{
  std::string text = line(
    "  %-15s %6s %7s %9s %9s %9s %10s %8s %9s %10s\n", "fault", "struck", "missed", "latest s",
    "telling s", "max x mm", "max y mm", "max deg", "beyond s", "wrong step");
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
            error_rows(totals) + trust_rows(totals);
    if (!report.scenarios.empty()) {
      text += scenario_table(report, i);
    }
  }
  return text;
}

}  // namespace stetro_bringup
