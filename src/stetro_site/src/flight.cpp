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

#include "stetro_site/flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace stetro_site
{
namespace
{

void require_positive(const std::string & name, double value)
{
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(
      "flight: " + name + ": value " + std::to_string(value) + " refused, accepted: more than 0");
  }
}

FlightSpec sound(FlightSpec spec)
{
  if (spec.id.empty() || spec.steps.empty()) {
    throw std::invalid_argument("flight '" + spec.id + "': accepted: an id and at least one step");
  }
  for (const Step & step : spec.steps) {
    require_positive("riser_m", step.riser_m);
    require_positive("tread_m", step.tread_m);
  }
  require_positive("width_foot_m", spec.width_foot_m);
  require_positive("width_top_m", spec.width_top_m);
  if (!(std::isfinite(spec.wall_overrun_m) && spec.wall_overrun_m >= 0.0)) {
    throw std::invalid_argument("flight: wall_overrun_m: accepted: 0 or more");
  }
  return spec;
}

/// Running sums from 0: as many as there are steps, and one.
std::vector<double> sums(const std::vector<Step> & steps, double Step::*length)
{
  std::vector<double> running{0.0};
  for (const Step & step : steps) {
    running.push_back(running.back() + step.*length);
  }
  return running;
}

std::size_t index(int i, int least, int steps)
{
  if (i < least || i > steps) {
    throw std::out_of_range(
      "step " + std::to_string(i) + " refused, accepted: " + std::to_string(least) + " to " +
      std::to_string(steps));
  }
  return static_cast<std::size_t>(i);
}

}  // namespace

std::vector<Step> equal_steps(int count, double riser_m, double tread_m)
{
  return std::vector<Step>(static_cast<std::size_t>(std::max(count, 0)), {riser_m, tread_m});
}

Flight::Flight(FlightSpec spec)
: spec_(sound(std::move(spec))),
  x_m_(sums(spec_.steps, &Step::tread_m)),
  z_m_(sums(spec_.steps, &Step::riser_m)),
  T_map_flight_(spec_.pose_in_map)
{
}

double Flight::riser_m(int i) const { return spec_.steps[index(i, 1, steps()) - 1].riser_m; }

double Flight::tread_m(int i) const { return spec_.steps[index(i, 1, steps()) - 1].tread_m; }

double Flight::riser_x_m(int i) const { return x_m_[index(i, 1, steps()) - 1]; }

double Flight::tread_start_m(int i) const { return riser_x_m(i); }

double Flight::tread_end_m(int i) const { return x_m_[index(i, 1, steps())]; }

double Flight::tread_centre_m(int i) const { return 0.5 * (tread_start_m(i) + tread_end_m(i)); }

double Flight::tread_z_m(int i) const { return z_m_[index(i, 0, steps())]; }

int Flight::step_at(double x_m) const
{
  // As many treads have begun as there are risers at or before x; the last has no end.
  const auto last_riser = x_m_.end() - 1;
  return static_cast<int>(std::upper_bound(x_m_.begin(), last_riser, x_m) - x_m_.begin());
}

double Flight::width_m(double x_m) const
{
  const double share = x_m / total_run_m();
  return spec_.width_foot_m + share * (spec_.width_top_m - spec_.width_foot_m);
}

double Flight::narrowest_m() const { return std::min(spec_.width_foot_m, spec_.width_top_m); }

double Flight::widest_m() const { return std::max(spec_.width_foot_m, spec_.width_top_m); }

double Flight::centre_to_centre_m() const { return tread_centre_m(steps()) - tread_centre_m(1); }

double Flight::highest_riser_m() const
{
  return std::max_element(
           spec_.steps.begin(), spec_.steps.end(),
           [](const Step & a, const Step & b) { return a.riser_m < b.riser_m; })
    ->riser_m;
}

double Flight::shortest_tread_m() const
{
  return std::min_element(
           spec_.steps.begin(), spec_.steps.end(),
           [](const Step & a, const Step & b) { return a.tread_m < b.tread_m; })
    ->tread_m;
}

}  // namespace stetro_site
