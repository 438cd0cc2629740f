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
#include "stetro_bringup/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

constexpr double kLargestJump_m = 0.01;
constexpr double kLongestUnnoticed_s = 5.0;

// JSON has no NaN: what is not known is null.
nlohmann::ordered_json known(double value)
{
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json staircase_json(const StaircaseFound & staircase)
{
  auto steps = nlohmann::ordered_json::array();
  for (const StepFound & one : staircase.steps) {
    steps.push_back(
      {{"step", one.step},
       {"tread_m", known(one.tread_m)},
       {"tread_sigma_m", known(one.tread_sigma_m)},
       {"width_m", known(one.width_m)},
       {"width_sigma_m", known(one.width_sigma_m)}});
  }
  auto deviations = nlohmann::ordered_json::array();
  for (const StepDeviation & one : staircase.deviations) {
    deviations.push_back(
      {{"step", one.step},
       {"measure", one.measure},
       {"found_m", known(one.found_m)},
       {"sigma_m", known(one.sigma_m)},
       {"site_m", known(one.site_m)}});
  }
  return {
    {"treads_measured", staircase.treads_measured()},
    {"largest_deviation_m", known(staircase.largest_deviation_m)},
    {"largest_deviation_of", staircase.largest_deviation_of},
    {"steps", steps},
    {"deviations", deviations}};
}

void print_staircase(std::ostream & out, const StaircaseFound & staircase)
{
  if (staircase.steps.empty()) {
    return;  // the papers measure none
  }
  std::array<char, 160> text{};
  std::snprintf(
    text.data(), text.size(),
    "  staircase     %6zu treads measured, largest deviation %.1f mm (%s)",
    staircase.treads_measured(), 1000.0 * staircase.largest_deviation_m,
    staircase.largest_deviation_of.c_str());
  out << text.data() << (staircase.deviations.empty() ? "; as the site file says\n" : "\n");
  for (const StepDeviation & one : staircase.deviations) {
    std::snprintf(
      text.data(), text.size(),
      "  WARNING       %s of step %d is %.1f mm (sigma %.1f mm), the site file says %.1f mm\n",
      one.measure.c_str(), one.step, 1000.0 * one.found_m, 1000.0 * one.sigma_m,
      1000.0 * one.site_m);
    out << text.data();
  }
}

nlohmann::ordered_json hand_overs_json(const std::vector<SegmentChange> & hand_overs)
{
  auto all = nlohmann::ordered_json::array();
  for (const SegmentChange & one : hand_overs) {
    all.push_back(
      {{"from", one.from},
       {"to", one.to},
       {"time_s", one.time_s},
       {"jump_m", one.jump_m},
       {"turn_rad", one.turn_rad}});
  }
  return all;
}

nlohmann::ordered_json kidnaps_json(const std::vector<Kidnap> & kidnaps)
{
  const auto told = [](const std::optional<double> & time_s) {
    return time_s ? nlohmann::ordered_json(*time_s) : nlohmann::ordered_json(nullptr);
  };
  auto all = nlohmann::ordered_json::array();
  for (const Kidnap & one : kidnaps) {
    all.push_back(
      {{"segment", one.segment},
       {"time_s", one.time_s},
       {"distance_m", one.distance_m},
       {"turned_rad", one.turned_rad},
       {"noticed_after_s", told(one.noticed_after_s)},
       {"relocalised_after_s", told(one.relocalised_after_s)}});
  }
  return all;
}

std::string decimals(double value, int count)
{
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*f", count, value);
  return text.data();
}

void append_kidnaps(const ClimbOutcome & outcome, std::vector<std::string> & shortfalls)
{
  for (const Kidnap & one : outcome.kidnaps) {
    if (!one.noticed_after_s) {
      shortfalls.push_back("the kidnap on " + one.segment + " is not noticed");
    } else if (*one.noticed_after_s > kLongestUnnoticed_s) {
      shortfalls.push_back(
        "the kidnap on " + one.segment + " is noticed after " + decimals(*one.noticed_after_s, 1) +
        " s of motion");
    } else if (!one.relocalised_after_s) {
      shortfalls.push_back("the robot is not found after the kidnap on " + one.segment);
    }
  }
  for (const std::string & floor : outcome.kidnaps_asked) {
    const bool happened = std::any_of(
      outcome.kidnaps.begin(), outcome.kidnaps.end(),
      [&](const Kidnap & one) { return one.segment == floor; });
    if (!happened) {
      shortfalls.push_back("no kidnap happened on " + floor);
    }
  }
}

void print_hand_overs(std::ostream & out, const std::vector<SegmentChange> & hand_overs)
{
  for (const SegmentChange & one : hand_overs) {
    std::array<char, 160> text{};
    std::snprintf(
      text.data(), text.size(), "  hand-over     %6.2f cm, %.2f deg beyond the motion, %s to %s\n",
      100.0 * one.jump_m, 180.0 / M_PI * one.turn_rad, one.from.c_str(), one.to.c_str());
    out << text.data();
  }
}

void print_kidnaps(std::ostream & out, const std::vector<Kidnap> & kidnaps)
{
  for (const Kidnap & one : kidnaps) {
    std::array<char, 160> text{};
    std::snprintf(
      text.data(), text.size(), "  kidnap        %6.2f m and %.0f deg away on %s: ", one.distance_m,
      180.0 / M_PI * one.turned_rad, one.segment.c_str());
    out << text.data();
    if (!one.noticed_after_s) {
      out << "NOT NOTICED\n";
      continue;
    }
    std::snprintf(
      text.data(), text.size(), "noticed after %.1f s of motion, ", *one.noticed_after_s);
    out << text.data();
    if (one.relocalised_after_s) {
      std::snprintf(
        text.data(), text.size(), "relocalised %.1f s later\n", *one.relocalised_after_s);
      out << text.data();
    } else {
      out << "NOT RELOCALISED\n";
    }
  }
}

}  // namespace

