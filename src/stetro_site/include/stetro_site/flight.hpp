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

#ifndef STETRO_SITE__FLIGHT_HPP_
#define STETRO_SITE__FLIGHT_HPP_

#include <string>
#include <vector>

#include "stetro_site/frame_transform.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_site
{

/// One step: its riser and the tread on top of it.
struct Step
{
  double riser_m;
  double tread_m;
};

/// What bounds a flight on one side.
enum class Side { kWalled, kOpen };

/// Everything a flight is made of.
struct FlightSpec
{
  std::string id;               ///< also the name of the flight frame
  std::vector<Step> steps;      ///< step 1 first
  double width_foot_m = 0.0;    ///< right side to left side at x = 0 [m]
  double width_top_m = 0.0;     ///< the same at the end of the last tread [m]
  Side right = Side::kWalled;   ///< at y = 0
  Side left = Side::kWalled;    ///< at y = width
  double wall_overrun_m = 1.0;  ///< how far the sides run on past both ends of the flight [m]
  Pose pose_in_map;             ///< of the flight frame
  std::string lower_floor;      ///< id of the floor below the first riser
  std::string upper_floor;      ///< id of the floor that continues the last tread
};

/// `count` equal steps.
[[nodiscard]] std::vector<Step> equal_steps(int count, double riser_m, double tread_m);

/// A flight of stairs in its own frame.
/**
 * Flight frame (D1-11): origin at the foot of the first riser at the right-hand side, x up the
 * stairs, y to the left (the distance from the right side), z up. Steps count from 1; step 0 is
 * the floor below, at x < 0 and z = 0. The last tread is flush with the floor above. For equal
 * steps, tread i spans x in [(i - 1) t, i t] at z = i r, which is S-B eq. (1); for others the
 * sums replace the products (D1-10).
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class Flight
{
public:
  /// \throws std::invalid_argument naming the field, its value and what is accepted
  explicit Flight(FlightSpec spec);

  [[nodiscard]] const std::string & id() const noexcept { return spec_.id; }
  [[nodiscard]] const FlightSpec & spec() const noexcept { return spec_; }

  /// Number of steps N, which is also the number of the last.
  [[nodiscard]] int steps() const noexcept { return static_cast<int>(spec_.steps.size()); }

  // Steps, i in 1..N. \throws std::out_of_range naming the step and what is accepted
  [[nodiscard]] double riser_m(int i) const;         ///< height of riser i [m]
  [[nodiscard]] double tread_m(int i) const;         ///< depth of tread i [m]
  [[nodiscard]] double riser_x_m(int i) const;       ///< the face of riser i [m]
  [[nodiscard]] double tread_start_m(int i) const;   ///< x where tread i begins: its own riser [m]
  [[nodiscard]] double tread_end_m(int i) const;     ///< x where tread i ends: the next riser [m]
  [[nodiscard]] double tread_centre_m(int i) const;  ///< x of the centre of tread i, eq. (1) [m]
  [[nodiscard]] double tread_z_m(int i) const;       ///< height of tread i; 0 for step 0 [m]

  /// The step under x: 0 before the first riser, N on the last tread and on the floor beyond.
  /** On a riser's face it is that riser's step. x must be a number. */
  [[nodiscard]] int step_at(double x_m) const;

  /// Right side to left side at x [m]: linear between foot and top, and on along the overrun.
  [[nodiscard]] double width_m(double x_m) const;
  [[nodiscard]] double narrowest_m() const;  ///< the least width between foot and top [m]
  [[nodiscard]] double widest_m() const;     ///< the greatest [m]

  [[nodiscard]] double total_rise_m() const { return z_m_.back(); }  ///< sum of risers [m]
  [[nodiscard]] double total_run_m() const { return x_m_.back(); }   ///< sum of treads [m]
  /// From the centre of the first tread to that of the last: what the papers call L (D1-10) [m].
  [[nodiscard]] double centre_to_centre_m() const;
  [[nodiscard]] double highest_riser_m() const;
  [[nodiscard]] double shortest_tread_m() const;

  /// Takes poses between the flight frame and `map`.
  [[nodiscard]] const FrameTransform & T_map_flight() const noexcept { return T_map_flight_; }

private:
  FlightSpec spec_;
  std::vector<double> x_m_;  ///< where tread i ends, from x_m_[0] = 0
  std::vector<double> z_m_;  ///< how high tread i is, from z_m_[0] = 0
  FrameTransform T_map_flight_;
};

}  // namespace stetro_site

#endif  // STETRO_SITE__FLIGHT_HPP_
