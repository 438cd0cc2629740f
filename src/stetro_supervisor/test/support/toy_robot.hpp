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
#ifndef SUPPORT__TOY_ROBOT_HPP_
#define SUPPORT__TOY_ROBOT_HPP_

#include <array>
#include <functional>
#include <string>

#include "stetro_site/flight.hpp"
#include "stetro_supervisor/climb.hpp"

namespace stetro_supervisor
{

/// A robot of three blocks on stairs, without noise: just enough to close the loop around a climb.
/**
 * It has no code in common with the product's simulation: blocks have a height and a footprint,
 * a block stops at a riser or a wall, a riser switch or bumper closes within half a millimetre, and
 * a switch that touches alone turns the robot square unless `pivots` is off. The localizer is
 * perfect, and counts the step block 2 stands on.
 */
class ToyRobot
{
public:
  explicit ToyRobot(ClimbGeometry geometry);

  /// Executes a command for one tick and lets time pass [s].
  void act(const MotionCommand & command, double dt_s);

  /// Everything the climb would see now.
  Observation look() const;

  Time now{std::chrono::seconds(1000)};
  double x_m = -0.6;
  double y_m = 1.0;
  double heading_rad = 0.0;
  std::array<double, 3> z_m{};  ///< undersides of blocks 1 to 3 above the floor
  double steering_rad = 0.0;
  int counted_step = 0;
  bool counts = true;  ///< the localizer counts steps
  bool pivots = true;
  bool spins = false;  ///< wheels turn on against a riser, and odometry with them
  double turn_disturbance_rps = 0.0;
  std::uint32_t resets = 0;  ///< jumps of the localizer
  std::uint64_t driver_instance = 7;
  std::function<void(Observation &)> meddle;  ///< changes what is seen, last

private:
  double surface_m(double x) const;
  double support_m(int block) const;
  double face_ahead_m(double from_x, double height) const;
  double sideways_m() const;
  bool blocked(double dx) const;
  void roll(double vx, double dt_s);
  void traverse(const MotionCommand & command, double dt_s);
  void move_block(int block, double dz, double limit);
  double switch_gap_m(int side) const;
  Range range(double metres) const;
  Contacts contacts() const;
  Blocks blocks() const;

  ClimbGeometry geometry_;
  std::array<double, 3> lift_top_m_{1e9, 1e9, 1e9};
  std::array<bool, 3> moving_{};
  bool steering_moving_ = false;
  OdometryPose odometry_;
};

/// The stairs of the papers, with few steps.
ClimbGeometry stairs(int steps);

/// The same stairs as the site has them; at their foot the floor `ground`.
stetro_site::Flight flight_of(const ClimbGeometry & geometry);

/// Ticks a climb around the robot until a condition holds; false if it does not within `limit_s`.
bool run_until(
  Climb & climb, ToyRobot & robot, double limit_s, const std::function<bool()> & condition);

bool run_to_state(Climb & climb, ToyRobot & robot, State state, double limit_s = 600.0);

/// Where it stands, for the message of a failure.
std::string where(const Climb & climb, const ToyRobot & robot);

}  // namespace stetro_supervisor

#endif  // SUPPORT__TOY_ROBOT_HPP_
