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

#ifndef SUPPORT__TOY_HOUSE_HPP_
#define SUPPORT__TOY_HOUSE_HPP_

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "stetro_site/site.hpp"
#include "stetro_supervisor/journey.hpp"
#include "support/toy_robot.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{

/// A robot in a building, and a localizer that can be wrong: closes the loop around a journey.
/**
 * On floors a point with a heading that obeys its wheels, with odometry, and a lidar of 360 beams
 * cast by `WallCaster` with 1 cm of noise; on flights `ToyRobot`, which takes over where the
 * localizer does: 1 m before the first riser, facing it, and until half a metre beyond the last.
 * The localizer tells the truth plus an offset on floors (`kidnap` makes one), takes corrections
 * that lie near what it says, and follows two that agree when it is lost.
 */
class ToyHouse
{
public:
  explicit ToyHouse(stetro_site::Site site);

  /// Puts the robot on a floor, pose in map.
  void place(const std::string & floor, const stetro_site::Pose & in_map);

  /// Puts it elsewhere on its floor; the localizer does not know.
  void kidnap(const stetro_site::Pose & in_map);

  /// Puts it on another floor; the localizer does not know.
  void kidnap(const std::string & floor, const stetro_site::Pose & in_map);

  void act(const MotionCommand & command, double dt_s);
  Observation look();
  void correct(const Correction & correction);

  [[nodiscard]] stetro_site::Pose in_map() const;  ///< the truth
  /// The truth on a flight's steps or floor, as the localizer should name it.
  [[nodiscard]] std::string segment() const;

  Time now{std::chrono::seconds(1000)};
  bool lost = false;                           ///< the localizer says so
  std::vector<stetro_site::Segment> unmapped;  ///< in the present floor's frame
  std::function<void(Observation &)> meddle;   ///< changes what is seen, last
  double drift = 0.0;  ///< share by which odometry, and the localizer with it, is too long
  int resets = 0;
  int refused = 0;            ///< corrections far from what the localizer says
  double worst_jump_m = 0.0;  ///< of the told pose in map, from tick to tick

private:
  void hand_over();
  void board(const stetro_site::Flight & flight, const stetro_site::Pose & at);
  void alight(const stetro_site::Flight & flight);
  Observation look_on_floor();
  std::shared_ptr<const Scan> scan();
  void tell(Observation & seen);

  stetro_site::Site site_;
  std::string floor_;
  std::string told_floor_;        // by the localizer
  stetro_site::Pose pose_;        // base_link in map
  stetro_site::Pose told_error_;  // told minus true, on floors, in map
  double steering_rad_ = 0.0;
  bool steering_moving_ = false;
  OdometryPose odometry_;
  const stetro_site::Flight * flight_ = nullptr;  // that the toy robot stands on
  std::map<std::string, ToyRobot> robots_;
  std::shared_ptr<const Scan> scan_;
  std::optional<Correction> waiting_;
  std::optional<stetro_site::Pose> last_told_;
  std::mt19937 random_{20260302};
};

}  // namespace stetro_supervisor

#endif  // SUPPORT__TOY_HOUSE_HPP_
