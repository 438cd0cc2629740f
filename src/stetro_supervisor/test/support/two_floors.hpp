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

#ifndef SUPPORT__TWO_FLOORS_HPP_
#define SUPPORT__TWO_FLOORS_HPP_

#include <string>

#include "stetro_site/site.hpp"

namespace stetro_supervisor
{

/// Two floors and a landing between them; the flights have `lower_steps` and `upper_steps`.
/**
 * `ground` is 5 m by 4 m with a column in it, `landing` and `first` 2.5 m by 4.6 m and 5 m by 4 m.
 * Flight `lower` begins at the right end of `ground`, runs along x and ends at `landing`; `upper`
 * begins there and runs back. Each floor's walls include the well of the stairs that join it, the
 * frame of `first` is moved and turned against map.
 */
stetro_site::Site two_floors(int lower_steps, int upper_steps);

}  // namespace stetro_supervisor

#endif  // SUPPORT__TWO_FLOORS_HPP_
