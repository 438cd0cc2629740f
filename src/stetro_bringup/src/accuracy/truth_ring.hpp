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

#ifndef ACCURACY__TRUTH_RING_HPP_
#define ACCURACY__TRUTH_RING_HPP_

#include <array>
#include <cstddef>
#include <optional>

#include "stetro_driver/sim_robot.hpp"

namespace stetro_bringup
{

/// The truth of the last ticks, so that an estimate meets the truth of its own time.
class TruthRing
{
public:
  static constexpr std::size_t kKept = 128;  ///< ticks: 1.28 s

  /// Times rise from call to call.
  void add(const stetro_driver::GroundTruth & truth);

  /// The truth at a time: between two ticks the position is on the straight line between them.
  /** Step and heights are those of the earlier tick. Nothing outside what is kept. */
  [[nodiscard]] std::optional<stetro_driver::GroundTruth> at(stetro_driver::Time time) const;

private:
  [[nodiscard]] const stetro_driver::GroundTruth & back(std::size_t age) const
  {
    return ring_[(newest_ + kKept - age) % kKept];
  }

  std::array<stetro_driver::GroundTruth, kKept> ring_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__TRUTH_RING_HPP_
