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
#ifndef STETRO_SUPERVISOR__HEADING_CORRECTION_HPP_
#define STETRO_SUPERVISOR__HEADING_CORRECTION_HPP_

namespace stetro_supervisor
{

struct ClimbParams;

/// Misalignment correction of S-P, with the faults D3-1, D3-11 and D1-6 put right.
/**
 * With psi the heading (CCW positive, 0 faces the riser) the body is turned at
 *
 *   wz = -sign(psi) * rate   from |psi| > dead band until |psi| <= dead band - hysteresis
 *
 * which lowers |psi| whichever way the robot travels: which wheel turns how is the driver's
 * knowledge (S-P swaps CW and CCW between its two directions, D3-11; its second branch tests
 * > -3 for < -3, D3-1). Beyond the paper, inside the dead band: a heading error while moving along
 * the tread drifts the robot along x, dx/dt = -vy sin(psi), so once the offset from the sweep line
 * leaves its window the heading leans the other way until the offset is back.
 */
class HeadingCorrection
{
public:
  /// Notes where the heading stands, once a tick: what the hysteresis remembers.
  /**
   * \param heading_rad psi [rad]
   * \param direction +1 travelling to the left, -1 to the right, 0 turning on the spot
   * \param offset_m distance beyond the sweep line, towards the riser [m]
   */
  void update(const ClimbParams & params, double heading_rad, int direction, double offset_m);

  /// Yaw rate in the body frame for the same arguments, CCW positive [rad/s].
  double rate_rps(
    const ClimbParams & params, double heading_rad, int direction, double offset_m) const;

  /// Yaw rate that takes away an error on the spot: proportional, at most the yaw rate [rad/s].
  static double turn_rate_rps(const ClimbParams & params, double error_rad);

private:
  bool correcting_ = false;
  bool leaning_ = false;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__HEADING_CORRECTION_HPP_
