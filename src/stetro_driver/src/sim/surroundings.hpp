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

#ifndef SIM__SURROUNDINGS_HPP_
#define SIM__SURROUNDINGS_HPP_

#include <vector>

#include "sim/wall.hpp"

namespace stetro_driver::sim
{

/// What stands around a flight, in the flight frame: walls of its floors, and other flights.
/**
 * The flight's own risers and sides are the StairWorld's while the body is at its stairs. On the
 * open floor they are upright walls like all others, and the ground is level.
 */
struct Surroundings
{
  std::vector<Wall> at_stairs{};   ///< beside the flight itself
  std::vector<Wall> open_below{};  ///< on the open lower floor
  std::vector<Wall> open_above{};  ///< on the open upper floor
};

}  // namespace stetro_driver::sim

#endif  // SIM__SURROUNDINGS_HPP_
