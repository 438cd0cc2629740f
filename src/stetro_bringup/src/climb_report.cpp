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
#include "stetro_bringup/climb_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

#include "stetro_site/frame_transform.hpp"

namespace stetro_bringup
{
namespace
{

constexpr double kDegreesPerRadian = 180.0 / M_PI;

}  // namespace

ClimbReport::ClimbReport(const ReportFacts & facts) : facts_(facts) {}

StepRow & ClimbReport::row_of(const std::string & flight, int step)
{
  const auto found = std::find_if(steps_.begin(), steps_.end(), [&](const StepRow & row) {
    return row.step == step && row.flight == flight;
  });
  if (found != steps_.end()) {
    return *found;
  }
  StepRow fresh;
  fresh.flight = flight;
  fresh.step = step;
  fresh.y_max_m = -std::numeric_limits<double>::infinity();
  fresh.y_min_m = std::numeric_limits<double>::infinity();
  steps_.push_back(fresh);
  return steps_.back();
}

void ClimbReport::add_sweeping(const TraceRow & row)
{
  const bool lost = std::isnan(row.estimate.tread_y_m) || std::isnan(row.estimate.heading_rad);
  const auto width = facts_.widths_m.find(row.estimate.segment);
  if (row.estimate.step < 1 || lost || width == facts_.widths_m.end()) {
    return;  // only treads are swept
  }
  StepRow & step = row_of(row.estimate.segment, row.estimate.step);
  ++step.estimates;
  step.y_max_m = std::max(step.y_max_m, row.estimate.tread_y_m);
  step.y_min_m = std::min(step.y_min_m, row.estimate.tread_y_m);
  step.closure_error_m = width->second - ((step.y_max_m - step.y_min_m) + facts_.contact_width_m);
  if (!row.truth) {
    return;
  }
  if (row.truth->segment != row.estimate.segment || row.truth->step != row.estimate.step) {
    ++errors_.wrong_step;  // places on two treads have no difference worth a mean
    return;
  }
  const double y = row.estimate.tread_y_m - row.truth->tread_y_m;
  const double x = row.estimate.tread_x_m - row.truth->tread_x_m;
  const double heading = stetro_site::wrap_angle(row.estimate.heading_rad - row.truth->heading_rad);
  step.y_error_m.add(y);
  step.x_error_m.add(x);
  step.heading_error_rad.add(heading);
  errors_.y_error_m.add(y);
  errors_.x_error_m.add(x);
  errors_.heading_error_rad.add(heading);
}

ClimbErrors ClimbReport::errors() const
{
  ClimbErrors sums = errors_;
  for (const StepRow & step : steps_) {
    sums.closure_error_m.add(step.closure_error_m);
  }
  return sums;
}

void print_table(std::ostream & out, const ClimbReport & report)
{
  out << "step   y_max   y_min  closure     y error (rms, max)   x error (rms)  heading error "
         "(rms, max)\n"
         "          cm      cm       cm             cm                  cm                 deg\n";
  std::string flight = report.steps().empty() ? "" : report.steps().front().flight;
  for (const StepRow & step : report.steps()) {
    if (step.flight != flight) {
      flight = step.flight;
      out << "flight " << flight << '\n';
    }
    std::array<char, 160> line{};
    std::snprintf(
      line.data(), line.size(),
      "%4d  %6.1f  %6.1f  %7.2f       %7.2f %7.2f       %8.2f        %9.2f %7.2f\n", step.step,
      100.0 * step.y_max_m, 100.0 * step.y_min_m, 100.0 * step.closure_error_m,
      100.0 * step.y_error_m.rms(), 100.0 * step.y_error_m.max_abs(), 100.0 * step.x_error_m.rms(),
      kDegreesPerRadian * step.heading_error_rad.rms(),
      kDegreesPerRadian * step.heading_error_rad.max_abs());
    out << line.data();
  }
}

void write_steps_csv(std::ostream & out, const ClimbReport & report)
{
  out << "step,estimates,y_max_m,y_min_m,closure_error_m,y_rmse_m,y_max_error_m,x_rmse_m,"
         "x_mean_error_m,heading_mean_error_rad,heading_std_rad,heading_rmse_rad,"
         "heading_max_error_rad,flight\n";
  for (const StepRow & step : report.steps()) {
    out << step.step << ',' << step.estimates;
    for (const double value :
         {step.y_max_m, step.y_min_m, step.closure_error_m, step.y_error_m.rms(),
          step.y_error_m.max_abs(), step.x_error_m.rms(), step.x_error_m.mean(),
          step.heading_error_rad.mean(), step.heading_error_rad.standard_deviation(),
          step.heading_error_rad.rms(), step.heading_error_rad.max_abs()}) {
      put_field(out, value);
    }
    out << ',' << step.flight << '\n';
  }
}

}  // namespace stetro_bringup
