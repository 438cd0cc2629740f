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

#include "linux/motion/lifts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linux/motion/steering.hpp"
#include "linux/servo/herkulex_registers.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kLeash = 0.008;                            // goals go no further ahead [m]
constexpr double kStuckBehind = 0.004;                      // a lift so far behind is stopped [m]
constexpr double kHeldBehind = 0.0012;                      // and one that is told no more
constexpr double kStill = 0.0006;                           // less than this is no motion [m]
constexpr Time kStillFor = std::chrono::milliseconds{150};  // before it counts as stopped
constexpr double kArrived = 0.0015;                         // from the whole stroke [m]
constexpr double kLockMargin = 0.015;                       // a mechanical lock may come earlier
constexpr double kOffGround = 0.001;                        // above this it stands no more [m]
constexpr double kBelowStart = 0.01;                        // further down there is nothing [m]
constexpr double kLevel = 0.01;                             // so near to the lowest, it stands too
constexpr double kSettled = 0.005;                          // of blocks that stand, with no power
constexpr double kLowest = kRadPerCount * (kLowestCount - kCentreCount);
constexpr double kHighest = kRadPerCount * (kHighestCount - kCentreCount);

std::size_t index(int block) { return static_cast<std::size_t>(block - 1); }

// How far each lift goes when a block goes up by one.
LiftExtensions sense_of(int block)
{
  switch (block) {
    case 1:
      return {1.0, 0.0};
    case 2:
      return {-1.0, -1.0};
    default:
      return {0.0, 1.0};
  }
}

}  // namespace

std::array<double, kBlocks> block_heights_m(const LiftExtensions & extensions_m)
{
  const double lowest_m = std::min({0.0, extensions_m[0], extensions_m[1]});
  return {extensions_m[0] - lowest_m, 0.0 - lowest_m, extensions_m[1] - lowest_m};
}

Lifts::Lifts(const LiftsConfig & config, const std::optional<BlocksKnown> & known)
: config_(config), known_(known.has_value()), blocks_(known.value_or(BlocksKnown{}))
{
}

void Lifts::measure(Time now, const std::array<double, kPair> & servos_rad)
{
  for (std::size_t i = 0; i < kPair; ++i) {
    measured_m_[i] = config_.m_per_rad * joint_rad(config_.joints[i], servos_rad[i]);
  }
  if (!begun_) {
    begun_ = true;
    take_stock();
    goals_m_ = measured_m_;
    progress_m_ = measured_m_;
    progress_at_ = now;
  }
  blocks_.extensions_m = measured_m_;
}

void Lifts::take_stock()
{
  if (known_ && stands_as_before()) {
    return;
  }
  known_ = true;
  const auto heights = block_heights_m(measured_m_);
  blocks_ = {};
  for (std::size_t b = 0; b < kBlocks; ++b) {
    blocks_.standing[b] = heights[b] < kLevel;
    blocks_.stood_at_m[b] = measured_m_;
  }
}

bool Lifts::stands_as_before() const
{
  const auto then = block_heights_m(blocks_.extensions_m);
  const auto now = block_heights_m(measured_m_);
  for (std::size_t a = 0; a < kBlocks; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double moved_m = (now[a] - now[b]) - (then[a] - then[b]);
      if (blocks_.standing[a] && blocks_.standing[b] && std::abs(moved_m) > kSettled) {
        return false;
      }
    }
  }
  return true;
}

void Lifts::restart()
{
  begun_ = false;
  motion_ = {};
}

void Lifts::hold()
{
  if (under_way() && motion_.held) {
    return;
  }
  if (under_way()) {
    motion_.held = true;
    motion_.leg_m = motion_.kind == MotionKind::kLower ? kLeash : 0.0;
  } else {
    motion_ = {};
  }
}

// Once: a goal that followed what is measured would let a block creep down under its weight.
void Lifts::stop()
{
  if (under_way()) {
    goals_m_ = measured_m_;
  }
  motion_ = {};
}

void Lifts::start(MotionKind kind, int block)
{
  if (motion_.kind == kind && motion_.block == block) {
    motion_.held = false;
    return;
  }
  motion_ = {kind, block};
  jammed_[index(block)] = false;
  progress_m_ = measured_m_;
  progress_at_ = Time::max();  // counted from the first advance()
  if (blocks_.standing[index(block)]) {
    blocks_.stood_at_m[index(block)] = measured_m_;
    motion_.done = kind == MotionKind::kLower;
  }
}

double Lifts::raised_m(int block, const LiftExtensions & extensions_m) const
{
  const LiftExtensions sense = sense_of(block);
  const LiftExtensions & stood = blocks_.stood_at_m[index(block)];
  double sum = 0.0;
  double lifts = 0.0;
  for (std::size_t i = 0; i < kPair; ++i) {
    sum += sense[i] * (extensions_m[i] - stood[i]);
    lifts += std::abs(sense[i]);
  }
  return sum / lifts;
}

