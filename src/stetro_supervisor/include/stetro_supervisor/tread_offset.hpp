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
#ifndef STETRO_SUPERVISOR__TREAD_OFFSET_HPP_
#define STETRO_SUPERVISOR__TREAD_OFFSET_HPP_

#include <optional>

namespace stetro_supervisor
{

/// How far the robot is beyond its sweep line, towards the riser.
/**
 * The sweep line is where the robot stood when it had backed off the riser. From there odometry
 * adds up; where the middle front sensor sees the riser after next, its range, against the range
 * seen on the line, pulls the sum back (a first-order blend). So the depth of the next tread, which
 * is not exactly the site's, does not matter. On treads N-1 and N it sees nothing and odometry
 * stands alone. (The outer front sensors are no use for this: at a wall they see the wall.)
 */
class TreadOffset
{
public:
  /// The robot is on its sweep line now; the front range on it is still to be seen.
  void zero();

  /// Adds a roll along x [m].
  void roll(double along_m) { offset_m_ += along_m; }

  /// Blends in the middle front range along x [m], measured `dt_s` after the last.
  void see(double front_m, double dt_s);

  double value_m() const { return offset_m_; }
  bool has_reference() const { return reference_m_.has_value(); }

private:
  double offset_m_ = 0.0;
  double sum_m_ = 0.0;
  int count_ = 0;
  std::optional<double> reference_m_;  // front range on the sweep line
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__TREAD_OFFSET_HPP_
