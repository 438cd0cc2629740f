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
#ifndef STETRO_SUPERVISOR__RANGE_MEDIAN_HPP_
#define STETRO_SUPERVISOR__RANGE_MEDIAN_HPP_

#include <array>
#include <cstddef>
#include <optional>

#include "stetro_supervisor/observation.hpp"

namespace stetro_supervisor
{

/// The median of a sensor's last three sound readings: one spurious return moves nothing.
class RangeMedian
{
public:
  /// Takes a reading that is newer than the last; one that is not sound makes the sensor unsound.
  void take(const Range & range);

  /// Nothing if the last reading is not sound or fewer than three were taken; +inf if nothing is
  /// within reach, 0 if something is nearer than the sensor can measure [m].
  std::optional<double> value_m() const;

  Time time() const { return last_; }

private:
  std::array<double, 3> last_three_m_{};
  std::size_t count_ = 0;
  Time last_{0};
  bool sound_ = false;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__RANGE_MEDIAN_HPP_
