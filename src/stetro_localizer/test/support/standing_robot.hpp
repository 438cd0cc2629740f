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

#ifndef SUPPORT__STANDING_ROBOT_HPP_
#define SUPPORT__STANDING_ROBOT_HPP_

#include <chrono>
#include <random>

#include "stetro_localizer/fused/cone.hpp"
#include "stetro_localizer/fused/fused_model.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{

constexpr double kWidth = 2.05;     // [m]
constexpr double kMount = 0.05;     // of a side sensor off the middle [m]
constexpr double kSquareTo = 0.19;  // from base_link to the front pair [m]

/// The model and a core that stands on tread 3, ready to sweep; time stands still.
class StandingRobot
{
public:
  explicit StandingRobot(unsigned seed = 1)
  : model_(LocalizerParams{}, robot_, papers_flight()), random_(seed), core(model_.begin())
  {
    core.steps.tell(3);
    for (int i = 0; i < 10; ++i) {
      BlockSample blocks;
      blocks.stamp = std::chrono::seconds(1000) + i * std::chrono::milliseconds(33);
      blocks.blocks[0] = {0.14, 0.33, true, false, false};
      blocks.blocks[1] = blocks.blocks[2] = {0.0, 0.33, true, false, false};
      model_.take(core, blocks);
    }
    core.filter.set(kStateYaw, 0.0, 0.175 * 0.175);
  }

  void know(int index, double value, double sigma) { core.filter.set(index, value, sigma * sigma); }

  /// A reading that the one before confirms. \return what became of it
  Outcome read(Place place, double range_m)
  {
    core.last_ranges[place] = {core.time, range_m, 0.0, RangeStatus::kValid};
    return read_once(place, range_m);
  }

  Outcome read_once(Place place, double range_m)
  {
    RangeSample sample;
    sample.stamp = core.time;
    sample[place] = {core.time, range_m, 0.0, RangeStatus::kValid};
    model_.take(core, sample);
    switch (place) {
      case Place::kSideLeft:
        return core.reports[Source::kSideLeft].outcome;
      case Place::kSideRight:
        return core.reports[Source::kSideRight].outcome;
      case Place::kFrontRight:
        return core.reports[Source::kFrontRight].outcome;
      case Place::kBlock3Front:
        return core.reports[Source::kBlock3Front].outcome;
      default:
        return core.reports[Source::kFrontLeft].outcome;
    }
  }

  /// Readings of one array, with noise of 1 mm, each confirmed by the one before.
  void read_pair(Place first, double first_m, Place second, double second_m)
  {
    RangeSample sample;
    sample.stamp = core.time;
    sample[first] = {core.time, first_m + 0.001 * normal_(random_), 0.0, RangeStatus::kValid};
    sample[second] = {core.time, second_m + 0.001 * normal_(random_), 0.0, RangeStatus::kValid};
    core.last_ranges[first] = sample[first];
    core.last_ranges[second] = sample[second];
    model_.take(core, sample);
  }

  /// A reading with noise, of a sensor square to a wall at that distance.
  double noisy(double square_m, double offset_m = 0.0, double gain = 0.0)
  {
    const double range_m = (1.0 + gain) * stretch() * square_m + offset_m;
    return range_m + robot_.range_sensor.sigma_at_m(range_m) * normal_(random_);
  }

  void take(const Sample & sample) { model_.take(core, sample); }
  [[nodiscard]] bool stuck_gyro() const { return model_.gyro_stuck(core); }
  [[nodiscard]] double suspected_turn_rad() const { return model_.suspected_turn_rad(core); }
  double random(double sigma) { return sigma * normal_(random_); }
  [[nodiscard]] double stretch() const
  {
    return ConeOnWall(robot_.range_sensor.cone_rad).stretch(0.0);
  }

private:
  stetro_site::RobotGeometry robot_;
  FusedModel model_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;

public:
  FusedCore core;
};

/// Puts it where the front pair is `square_m` before the riser that it sees.
inline void put_before_riser(StandingRobot & robot, double square_m, double sigma_m)
{
  robot.know(kStateY, 1.0, 0.005);
  robot.know(kStateX, robot.core.filter[kStateTreadAhead] - kSquareTo - square_m, sigma_m);
}

}  // namespace stetro_localizer

#endif  // SUPPORT__STANDING_ROBOT_HPP_
