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

#ifndef ACCURACY__NOTICING_HPP_
#define ACCURACY__NOTICING_HPP_

#include <cstdint>
#include <vector>

#include "accuracy/fault_watch.hpp"
#include "accuracy/step_watch.hpp"

namespace stetro_bringup
{

/// What became of the injected faults of one scenario.
struct FaultNoticing
{
  std::uint64_t struck = 0;           ///< while the estimate was OK, or became OK later
  std::uint64_t missed = 0;           ///< of these, never noticed
  std::uint64_t in_time = 0;          ///< noticed within a second of motion
  std::uint64_t in_telling_time = 0;  ///< noticed within a second of telling motion
  double latest_s = 0.0;              ///< of the noticed ones
  double latest_telling_s = 0.0;      ///< likewise, in telling motion
};

[[nodiscard]] FaultNoticing noticing_of(const std::vector<Detection> & detections);

/// What became of the miscounts.
struct MiscountNoticing
{
  std::uint64_t began = 0;
  std::uint64_t before_next_climb = 0;  ///< noticed before block 2 was lifted again
  std::uint64_t within_one_step = 0;    ///< noticed before it was lifted a second time
  std::uint64_t corrected = 0;          ///< right again without having been noticed
  std::uint64_t unnoticed = 0;          ///< wrong and OK when the climb ended
  /// Noticed ones by the climbs begun until then, 0 first; no longer than it needs to be.
  std::vector<std::uint64_t> by_climbs;
};

[[nodiscard]] MiscountNoticing noticing_of(const std::vector<Miscount> & miscounts);

}  // namespace stetro_bringup

#endif  // ACCURACY__NOTICING_HPP_
