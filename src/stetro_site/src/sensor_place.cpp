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

#include "stetro_site/sensor_place.hpp"

namespace stetro_site
{
namespace
{

struct PlaceFacts
{
  const char * name;
  int block;
  double x, y, z;  // of the beam
};

constexpr std::array<PlaceFacts, kPlaces.size()> kFacts{{
  {"front_left", 1, 1.0, 0.0, 0.0},
  {"front_right", 1, 1.0, 0.0, 0.0},
  {"stair_front", 1, 1.0, 0.0, 0.0},
  {"side_left", 2, 0.0, 1.0, 0.0},
  {"side_right", 2, 0.0, -1.0, 0.0},
  {"block1_down", 1, 0.0, 0.0, -1.0},
  {"block2_down", 2, 0.0, 0.0, -1.0},
  {"block3_front", 3, 1.0, 0.0, 0.0},
}};

const PlaceFacts & facts_of(Place place) { return kFacts.at(index_of(place)); }

}  // namespace

std::string name_of(Place place) { return facts_of(place).name; }

std::optional<Place> place_named(const std::string & name)
{
  for (const Place place : kPlaces) {
    if (facts_of(place).name == name) {
      return place;
    }
  }
  return std::nullopt;
}

int block_of(Place place) { return facts_of(place).block; }

Eigen::Vector3d beam_direction(Place place)
{
  const PlaceFacts & facts = facts_of(place);
  return {facts.x, facts.y, facts.z};
}

}  // namespace stetro_site
