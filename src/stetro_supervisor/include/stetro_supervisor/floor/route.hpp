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

#ifndef STETRO_SUPERVISOR__FLOOR__ROUTE_HPP_
#define STETRO_SUPERVISOR__FLOOR__ROUTE_HPP_

#include <string>
#include <vector>

#include "stetro_site/site.hpp"

namespace stetro_supervisor
{

/// The segments from one to another in the order they are passed, both ends included.
struct Route
{
  std::vector<std::string> segments;  ///< empty: there is none
  std::string refusal;                ///< why not, in words
};

/// The way through a building with the fewest segments, flights being climbed only upwards.
/**
 * A route that begins or ends on a flight begins or ends at its foot or on one of its steps: from
 * there the robot only goes up, so such a flight is entered from its lower floor and left to its
 * upper one. Of ways that are equally long, the one over the flight that the file names first.
 */
[[nodiscard]] Route find_route(
  const stetro_site::Site & site, const std::string & from, const std::string & to);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__ROUTE_HPP_
