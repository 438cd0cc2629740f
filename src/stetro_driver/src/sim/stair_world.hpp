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

#ifndef SIM__STAIR_WORLD_HPP_
#define SIM__STAIR_WORLD_HPP_

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/sim_errors.hpp"
#include "stetro_driver/stair_shape.hpp"

namespace stetro_driver::sim
{

/// Where a ray ends.
struct RayHit
{
  double distance_m;
  double cos_incidence;  ///< 1: square to the surface
};

/// A staircase as it was built, in the flight frame.
/**
 * Riser k (1..N) is the vertical plane x = X_k + tan(direction_k) (y - W/2), from the height of
 * step k-1 to that of step k. Step 0 is the floor below, step N goes on flush into the landing. The
 * right wall is y = 0, the left one is straight between the widths at the two ends.
 */
class StairWorld
{
public:
  /// What the site file says. \throws std::invalid_argument when lists are empty or not positive
  explicit StairWorld(const StairShape & shape);

  /// The same stairs as a builder left them, drawn from the seed.
  /** \param name of the stream of random numbers: of several flights each has its own */
  StairWorld(
    const StairShape & shape, const SimErrors & errors, std::uint64_t seed,
    std::string_view name = "world");

  /// Its risers end at its sides, as in a building where floors go on beside them.
  /** Else they go on for ever: nothing of a robot between the sides can tell. */
  void end_at_sides() { ends_at_sides_ = true; }

  /// Whether a riser goes as far as this point's y.
  [[nodiscard]] bool riser_spans(double x_m, double y_m) const
  {
    return !ends_at_sides_ || (y_m >= 0.0 && y_m <= width_m(x_m));
  }

  [[nodiscard]] int steps() const { return static_cast<int>(riser_x_m_.size()); }

  /// x of riser k's face at y. \param k 1..N
  [[nodiscard]] double riser_x_m(int k, double y_m) const;

  /// tan of riser k's direction against the y axis.
  [[nodiscard]] double riser_slope(int k) const;

  /// Height of step k. \param k 0..N
  [[nodiscard]] double height_m(int k) const;

  /// y of the left wall at x.
  [[nodiscard]] double width_m(double x_m) const;

  /// How the left wall turns away from the x axis [m/m].
  [[nodiscard]] double left_wall_slope() const { return left_slope_; }

  /// A side wall stands at x.
  [[nodiscard]] bool right_walled(double x_m) const { return right_walled_ && in_walls(x_m); }
  [[nodiscard]] bool left_walled(double x_m) const { return left_walled_ && in_walls(x_m); }

  /// How far the side walls go on past both ends.
  [[nodiscard]] double wall_overrun_m() const { return wall_overrun_m_; }

  /// The step under a point, 0..N; 0 beyond an open side.
  [[nodiscard]] int step_at(double x_m, double y_m) const;
  [[nodiscard]] double terrain_m(double x_m, double y_m) const;

  /// End of step N at mid-width, where the landing begins.
  [[nodiscard]] double length_m() const { return length_m_; }

  /// First surface that a ray meets. \param direction of unit length
  [[nodiscard]] std::optional<RayHit> cast(
    const Vector3 & origin, const Vector3 & direction, double reach_m) const;

private:
  struct Nearest;
  void build(const StairShape & shape);
  [[nodiscard]] bool in_walls(double x_m) const;
  void cast_walls(const Vector3 & o, const Vector3 & d, Nearest & nearest) const;
  void cast_risers(const Vector3 & o, const Vector3 & d, Nearest & nearest) const;
  void cast_treads(const Vector3 & o, const Vector3 & d, Nearest & nearest) const;

  std::vector<double> riser_x_m_;    // [k-1], at mid-width
  std::vector<double> riser_slope_;  // [k-1]
  std::vector<double> height_m_;     // [k], 0..N
  double mid_m_ = 0.0;
  double width_foot_m_ = 0.0;
  double left_slope_ = 0.0;
  double length_m_ = 0.0;
  bool right_walled_ = true;
  bool left_walled_ = true;
  double wall_overrun_m_ = 1.0;
  bool ends_at_sides_ = false;
};

}  // namespace stetro_driver::sim

#endif  // SIM__STAIR_WORLD_HPP_
