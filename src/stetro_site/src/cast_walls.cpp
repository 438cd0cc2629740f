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

#include "cast_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "beam_buffer.hpp"

namespace stetro_site
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A box or block that may hold something to be seen.
struct Prospect
{
  double q;  ///< the inverse of the distance to the box about it
  BeamSpan beams;
  std::int32_t child;
};

/// What eight walls look like from the scanner.
struct BlockView
{
  alignas(64) double a[kLanes];  ///< eq. (1)
  alignas(64) double b[kLanes];
  alignas(64) int first[kLanes];
  alignas(64) int last[kLanes];
  alignas(64) int wrapped[kLanes];
  alignas(64) int turned_away[kLanes];
  alignas(64) int edge_on[kLanes];
};

/// What eight boxes look like from the scanner.
struct NodeView
{
  alignas(64) double q[kLanes];
  alignas(64) int first[kLanes];
  alignas(64) int last[kLanes];
  alignas(64) int wrapped[kLanes];
};

/// One cast of the walls of a tree.
class Cast
{
public:
  Cast(const WallTree & walls, const Scanner & scanner, BeamBuffer & buffer)
  : walls_(walls),
    buffer_(buffer),
    scale_(scanner.fan),
    x_(scanner.from.x()),
    y_(scanner.from.y()),
    beams_(static_cast<int>(scanner.fan.count))
  {
  }

  STETRO_ALWAYS_INLINE void run();

private:
  STETRO_ALWAYS_INLINE void view(const BoxNode & node, NodeView & view) const;
  STETRO_ALWAYS_INLINE void view(const WallBlock & block, BlockView & view) const;
  STETRO_ALWAYS_INLINE void draw(const WallBlock & block);
  STETRO_ALWAYS_INLINE bool is_open(const Prospect & prospect) const;
  STETRO_ALWAYS_INLINE Prospect * push_children(const BoxNode & node, Prospect * top) const;
  void draw_edge_on(const WallBlock & block, int lane, const BeamSpan & span, double a, double b);

  const WallTree & walls_;
  BeamBuffer & buffer_;
  BeamScale scale_;
  double x_;
  double y_;
  int beams_;
};

/// The box's nearest point and the two corners between which it is seen.
void Cast::view(const BoxNode & node, NodeView & view) const
{
  constexpr double kBoxSlack = 1e-9;  // [rad], so that no wall reaches out of its box
  const double slack = scale_.slack(kBoxSlack);
  const double mirror = scale_.mirror();
  for (int i = 0; i < kLanes; ++i) {
    const double x0 = node.min_x[i] - x_;
    const double x1 = node.max_x[i] - x_;
    const double low = (node.min_y[i] - y_) * mirror;
    const double high = (node.max_y[i] - y_) * mirror;
    const double y0 = low < high ? low : high;
    const double y1 = low < high ? high : low;
    const bool right = x0 > 0.0;
    const bool left = x1 < 0.0;
    const bool above = y0 > 0.0;
    const bool below = y1 < 0.0;
    const double away_x = right ? x0 : (left ? x1 : 0.0);
    const double away_y = above ? y0 : (below ? y1 : 0.0);
    const double start_x = above ? x1 : (below ? x0 : away_x);
    const double end_x = above ? x0 : (below ? x1 : away_x);
    const double start_y = right ? y0 : (left ? y1 : away_y);
    const double end_y = right ? y1 : (left ? y0 : away_y);
    const double squared = away_x * away_x + away_y * away_y;
    const BeamSpan span =
      scale_.span(bearing_rad(start_x, start_y), bearing_rad(end_x, end_y), slack);
    const bool inside = !(squared > 0.0);
    view.q[i] = 1.0 / std::sqrt(squared);
    view.first[i] = inside ? 0 : span.first;
    view.last[i] = inside ? beams_ - 1 : span.last;
    view.wrapped[i] = inside ? -1 : span.wrapped;
  }
}

