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

#ifndef ACCURACY__JSON_FIGURES_HPP_
#define ACCURACY__JSON_FIGURES_HPP_

#include <cstdint>
#include <string>

#include "accuracy/error_distribution.hpp"
#include "nlohmann/json.hpp"

namespace stetro_bringup
{

using Json = nlohmann::ordered_json;

/// JSON has no NaN: what is not known is null.
[[nodiscard]] Json known(double value);

/// A count out of so many, and what it says of the rate behind it.
[[nodiscard]] Json rate(std::uint64_t count, std::uint64_t of);

/// Events that may come more than once a step, and what they say of their number a step.
[[nodiscard]] Json times_a_step(std::uint64_t times, std::uint64_t steps);

/// \param unit ends each key, such as "m"
[[nodiscard]] Json figures(const ErrorDistribution & errors, const std::string & unit);

}  // namespace stetro_bringup

#endif  // ACCURACY__JSON_FIGURES_HPP_
