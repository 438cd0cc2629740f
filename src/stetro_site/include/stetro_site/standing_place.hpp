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

#ifndef STETRO_SITE__STANDING_PLACE_HPP_
#define STETRO_SITE__STANDING_PLACE_HPP_

#include <optional>
#include <string>

#include "stetro_site/flight.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_site
{

/// Why no robot stands so on a flight or before it; nothing if one can.
/**
 * The pose is `base_link` in the flight frame. It must be numbers, at the height of the step under
 * its x within half a riser, and between the sides. Which way it faces is left to whoever asks.
 */
[[nodiscard]] std::optional<std::string> misplaced(const Pose & pose, const Flight & flight);

}  // namespace stetro_site

#endif  // STETRO_SITE__STANDING_PLACE_HPP_
