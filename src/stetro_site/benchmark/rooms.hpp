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

#ifndef STETRO_SITE__BENCHMARK__ROOMS_HPP_
#define STETRO_SITE__BENCHMARK__ROOMS_HPP_

#include <cstddef>
#include <cstdint>

#include "random_scenes.hpp"

namespace stetro_site
{

constexpr std::size_t kBeams = 1440;
constexpr double kReach = 1e6;        ///< beyond everything: all that is there is seen
constexpr std::size_t kPlaces = 200;  ///< cast from in turn
constexpr int kGridBoxes = 45;        ///< gives mean ranges of 92 and 373 cells, as published

/// The room of so many walls that all casters are measured in.
inline RandomRoom bench_room(std::int64_t walls)
{
  return RandomRoom(static_cast<std::size_t>(walls), kPlaces, 7);
}

}  // namespace stetro_site

#endif  // STETRO_SITE__BENCHMARK__ROOMS_HPP_
