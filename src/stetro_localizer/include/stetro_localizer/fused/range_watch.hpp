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

#ifndef STETRO_LOCALIZER__FUSED__RANGE_WATCH_HPP_
#define STETRO_LOCALIZER__FUSED__RANGE_WATCH_HPP_

#include <array>

#include "stetro_localizer/fused/range_monitor.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// A block against where it stood last.
struct RaisedBlock
{
  bool stands = false;    ///< bears load and does not move
  double raised_m = 0.0;  ///< above where it bore load last; 0 where that is not known [m]
  bool in_place = false;  ///< the robot has not rolled since
  bool level = false;     ///< it then stood as high as block 3
};

/// Watches all eight range sensors: dead, stuck at a distance, or stuck at seeing nothing.
/**
 * A distance that repeats itself shows at once. One that sees nothing, or something too near, shows
 * when something else says what it must see:
 *
 *   block1_down, block2_down   the tread, while their block stands; none too near, once it is up
 *   block3_front               block 2's rear face, while both stand level; the riser ahead, once
 *                              block 2 is lifted
 *   front pair, stair_front    what the two others of the three see near by
 *
 * What a side sensor must see is the estimate's business, `FusedModel`. Samples count as they come:
 * one that is late says late what it says.
 */
class RangeWatch
{
public:
  /// \param bearing_load share of the weight of a block that stands
  RangeWatch(const stetro_site::RobotGeometry & robot, double bearing_load)
  : robot_(robot), bearing_load_(bearing_load)
  {
  }

  /// Takes heights and loads. \param travel_m way along x since any fixed moment [m]
  void note(const BlockSample & sample, double travel_m);

  /// Takes readings. \param riser_m from `base_link` to the riser ahead; NaN: unknown or none [m]
  void note(const RangeSample & sample, double travel_m, double riser_m);

  /// One has not answered for longer than `patience_s`, or never since `since`.
  [[nodiscard]] bool any_dead(Nanoseconds now, Nanoseconds since, double patience_s) const;
  /// One repeats itself, or has missed again and again what it must see.
  [[nodiscard]] bool any_stuck() const;

  [[nodiscard]] const RangeMonitor & operator[](Place place) const
  {
    return monitors_[stetro_site::index_of(place)];
  }

private:
  enum class Must { kNothing, kSee, kSeeFarther };

  [[nodiscard]] Must must(Place place, const RangeSample & sample, double riser_m) const;
  [[nodiscard]] Must must_down(const RaisedBlock & block) const;
  [[nodiscard]] Must must_behind(double riser_m) const;
  [[nodiscard]] bool others_see(Place place, const RangeSample & sample) const;

  stetro_site::RobotGeometry robot_;
  double bearing_load_;
  std::array<RangeMonitor, stetro_site::kPlaces.size()> monitors_{};
  std::array<RaisedBlock, 3> blocks_{};
  std::array<std::array<double, 3>, 3> stood_m_{};  // all heights, when each block stood last
  std::array<std::array<bool, 3>, 3> bore_{};       // and who bore load then
  std::array<double, 3> stood_at_m_{};              // travel then
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__RANGE_WATCH_HPP_
