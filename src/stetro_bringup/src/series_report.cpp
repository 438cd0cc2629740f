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

#include "stetro_bringup/series_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <ostream>

#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

/// Numbers of one kind over all runs.
struct Figures
{
  std::vector<double> values;

  [[nodiscard]] nlohmann::ordered_json largest() const
  {
    return values.empty() ? nlohmann::ordered_json(nullptr)
                          : nlohmann::ordered_json(*std::max_element(values.begin(), values.end()));
  }
  [[nodiscard]] nlohmann::ordered_json median() const
  {
    if (values.empty()) {
      return nullptr;
    }
    std::vector<double> sorted = values;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  }
};

struct Totals
{
  std::size_t succeeded = 0;
  std::size_t kidnaps = 0;
  Figures jumps_m;
  Figures noticed_s;
  Figures relocalised_s;
};

Totals totals_of(const std::vector<ClimbOutcome> & runs)
{
  Totals totals;
  for (const ClimbOutcome & run : runs) {
    totals.succeeded += run.shortfalls.empty() ? 1 : 0;
    for (const SegmentChange & one : run.hand_overs) {
      totals.jumps_m.values.push_back(one.jump_m);
    }
    totals.kidnaps += run.kidnaps.size();
    for (const Kidnap & one : run.kidnaps) {
      if (one.noticed_after_s) {
        totals.noticed_s.values.push_back(*one.noticed_after_s);
      }
      if (one.relocalised_after_s) {
        totals.relocalised_s.values.push_back(*one.relocalised_after_s);
      }
    }
  }
  return totals;
}

nlohmann::ordered_json runs_json(const std::vector<ClimbOutcome> & runs)
{
  auto all = nlohmann::ordered_json::array();
  for (const ClimbOutcome & run : runs) {
    all.push_back(
      {{"seed", run.seed},
       {"succeeded", run.shortfalls.empty()},
       {"simulated_time_s", run.simulated_time_s},
       {"shortfalls", run.shortfalls}});
  }
  return all;
}

}  // namespace

bool SeriesReport::succeeded() const
{
  return !runs_.empty() && totals_of(runs_).succeeded == runs_.size();
}

std::string SeriesReport::json() const
{
  const Totals totals = totals_of(runs_);
  nlohmann::ordered_json series;
  series["runs"] = runs_.size();
  series["succeeded"] = totals.succeeded;
  series["hand_overs"] = totals.jumps_m.values.size();
  series["jump_max_m"] = totals.jumps_m.largest();
  series["kidnaps"] = totals.kidnaps;
  series["noticed"] = totals.noticed_s.values.size();
  series["noticed_after_median_s"] = totals.noticed_s.median();
  series["noticed_after_max_s"] = totals.noticed_s.largest();
  series["relocalised"] = totals.relocalised_s.values.size();
  series["relocalised_after_median_s"] = totals.relocalised_s.median();
  series["relocalised_after_max_s"] = totals.relocalised_s.largest();
  series["each"] = runs_json(runs_);
  return series.dump(2) + "\n";
}

void SeriesReport::print(std::ostream & out) const
{
  const Totals totals = totals_of(runs_);
  const auto largest = [](const Figures & figures) {
    return figures.values.empty() ? 0.0
                                  : *std::max_element(figures.values.begin(), figures.values.end());
  };
  std::array<char, 200> text{};
  std::snprintf(
    text.data(), text.size(), "%zu of %zu runs succeeded; %zu hand-overs, %.2f cm at most\n",
    totals.succeeded, runs_.size(), totals.jumps_m.values.size(), 100.0 * largest(totals.jumps_m));
  out << text.data();
  if (totals.kidnaps > 0) {
    std::snprintf(
      text.data(), text.size(),
      "%zu kidnaps, %zu noticed after %.1f s of motion at most, %zu found again %.1f s later at "
      "most\n",
      totals.kidnaps, totals.noticed_s.values.size(), largest(totals.noticed_s),
      totals.relocalised_s.values.size(), largest(totals.relocalised_s));
    out << text.data();
  }
  for (const ClimbOutcome & run : runs_) {
    for (const std::string & shortfall : run.shortfalls) {
      out << "  seed " << run.seed << ": " << shortfall << '\n';
    }
  }
}

}  // namespace stetro_bringup
