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

#ifndef STETRO_SITE__SENSOR_PLACE_HPP_
#define STETRO_SITE__SENSOR_PLACE_HPP_

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace stetro_site
{

/// Where a range sensor sits. Sensors are named by place, never by number (D1-14).
enum class Place {
  kFrontLeft,   ///< front pair, on block 1, forward
  kFrontRight,  ///< front pair, on block 1, forward
  kStairFront,  ///< between them, forward: is there another riser?
  kSideLeft,    ///< on block 2, to the left
  kSideRight,   ///< on block 2, to the right
  kBlock1Down,  ///< under block 1
  kBlock2Down,  ///< under block 2
  kBlock3Front  ///< on block 3, forward: sees the riser when block 2 is lifted
};

constexpr std::array<Place, 8> kPlaces{Place::kFrontLeft,  Place::kFrontRight, Place::kStairFront,
                                       Place::kSideLeft,   Place::kSideRight,  Place::kBlock1Down,
                                       Place::kBlock2Down, Place::kBlock3Front};

/// The place's position in `kPlaces`.
[[nodiscard]] constexpr std::size_t index_of(Place place)
{
  return static_cast<std::size_t>(place);
}

/// The name on the wire and in files, e.g. `front_left`.
[[nodiscard]] std::string name_of(Place place);

/// The place of that name, or nothing.
[[nodiscard]] std::optional<Place> place_named(const std::string & name);

/// The block that carries the sensor: 1 in front, 2, or 3 in the rear.
[[nodiscard]] int block_of(Place place);

/// Unit vector of the beam in `base_link`.
[[nodiscard]] Eigen::Vector3d beam_direction(Place place);

}  // namespace stetro_site

#endif  // STETRO_SITE__SENSOR_PLACE_HPP_
