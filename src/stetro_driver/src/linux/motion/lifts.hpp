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
 * behind its goal for a while. At the start all blocks are taken to stand. A load cannot be told
 * from that and is NaN, unknown, but for a block in the air.
 */
class Lifts
{
public:
  explicit Lifts(const LiftsConfig & config) : config_(config) {}

  /// What the servos say. The first time, and again after restart(), goals are where they are.
  void measure(Time now, const std::array<double, kPair> & servos_rad);
  /// Goals begin again where the lifts are, and nothing is under way. What stood stands.
  void restart();

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
  [[nodiscard]] const LiftExtensions & extensions_m() const { return measured_m_; }
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
  [[nodiscard]] double raised_m(int block, const LiftExtensions & extensions_m) const;
  void move_goals(double way_m);
  void watch_progress(Time now);
  void judge(Time now);
  void end(bool jammed);

  LiftsConfig config_;
  bool known_ = false;
  LiftExtensions measured_m_{};
  LiftExtensions goals_m_{};
  Motion motion_{};
  std::array<LiftExtensions, kBlocks> stood_at_m_{};  // extensions when the block last stood
  std::array<bool, kBlocks> standing_{true, true, true};
  std::array<bool, kBlocks> locked_{};  // by something that stopped it near the stroke
  std::array<bool, kBlocks> jammed_{};
  LiftExtensions progress_m_{};  // where the lifts were when they last moved
  Time progress_at_{0};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__LIFTS_HPP_