void Cast::view(const WallBlock & block, BlockView & view) const
{
  const double slack = scale_.slack(kAngleSlack);
  const double mirror = scale_.mirror();
  const bool both_sides = walls_.sides() == WallSides::kBoth;
  for (int i = 0; i < kLanes; ++i) {
    const double ax = block.ax[i] - x_;
    const double ay = (block.ay[i] - y_) * mirror;
    const double bx = block.bx[i] - x_;
    const double by = (block.by[i] - y_) * mirror;
    const double ex = block.bx[i] - block.ax[i];
    const double ey = (block.by[i] - block.ay[i]) * mirror;
    const double cross = ax * ey - ay * ex;
    const double a_rad = bearing_rad(ax, ay);
    const double b_rad = bearing_rad(bx, by);
    const bool clockwise = cross < 0.0;
    const BeamSpan span = scale_.span(clockwise ? b_rad : a_rad, clockwise ? a_rad : b_rad, slack);
    view.a[i] = ey / cross;
    view.b[i] = -ex / cross;
    view.first[i] = span.first;
    view.last[i] = span.last;
    view.wrapped[i] = span.wrapped;
    view.turned_away[i] = both_sides || cross * mirror > 0.0 ? 0 : 1;
    // Seen under less than 1e-9 rad, eq. (1) has lost its digits.
    const double squares = (ax * ax + ay * ay) * (bx * bx + by * by);
    view.edge_on[i] = cross * cross > 1e-18 * squares ? 0 : 1;
  }
}

void Cast::draw(const WallBlock & block)
{
  BlockView seen;
  view(block, seen);
  for (int i = 0; i < block.count; ++i) {
    if (seen.turned_away[i] != 0) {
      continue;
    }
    if (seen.edge_on[i] != 0) {
      draw_edge_on(block, i, {seen.first[i], seen.last[i], seen.wrapped[i]}, seen.a[i], seen.b[i]);
      continue;
    }
    buffer_.meet(seen.first[i], seen.last[i], seen.a[i], seen.b[i]);
    if (seen.wrapped[i] >= 0) {
      buffer_.meet(0, std::min(seen.wrapped[i], beams_ - 1), seen.a[i], seen.b[i]);
    }
  }
}

/// A wall that the scanner lies in line with, or on: no nearer and no farther than its points are.
void Cast::draw_edge_on(
  const WallBlock & block, int lane, const BeamSpan & span, double a, double b)
{
  const double mirror = scale_.mirror();
  const Eigen::Vector2d from(block.ax[lane] - x_, (block.ay[lane] - y_) * mirror);
  const Eigen::Vector2d to(block.bx[lane] - x_, (block.by[lane] - y_) * mirror);
  const double cross = from.x() * to.y() - from.y() * to.x();
  const bool between = from.dot(to) <= 0.0;
  double * q = buffer_.q();
  if (between && cross == 0.0) {
    std::fill_n(q, beams_, kInfinity);
    return;
  }
  const double far_q = 1.0 / std::max(from.norm(), to.norm());
  const double near_q = between ? kInfinity : 1.0 / std::min(from.norm(), to.norm());
  const bool in_line = !between && std::fabs(cross) <= 1e-12 * from.norm() * to.norm();
  const auto meet = [&](int first, int last) {
    for (int i = first; i <= last; ++i) {
      const double met = in_line ? near_q : a * buffer_.x()[i] + b * buffer_.y()[i];
      q[i] = std::max(q[i], std::clamp(met, far_q, near_q));
    }
  };
  meet(span.first, span.last);
  meet(0, std::min(span.wrapped, beams_ - 1));
}

bool Cast::is_open(const Prospect & prospect) const
{
  const BeamSpan & beams = prospect.beams;
  return buffer_.open(beams.first, beams.last, prospect.q) ||
         (beams.wrapped >= 0 && buffer_.open(0, beams.wrapped, prospect.q));
}

/// Puts what is in a node on the stack, the nearest on top.
Prospect * Cast::push_children(const BoxNode & node, Prospect * top) const
{
  NodeView seen;
  view(node, seen);
  Prospect * const bottom = top;
  for (int i = 0; i < node.count; ++i) {
    if (seen.first[i] > seen.last[i] && seen.wrapped[i] < 0) {
      continue;
    }
    Prospect * at = top++;
    for (; at != bottom && at[-1].q > seen.q[i]; --at) {
      *at = at[-1];
    }
    const int wrapped = std::min(seen.wrapped[i], beams_ - 1);
    *at = {seen.q[i], {seen.first[i], seen.last[i], wrapped}, node.child[i]};
  }
  return top;
}

