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
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "metres.hpp"
#include "stetro_site/site.hpp"

namespace stetro_site
{
namespace
{

using stetro_config::Faults;

/// Frames that mean something else already (REP 105).
constexpr std::array<const char *, 5> kReservedFrames{"map", "odom", "base_link", "earth", "world"};

std::string key_of(const char * list, std::size_t i, const char * key)
{
  return std::string{list} + "[" + std::to_string(i) + "]." + key;
}

/// Walks over a site once for each law, and keeps what breaks it.
class GraphCheck
{
public:
  explicit GraphCheck(const SiteSpec & spec) : spec_(spec)
  {
    for (const Floor & floor : spec.floors) {
      floors_.emplace(floor.id, &floor);
    }
  }

  Faults run()
  {
    if (spec_.floors.empty()) {
      refuse("floors", "[]", "at least one floor");
    }
    check_ids();
    for (std::size_t i = 0; i < spec_.flights.size(); ++i) {
      if (check_joins(i)) {
        check_elevations(i);
      }
    }
    if (faults_.empty()) {
      check_connected();
    }
    return std::move(faults_);
  }

private:
  void check_ids()
  {
    std::map<std::string, std::string> first;
    const auto check = [&](const std::string & key, const std::string & id) {
      if (std::count(kReservedFrames.begin(), kReservedFrames.end(), id) > 0) {
        refuse(key, id, "an id that is not the name of a frame of REP 105");
      }
      const auto [other, fresh] = first.emplace(id, key);
      if (!fresh) {
        refuse(key, id, "an id of its own; " + other->second + " has this one");
      }
    };
    for (std::size_t i = 0; i < spec_.floors.size(); ++i) {
      check(key_of("floors", i, "id"), spec_.floors[i].id);
    }
    for (std::size_t i = 0; i < spec_.flights.size(); ++i) {
      check(key_of("flights", i, "id"), spec_.flights[i].id());
    }
  }

  /// True if the flight joins two floors that exist.
  bool check_joins(std::size_t i)
  {
    const FlightSpec & flight = spec_.flights[i].spec();
    const std::string key = key_of("flights", i, "joins");
    bool joins = true;
    for (const std::string & id : {flight.lower_floor, flight.upper_floor}) {
      if (floors_.count(id) == 0) {
        refuse(key, id, "the id of a floor: " + floor_ids());
        joins = false;
      }
    }
    if (joins && flight.lower_floor == flight.upper_floor) {
      refuse(key, flight.lower_floor, "two different floors, the lower one first");
      joins = false;
    }
    return joins;
  }

  void check_elevations(std::size_t i)
  {
    const Flight & flight = spec_.flights[i];
    const double lower_m = floors_.at(flight.spec().lower_floor)->elevation_m();
    const double upper_m = floors_.at(flight.spec().upper_floor)->elevation_m();
    const double foot_m = flight.spec().pose_in_map.z_m;
    if (!agree(foot_m, lower_m)) {
      refuse(
        key_of("flights", i, "pose.z_m"), metres(foot_m),
        metres(lower_m) + ", the elevation of " + flight.spec().lower_floor + ", within " +
          metres(spec_.tolerance_m));
    }
    const double top_m = lower_m + flight.total_rise_m();
    if (!agree(top_m, upper_m)) {
      refuse(
        key_of("flights", i, "joins"), flight.spec().upper_floor + " at " + metres(upper_m),
        "a floor at " + metres(top_m) + " = " + metres(lower_m) + " of " +
          flight.spec().lower_floor + " + " + metres(flight.total_rise_m()) + " of " +
          std::to_string(flight.steps()) + " risers, within " + metres(spec_.tolerance_m) +
          " (differs by " + metres(std::abs(top_m - upper_m)) + ")");
    }
  }

  /// Spreads from the first floor along flights until nothing new is reached.
  void check_connected()
  {
    std::set<std::string> reached{spec_.floors.front().id};
    for (bool grows = true; grows;) {
      grows = false;
      for (const Flight & flight : spec_.flights) {
        const std::string & lower = flight.spec().lower_floor;
        const std::string & upper = flight.spec().upper_floor;
        if (reached.count(lower) != reached.count(upper)) {
          reached.insert({lower, upper});
          grows = true;
        }
      }
    }
    for (std::size_t i = 0; i < spec_.floors.size(); ++i) {
      const std::string & id = spec_.floors[i].id;
      if (reached.count(id) == 0) {
        refuse(
          key_of("floors", i, "id"), id, "a floor that flights join to " + spec_.floors.front().id);
      }
    }
  }

  [[nodiscard]] bool agree(double a_m, double b_m) const
  {
    constexpr double kRounding = 1e-9;  // sums of doubles; a nanometre is no fault
    return std::abs(a_m - b_m) <= spec_.tolerance_m + kRounding;
  }

  [[nodiscard]] std::string floor_ids() const
  {
    std::string text;
    for (const Floor & floor : spec_.floors) {
      text += (text.empty() ? "" : ", ") + floor.id;
    }
    return text;
  }

  void refuse(const std::string & key, std::string value, std::string accepted)
  {
    const auto at = spec_.origin(key);
    faults_.add({at.file, at.line, key, std::move(value), std::move(accepted)});
  }

  const SiteSpec & spec_;
  std::map<std::string, const Floor *> floors_;
  Faults faults_;
};

}  // namespace

Faults check_graph(const SiteSpec & spec) { return GraphCheck{spec}.run(); }

}  // namespace stetro_site
