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

#ifndef SIM__SIM_LIDAR_HPP_
#define SIM__SIM_LIDAR_HPP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/building.hpp"
#include "sim/clutter.hpp"
#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// A simulated lidar on block 2: a full turn of beams at one instant.
/**
 * Each beam goes to the nearest surface in the lidar's level plane, by its crossing with every
 * one. On a floor that somebody has drawn: its walls as drawn, boxes and people. Elsewhere: what
 * stands as high around the flight, its side walls and the risers above the plane. And the robot's
 * own blocks when they are lifted into the plane.
 */
class SimLidar
{
public:
  SimLidar(const LidarShape & shape, const SimErrors & errors, std::uint64_t seed);

  /// Scans when it is time to. \param floor drawn, on which the body is; or kNoFloor
  /// \return whether a scan has just been taken
  [[nodiscard]] bool observe(
    const SimBody & body, const Building & building, std::size_t flight, std::size_t floor,
    Clutter & clutter, std::uint64_t tick, Time now);

  /// The last scan.
  [[nodiscard]] const LidarScan & scan() const { return scan_; }

  /// Its true ranges, before noise and loss: of use to tests.
  [[nodiscard]] const std::vector<double> & true_ranges_m() const { return true_m_; }

  template <class Archive>
  void archive(Archive & each)
  {
    random_.archive(each);
  }

private:
  void see_floor(
    const SimBody & body, const Stairs & stairs, const Storey & storey, const Clutter & clutter);
  void see_flight(const SimBody & body);
  void see_own_blocks(const SimBody & body);
  void read(Time now);

  LidarShape shape_;
  double noise_m_;
  double lost_share_;
  std::uint64_t period_ticks_;
  RandomStream random_;
  std::vector<double> true_m_;
  LidarScan scan_{};
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_LIDAR_HPP_
