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

#ifndef STETRO_LOCALIZER__FUSED__SWITCH_WATCH_HPP_
#define STETRO_LOCALIZER__FUSED__SWITCH_WATCH_HPP_

#include <array>
#include <cstddef>

#include "stetro_localizer/fused/expectation.hpp"
#include "stetro_localizer/fused/fused_core.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// Watches the six bumpers and the two riser switches: dead, stuck closed or stuck open.
/**
 * A dead one says so itself. A stuck one shows where it contradicts something else:
 *
 *   stuck closed   the estimate is farther from the wall or riser than it can err
 *   stuck open     a bumper: a neighbour is closed although this one leads it by more than bumpers
 *                  differ; a riser switch: the wheels push on against the other one
 *
 * A bumper that is stuck open and does not lead is told by nothing, and nothing is lost with it:
 * the one that leads closes first. What is found holds until the switch changes.
 */
class SwitchWatch
{
public:
  explicit SwitchWatch(const stetro_site::RobotGeometry & robot) : robot_(robot) {}

  /// \param core after the sample; \param steps of the flight
  void note(const ContactSample & sample, const FusedCore & core, int steps);
  void note(const OdometrySample & sample, const FusedCore & core);

  /// One said last that it does not know its state.
  [[nodiscard]] bool any_dead() const;
  [[nodiscard]] bool any_stuck() const;

private:
  static constexpr std::size_t kOfASide = 4;  // three bumpers and the riser switch behind them
  static constexpr std::size_t kCount = 2 * kOfASide;

  /// One switch, and since when something contradicts it; zero: nothing does.
  struct Watched
  {
    bool unknown = false;
    Nanoseconds contradicted_since{0};
    bool closed = false;
    bool stuck = false;
  };

  static void note_one(Watched & watched, const Switch & now);
  void contradict(Watched & watched, bool contradicted, Nanoseconds stamp);
  [[nodiscard]] Expectation bumper_gap(
    const FusedCore & core, std::size_t side, std::size_t block) const;
  [[nodiscard]] bool bumper_contradicted(
    const ContactSample & sample, const FusedCore & core, std::size_t side,
    std::size_t block) const;
  [[nodiscard]] bool riser_contradicted(const FusedCore & core, std::size_t side) const;

  stetro_site::RobotGeometry robot_;
  std::array<Watched, kCount> switches_{};
  Nanoseconds pushing_since_{0};  // with one riser switch closed
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__SWITCH_WATCH_HPP_