std::string summary_json(const ClimbOutcome & outcome, const ClimbErrors & errors)
{
  nlohmann::ordered_json summary;
  summary["completed"] = outcome.completed;
  summary["final_segment"] = outcome.final_segment;
  summary["final_step"] = outcome.final_step;
  summary["integrity"] = outcome.integrity;
  summary["seed"] = outcome.seed;
  summary["estimator"] = outcome.estimator;
  summary["world"] = outcome.world;
  summary["calibration"] = outcome.calibration;
  summary["in_process"] = outcome.in_process;
  summary["y_rmse_m"] = known(errors.y_error_m.rms());
  summary["y_max_error_m"] = known(errors.y_error_m.max_abs());
  summary["x_rmse_m"] = known(errors.x_error_m.rms());
  summary["x_mean_error_m"] = known(errors.x_error_m.mean());
  summary["heading_rmse_rad"] = known(errors.heading_error_rad.rms());
  summary["heading_mean_error_rad"] = known(errors.heading_error_rad.mean());
  summary["heading_std_rad"] = known(errors.heading_error_rad.standard_deviation());
  summary["heading_max_error_rad"] = known(errors.heading_error_rad.max_abs());
  summary["closure_error_mean_m"] = known(errors.closure_error_m.mean());
  summary["closure_error_std_m"] = known(errors.closure_error_m.standard_deviation());
  summary["staircase_as_built"] = staircase_json(outcome.staircase);
  summary["hand_overs"] = hand_overs_json(outcome.hand_overs);
  summary["kidnaps"] = kidnaps_json(outcome.kidnaps);
  summary["estimates_on_wrong_step"] = errors.wrong_step;
  summary["simulated_time_s"] = known(outcome.simulated_time_s);
  summary["wall_time_s"] = known(outcome.wall_time_s);
  summary["times_held"] = outcome.times_held;
  summary["faults"] = outcome.faults;
  summary["succeeded"] = outcome.shortfalls.empty();
  summary["shortfalls"] = outcome.shortfalls;
  return summary.dump(2) + "\n";
}

void print_summary(std::ostream & out, const ClimbOutcome & outcome, const ClimbErrors & errors)
{
  const auto line = [&out](const char * format, double a, double b) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, a, b);
    out << text.data();
  };
  out << (outcome.completed ? "completed" : "NOT COMPLETED") << ", on " << outcome.final_segment
      << ", step " << outcome.final_step << ", integrity " << outcome.integrity << ", estimator "
      << outcome.estimator << ", seed " << outcome.seed << '\n';
  line(
    "  y error       %6.2f cm rms, %.2f cm at most\n", 100.0 * errors.y_error_m.rms(),
    100.0 * errors.y_error_m.max_abs());
  line(
    "  x error       %6.2f cm rms, %.2f cm on average\n", 100.0 * errors.x_error_m.rms(),
    100.0 * errors.x_error_m.mean());
  if (outcome.estimator == "paper") {
    out
      << "                (the papers report the middle of the tread, S-B eq. (1), and the robot\n"
         "                sweeps nearer to the riser: the average is theirs by construction)\n";
  }
  line(
    "  heading error %6.2f deg rms, %.2f deg on average\n",
    180.0 / M_PI * errors.heading_error_rad.rms(), 180.0 / M_PI * errors.heading_error_rad.mean());
  line(
    "  closure       %6.2f cm mean, %.2f cm deviation (S-B eq. (3))\n",
    100.0 * errors.closure_error_m.mean(), 100.0 * errors.closure_error_m.standard_deviation());
  print_staircase(out, outcome.staircase);
  print_hand_overs(out, outcome.hand_overs);
  print_kidnaps(out, outcome.kidnaps);
  line(
    "  time          %6.0f s simulated in %.0f s\n", outcome.simulated_time_s, outcome.wall_time_s);
  if (outcome.times_held > 0) {
    out << "  held          " << outcome.times_held << " times\n";
  }
  for (const std::string & fault : outcome.faults) {
    out << "  fault         " << fault << '\n';
  }
  for (const std::string & shortfall : outcome.shortfalls) {
    out << "  SHORT OF      " << shortfall << '\n';
  }
}

std::vector<std::string> shortfalls(const ClimbOutcome & outcome, const Goal & goal)
{
  std::vector<std::string> all;
  if (!outcome.completed) {
    all.emplace_back("the mission is not finished");
  }
  if (outcome.final_segment != goal.segment || outcome.final_step != goal.step) {
    all.push_back(
      "it ends on step " + std::to_string(outcome.final_step) + " of " + outcome.final_segment);
  }
  if (outcome.integrity != "OK") {
    all.push_back("integrity is " + outcome.integrity);
  }
  for (const std::string & fault : outcome.faults) {
    all.push_back("fault " + fault);
  }
  for (const SegmentChange & one : outcome.hand_overs) {
    if (one.jump_m > kLargestJump_m) {
      all.push_back(
        "the pose jumps " + decimals(100.0 * one.jump_m, 2) + " cm from " + one.from + " to " +
        one.to);
    }
  }
  append_kidnaps(outcome, all);
  return all;
}

bool succeeded(const ClimbOutcome & outcome, const Goal & goal)
{
  return shortfalls(outcome, goal).empty();
}

}  // namespace stetro_bringup