void Cast::run()
{
  Prospect stack[WallTree::kDeepest * kLanes];
  Prospect * top = push_children(walls_.nodes().front(), stack);
  while (top != stack) {
    const Prospect nearest = *--top;
    if (!is_open(nearest)) {
      continue;
    }
    if (nearest.child < 0) {
      draw(walls_.blocks()[static_cast<std::size_t>(-1 - nearest.child)]);
    } else {
      top = push_children(walls_.nodes()[static_cast<std::size_t>(nearest.child)], top);
    }
  }
}

/// Casts a fan of no more than a turn.
STETRO_ALWAYS_INLINE void cast_turn(
  const WallTree & walls, const Scanner & scanner, double * ranges_m)
{
  thread_local BeamBuffer buffer;
  const double mirror = scanner.fan.step_rad < 0.0 ? -1.0 : 1.0;
  // A trifle beyond the reach, where the comparison below decides.
  buffer.reset(scanner.fan, mirror, (1.0 - 1e-12) / scanner.reach);
  Cast(walls, scanner, buffer).run();
  const double reach_m = scanner.reach * scanner.metres;
  const double * q = buffer.q();
  const std::size_t count = scanner.fan.count;
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    const double range_m = scanner.metres / q[i];
    ranges_m[i] = range_m <= reach_m ? range_m : kInfinity;
  }
}

void cast_turn_plain(const WallTree & walls, const Scanner & scanner, double * ranges_m)
{
  cast_turn(walls, scanner, ranges_m);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void cast_turn_avx2(
  const WallTree & walls, const Scanner & scanner, double * ranges_m)
{
  cast_turn(walls, scanner, ranges_m);
}

[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw")]] void cast_turn_avx512(
  const WallTree & walls, const Scanner & scanner, double * ranges_m)
{
  cast_turn(walls, scanner, ranges_m);
}
#endif

void cast_turn(
  const WallTree & walls, const Scanner & scanner, Instructions instructions, double * ranges_m)
{
#if defined(__x86_64__)
  if (instructions == Instructions::kAvx512) {
    return cast_turn_avx512(walls, scanner, ranges_m);
  }
  if (instructions == Instructions::kAvx2) {
    return cast_turn_avx2(walls, scanner, ranges_m);
  }
#endif
  cast_turn_plain(walls, scanner, ranges_m);
}

}  // namespace

bool available(Instructions instructions)
{
#if defined(__x86_64__)
  switch (instructions) {
    case Instructions::kAvx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    case Instructions::kAvx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Instructions::kPlain:
      break;
  }
#endif
  return instructions == Instructions::kPlain;
}

Instructions best_instructions()
{
  static const Instructions kBest = available(Instructions::kAvx512) ? Instructions::kAvx512
                                    : available(Instructions::kAvx2) ? Instructions::kAvx2
                                                                     : Instructions::kPlain;
  return kBest;
}

bool is_number(const Scanner & scanner)
{
  return scanner.from.allFinite() && std::isfinite(scanner.fan.first_rad) &&
         std::isfinite(scanner.fan.step_rad) && !std::isnan(scanner.reach);
}

void cast_walls(
  const WallTree & walls, const Scanner & scanner, Instructions instructions,
  std::vector<double> & ranges_m)
{
  const BeamFan & fan = scanner.fan;
  ranges_m.resize(fan.count);
  const bool numbers = is_number(scanner);
  if (!numbers || walls.empty() || !(scanner.reach > 0.0)) {
    const double nothing = numbers ? kInfinity : std::numeric_limits<double>::quiet_NaN();
    std::fill(ranges_m.begin(), ranges_m.end(), nothing);
    return;
  }
  // More than a turn is cast turn by turn, and beams without a step between them one by one.
  const double in_turn = std::floor(kTwoPi / std::fabs(fan.step_rad) + 1e-9);
  const std::size_t most = std::max<std::size_t>(
    1, fan.step_rad == 0.0 || in_turn < 1.0 ? 1 : static_cast<std::size_t>(std::min(in_turn, 1e6)));
  for (std::size_t done = 0; done < fan.count; done += most) {
    Scanner part = scanner;
    part.fan.first_rad += static_cast<double>(done) * fan.step_rad;
    part.fan.count = std::min(most, fan.count - done);
    part.fan.step_rad = part.fan.count == 1 ? 1.0 : fan.step_rad;
    cast_turn(walls, part, instructions, ranges_m.data() + done);
  }
}

}  // namespace stetro_site
