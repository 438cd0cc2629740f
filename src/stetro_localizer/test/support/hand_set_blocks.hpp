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

#ifndef SUPPORT__HAND_SET_BLOCKS_HPP_
#define SUPPORT__HAND_SET_BLOCKS_HPP_

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "stetro_localizer/step_filter.hpp"
#include "support/stair_models.hpp"

namespace stetro_localizer
{

constexpr Nanoseconds kPeriod{33'333'333};

/// A robot whose blocks are set by hand, sent at 30 Hz.
class HandSetBlocks
{
public:
  explicit HandSetBlocks(const StepModel & stairs = papers()) : filter(stairs) {}

  /// Samples of one posture; the last event, but kSettled only if there was no other.
  StepEvent hold(
    std::array<double, 3> heights_m, std::array<bool, 3> bearing, int samples = 8, int moving = 0)
  {
    StepEvent last = StepEvent::kNone;
    for (int i = 0; i < samples; ++i) {
      now += kPeriod;
      const StepEvent event = filter.add(sample(heights_m, bearing, moving), evidence);
      const bool quiet = event == StepEvent::kNone || event == StepEvent::kSettled;
      last = quiet && last != StepEvent::kNone ? last : event;
      const double sum = filter.probability_elsewhere() + shares();
      EXPECT_NEAR(sum, 1.0, 1e-12);
    }
    return last;
  }
  StepEvent stand(std::array<double, 3> heights_m) { return hold(heights_m, {true, true, true}); }

  /// The climb of house from a sweep of tread i.
  void climb()
  {
    hold({0.14, 0.18, 0.0}, {true, false, true});
    hold({0.14, 0.14, 0.0}, {true, true, true});
    hold({0.10, 0.10, 0.0}, {true, true, false});
    hold({0.0, 0.0, 0.04}, {true, true, false});
    hold({0.18, 0.0, 0.04}, {false, true, false});
    hold({0.14, 0.0, 0.04}, {true, true, false});
    hold({0.14, 0.0, 0.0}, {true, true, true});
  }

  [[nodiscard]] BlockSample sample(
    std::array<double, 3> heights_m, std::array<bool, 3> bearing, int moving) const
  {
    BlockSample out;
    out.stamp = now;
    const double share = 1.0 / (bearing[0] + bearing[1] + bearing[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool moves = static_cast<int>(i) + 1 == moving;
      out.blocks[i] = {heights_m[i], bearing[i] ? share : 0.0, true, moves, false};
    }
    return out;
  }

  StepFilter filter;
  StepEvidence evidence;
  Nanoseconds now = std::chrono::seconds(1000);

private:
  [[nodiscard]] double shares() const
  {
    double sum = 0.0;
    for (int step = -10; step <= kSteps + 10; ++step) {
      sum += filter.probability_of(step);
    }
    return sum;
  }
};

inline HandSetBlocks sweeping(int step)
{
  HandSetBlocks blocks;
  blocks.filter.tell(step);
  blocks.stand({0.14, 0.0, 0.0});
  return blocks;
}

inline HandSetBlocks aloft_over(int step)
{
  HandSetBlocks blocks = sweeping(step);
  blocks.hold({0.14, 0.18, 0.0}, {true, false, true});
  return blocks;
}

}  // namespace stetro_localizer

#endif  // SUPPORT__HAND_SET_BLOCKS_HPP_
