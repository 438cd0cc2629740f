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

#ifndef METRES_HPP_
#define METRES_HPP_

#include <cmath>
#include <string>

#include "stetro_config/value.hpp"

namespace stetro_site
{

/// A length for people: to a tenth of a millimetre, without what sums of doubles leave behind.
inline std::string metres(double length_m)
{
  return stetro_config::to_text(std::round(length_m * 1e4) / 1e4);
}

}  // namespace stetro_site

#endif  // METRES_HPP_
