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

#ifndef STETRO_SUPERVISOR__FLOOR__SCAN_HPP_
#define STETRO_SUPERVISOR__FLOOR__SCAN_HPP_

#include "stetro_supervisor/profile/range_profile.hpp"
#include "stetro_supervisor/time.hpp"

namespace stetro_supervisor
{

/// One turn of the lidar.
struct Scan
{
  Time time{0};             ///< of its first beam
  RangeProfile profile;     ///< in the lidar's own axes
  double duration_s = 0.0;  ///< from the first beam to the last [s]
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__SCAN_HPP_
