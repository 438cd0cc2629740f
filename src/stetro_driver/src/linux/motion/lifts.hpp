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

#ifndef LINUX__MOTION__LIFTS_HPP_
#define LINUX__MOTION__LIFTS_HPP_

#include <array>
#include <cstddef>
#include <optional>

#include "linux/motion/chassis_config.hpp"
#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// How far block 1 (front) and block 3 (rear) are above block 2 [m].
using LiftExtensions = std::array<double, kPair>;

/// Undersides above the lowest of them, from extensions; needs no history.
[[nodiscard]] std::array<double, kBlocks> block_heights_m(const LiftExtensions & extensions_m);

/// What is known of the blocks that no servo can tell: it must outlive a restart.
struct BlocksKnown
{
  LiftExtensions extensions_m{};                     // when it was last looked
  std::array<bool, kBlocks> standing{};              // on the ground
  std::array<bool, kBlocks> locked{};                // at the upper lock
  std::array<LiftExtensions, kBlocks> stood_at_m{};  // extensions when the block last stood
};

/// The lift of one block, by the two lifts there are.
/**
 * Lifts sit in block 2. Block 1 is moved by the front one, block 3 by the rear one, and block 2 by
 * both at once against the outer blocks that stand. The goal of a lift runs at its speed and never
 * far ahead of where it is:
 *
 *   lifting   --(the whole stroke above where it stood)-------->  at the upper lock
 *   lifting   --(stopped by something, near the stroke)-------->  at the upper lock
 *   lifting   --(stopped by something, before)----------------->  jammed
 *   lowering  --(stopped by something)------------------------->  stands
 *   lowering  --(below where it stood, or the servo's end)----->  jammed, over nothing
 *
 * Servos do not feel the ground: a block stands when its lift was going down and has stood still
 * above its goal for a while. A load cannot be told from that and is NaN, unknown, but for a block
 * in the air.
 *
 * After a start or a loss, what stood stands if no block that stood has moved against another.
 * Else, and when nothing is known, the lowest blocks stand and those above them do not: lowering
 * one finds out.
 */
class Lifts
{
public:
  /// \param known of a program before this one
  explicit Lifts(const LiftsConfig & config, const std::optional<BlocksKnown> & known = {});

  /// What the servos say. The first time, and again after restart(), goals are where they are.
  void measure(Time now, const std::array<double, kPair> & servos_rad);
  /// Goals begin again where the lifts are, and nothing is under way.
  void restart();
  /// What jammed is tried again: a person has looked at it.
  void forgive() { jammed_ = {}; }
  /// For the next program. Nothing: nothing was measured yet.
  [[nodiscard]] std::optional<BlocksKnown> known() const
  {
    return known_ ? std::optional<BlocksKnown>{blocks_} : std::nullopt;
  }

  /// Lifts or lowers a block until that is done; the same again goes on with it.
  void start(MotionKind kind, int block);
  /// Blocks stay where they are; one that is being lowered ends its leg of 8 mm at most.
  /**
   * Whoever watches the ground sees it before a lift has stood still for long enough, and holds. A
   * block left hanging just above it, neither aloft nor standing, would leave both waiting.
   */
  void hold();
  /// Blocks stay where they are, at once.
  void stop();
  void advance(Time now, double dt_s);

  [[nodiscard]] std::array<double, kPair> servo_goals_rad() const;
  [[nodiscard]] std::array<BlockReading, kBlocks> readings() const;

private:
  struct Motion
  {
    MotionKind kind = MotionKind::kHold;
    int block = 0;
    bool done = false;
    bool held = false;
    double leg_m = 0.0;  // that is left of the last one, once it is held
  };

  [[nodiscard]] bool under_way() const { return motion_.block != 0 && !motion_.done; }
  void take_stock();
  [[nodiscard]] bool stands_as_before() const;
  [[nodiscard]] double behind_m() const;
  [[nodiscard]] double raised_m(int block, const LiftExtensions & extensions_m) const;
  void move_goals(double way_m);
  void watch_progress(Time now);
  void judge(Time now);
  void end(bool jammed);

  LiftsConfig config_;
  bool begun_ = false;  // goals are where it was measured
  bool known_ = false;
  BlocksKnown blocks_{};
  LiftExtensions measured_m_{};
  LiftExtensions goals_m_{};
  Motion motion_{};
  std::array<bool, kBlocks> jammed_{};
  LiftExtensions progress_m_{};  // where the lifts were when they last moved
  Time progress_at_{0};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__LIFTS_HPP_
