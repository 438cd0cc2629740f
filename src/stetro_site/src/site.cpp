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

#include "stetro_site/site.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace stetro_site
{
namespace
{

template <class Segment>
const std::string & id_of(const Segment & segment)
{
  if constexpr (std::is_same_v<Segment, Floor>) {
    return segment.id;
  } else {
    return segment.id();
  }
}

template <class Segment>
const Segment * find(const std::vector<Segment> & segments, const std::string & id)
{
  const auto found = std::find_if(segments.begin(), segments.end(), [&](const Segment & segment) {
    return id_of(segment) == id;
  });
  return found == segments.end() ? nullptr : &*found;
}

template <class Segment>
std::string ids_of(const std::vector<Segment> & segments)
{
  std::string text;
  for (const Segment & segment : segments) {
    text += (text.empty() ? "" : ", ") + id_of(segment);
  }
  return text;
}

[[noreturn]] void refuse(const std::string & what, const std::string & id, const std::string & ids)
{
  throw std::out_of_range(what + " '" + id + "' refused, accepted: " + ids);
}

SiteSpec sound(SiteSpec spec)
{
  check_graph(spec).throw_if_any();
  return spec;
}

}  // namespace

stetro_config::Origin SiteSpec::origin(const std::string & key) const
{
  std::string above = key;
  while (!above.empty()) {
    const auto found = origins.find(above);
    if (found != origins.end()) {
      return found->second;
    }
    const auto end = above.find_last_of(".[");
    above.erase(end == std::string::npos ? 0 : end);
  }
  const auto root = origins.find("");
  return root == origins.end() ? stetro_config::Origin{} : root->second;
}

Site::Site(SiteSpec spec) : spec_(sound(std::move(spec))) {}

const Flight * Site::find_flight(const std::string & id) const noexcept
{
  return find(spec_.flights, id);
}

const Floor * Site::find_floor(const std::string & id) const noexcept
{
  return find(spec_.floors, id);
}

bool Site::has_drawn_floor() const noexcept
{
  return std::any_of(
    spec_.floors.begin(), spec_.floors.end(), [](const Floor & floor) { return floor.is_drawn(); });
}

const Flight & Site::flight(const std::string & id) const
{
  if (const Flight * found = find_flight(id)) {
    return *found;
  }
  refuse("flight", id, ids_of(spec_.flights));
}

const Floor & Site::floor(const std::string & id) const
{
  if (const Floor * found = find_floor(id)) {
    return *found;
  }
  refuse("floor", id, ids_of(spec_.floors));
}

std::vector<std::string> Site::neighbours(const std::string & id) const
{
  if (const Flight * flight = find_flight(id)) {
    return {flight->spec().lower_floor, flight->spec().upper_floor};
  }
  if (!find_floor(id)) {
    refuse("segment", id, ids_of(spec_.floors) + ", " + ids_of(spec_.flights));
  }
  std::vector<std::string> ids;
  for (const Flight & flight : spec_.flights) {
    if (flight.spec().lower_floor == id || flight.spec().upper_floor == id) {
      ids.push_back(flight.id());
    }
  }
  return ids;
}

Site load_site(const std::string & path)
{
  stetro_config::Faults faults;
  auto site = read_site(path, faults);
  faults.throw_if_any();
  return std::move(site).value();
}

}  // namespace stetro_site
