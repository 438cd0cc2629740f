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

#include "stetro_supervisor/floor/route.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace stetro_supervisor
{
namespace
{

using stetro_site::Flight;
using stetro_site::Site;

bool knows(const Site & site, const std::string & id)
{
  return site.find_floor(id) != nullptr || site.find_flight(id) != nullptr;
}

std::string known_segments(const Site & site)
{
  std::string ids;
  const auto add = [&ids](const std::string & id) {
    ids += (ids.empty() ? "'" : ", '") + id + "'";
  };
  for (const auto & floor : site.floors()) {
    add(floor.id);
  }
  for (const auto & flight : site.flights()) {
    add(flight.id());
  }
  return ids;
}

/// What can be entered from a segment; `downwards` too, where only the reason is asked for.
std::vector<std::string> next_segments(const Site & site, const std::string & id, bool downwards)
{
  if (downwards) {
    return site.neighbours(id);
  }
  if (const Flight * flight = site.find_flight(id)) {
    return {flight->spec().upper_floor};
  }
  std::vector<std::string> up;
  for (const Flight & flight : site.flights()) {
    if (flight.spec().lower_floor == id) {
      up.push_back(flight.id());
    }
  }
  return up;
}

/// Breadth first: the fewest segments. Empty if there is no way.
std::vector<std::string> shortest(
  const Site & site, const std::string & from, const std::string & to, bool downwards)
{
  std::map<std::string, std::string> came_from{{from, ""}};
  std::deque<std::string> open{from};
  while (!open.empty() && came_from.count(to) == 0) {
    const std::string id = open.front();
    open.pop_front();
    for (const std::string & next : next_segments(site, id, downwards)) {
      if (!next.empty() && came_from.emplace(next, id).second) {
        open.push_back(next);
      }
    }
  }
  std::vector<std::string> way;
  if (came_from.count(to) != 0) {
    for (std::string id = to; !id.empty(); id = came_from.at(id)) {
      way.push_back(id);
    }
    std::reverse(way.begin(), way.end());
  }
  return way;
}

}  // namespace

Route find_route(const Site & site, const std::string & from, const std::string & to)
{
  for (const auto * id : {&from, &to}) {
    if (!knows(site, *id)) {
      return {{}, "segment '" + *id + "' is not in the site, accepted: " + known_segments(site)};
    }
  }
  Route route{shortest(site, from, to, false), ""};
  if (route.segments.empty()) {
    const auto any_way = shortest(site, from, to, true);
    route.refusal = "from '" + from + "' to '" + to + "' " +
                    (any_way.empty() ? "there is no way"
                                     : "stairs would have to be gone down, which is not supported");
  }
  return route;
}

}  // namespace stetro_supervisor