void Lifts::advance(Time now, double dt_s)
{
  if (!under_way()) {
    return;
  }
  const bool up = motion_.kind == MotionKind::kLift;
  const double most_m = config_.speed_m_s * dt_s;
  const double left_m = up ? config_.stroke_m - raised_m(motion_.block, goals_m_)
                           : raised_m(motion_.block, goals_m_) + kBelowStart;
  double way_m = std::clamp(left_m, 0.0, most_m);
  if (motion_.held) {
    way_m = std::min(way_m, motion_.leg_m);
    motion_.leg_m -= way_m;
  }
  move_goals((up ? 1.0 : -1.0) * way_m);
  watch_progress(now);
  if (under_way()) {
    judge(now);
  }
}

// The goals of all lifts that move together go on together, or wait for the one behind.
void Lifts::move_goals(double way_m)
{
  const LiftExtensions sense = sense_of(motion_.block);
  LiftExtensions next = goals_m_;
  for (std::size_t i = 0; i < kPair; ++i) {
    next[i] += sense[i] * way_m;
    const double servo = servo_rad(config_.joints[i], next[i] / config_.m_per_rad);
    if (servo < kLowest || servo > kHighest) {
      end(true);
      return;
    }
    const double ahead_m = std::abs(next[i] - measured_m_[i]);
    if (sense[i] != 0.0 && ahead_m > kLeash && ahead_m > std::abs(goals_m_[i] - measured_m_[i])) {
      return;
    }
  }
  goals_m_ = next;
}

void Lifts::watch_progress(Time now)
{
  bool moved = progress_at_ > now;
  for (std::size_t i = 0; i < kPair; ++i) {
    moved = moved || std::abs(measured_m_[i] - progress_m_[i]) > kStill;
  }
  if (moved) {
    progress_m_ = measured_m_;
    progress_at_ = now;
  }
}

void Lifts::judge(Time now)
{
  const int block = motion_.block;
  const std::size_t b = index(block);
  const double raised = raised_m(block, measured_m_);
  if (raised > kOffGround) {
    blocks_.standing[b] = false;
  }
  blocks_.locked[b] = blocks_.locked[b] && motion_.kind == MotionKind::kLift;
  const bool still = now - progress_at_ >= kStillFor;
  const bool stopped = still && behind_m() >= (motion_.held ? kHeldBehind : kStuckBehind);
  if (motion_.kind == MotionKind::kLift) {
    const bool near = raised >= config_.stroke_m - kLockMargin;
    if (raised >= config_.stroke_m - kArrived || (stopped && near)) {
      blocks_.locked[b] = true;
      end(false);
    } else if (stopped) {
      end(true);
    }
  } else if (stopped) {
    blocks_.standing[b] = true;
    end(false);
  } else if (still && raised < 0.0 && !motion_.held) {
    end(true);
  }
}

// On the way that is under way: a lift that droops under its block is ahead of its goal.
double Lifts::behind_m() const
{
  const LiftExtensions sense = sense_of(motion_.block);
  const double way = motion_.kind == MotionKind::kLift ? 1.0 : -1.0;
  double most_m = 0.0;
  for (std::size_t i = 0; i < kPair; ++i) {
    most_m = std::max(most_m, way * sense[i] * (goals_m_[i] - measured_m_[i]));
  }
  return most_m;
}

void Lifts::end(bool jammed)
{
  motion_.done = true;
  jammed_[index(motion_.block)] = jammed;
  goals_m_ = measured_m_;
}

std::array<double, kPair> Lifts::servo_goals_rad() const
{
  return {
    servo_rad(config_.joints[0], goals_m_[0] / config_.m_per_rad),
    servo_rad(config_.joints[1], goals_m_[1] / config_.m_per_rad)};
}

std::array<BlockReading, kBlocks> Lifts::readings() const
{
  const auto heights = block_heights_m(measured_m_);
  std::array<BlockReading, kBlocks> readings{};
  for (int block = 1; block <= 3; ++block) {
    const std::size_t b = index(block);
    BlockReading & reading = readings[b];
    reading.height_m = heights[b];
    reading.target_m = heights[b];
    const bool moving = under_way() && motion_.block == block && !motion_.held;
    if (moving && motion_.kind == MotionKind::kLift) {
      reading.target_m = heights[b] + config_.stroke_m - raised_m(block, measured_m_);
    } else if (moving) {
      reading.target_m = std::max(0.0, heights[b] - config_.stroke_m);
    }
    reading.moving = moving;
    reading.at_lower_lock = blocks_.standing[b];
    reading.at_upper_lock = blocks_.locked[b] && !blocks_.standing[b];
    reading.load = blocks_.standing[b] ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    reading.fault = jammed_[b];
  }
  return readings;
}

}  // namespace stetro_driver::linux_io
