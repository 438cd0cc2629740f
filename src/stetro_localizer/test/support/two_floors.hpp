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

#ifndef SUPPORT__TWO_FLOORS_HPP_
#define SUPPORT__TWO_FLOORS_HPP_

#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "stetro_localizer/building_estimator.hpp"

namespace stetro_localizer
{

/// A flight up along map's x, a landing whose frame is turned by a quarter, a flight back.
/**
 * ground (0) -- lower, 16 steps at (5, 0), yaw 0 -- landing (2.24) -- upper, 8 steps at
 * (10.12, 4.6), yaw pi -- first (3.36). The landing's frame stands at (1, 2), turned by pi/2.
 */
inline stetro_site::Site two_floors(bool drawn = true)
{
  const auto floor = [drawn](const char * id, const stetro_site::Pose & pose) {
    stetro_site::Floor one;
    one.id = id;
    one.pose_in_map = pose;
    if (drawn) {
      one.drawing =
        stetro_site::PolygonWalls{{{-20.0, -20.0}, {20.0, -20.0}, {20.0, 20.0}, {-20.0, 20.0}}, {}};
    }
    return one;
  };
  const auto flight = [](
                        const char * id, int steps, const stetro_site::Pose & pose,
                        const char * below, const char * above) {
    stetro_site::FlightSpec spec;
    spec.id = id;
    spec.steps = stetro_site::equal_steps(steps, 0.14, 0.32);
    spec.width_foot_m = spec.width_top_m = 2.05;
    spec.wall_overrun_m = 0.0;
    spec.pose_in_map = pose;
    spec.lower_floor = below;
    spec.upper_floor = above;
    return stetro_site::Flight(spec);
  };
  stetro_site::SiteSpec spec;
  spec.name = "two_floors";
  spec.floors = {
    floor("ground", {0.0, 0.0, 0.0, 0.0}), floor("landing", {1.0, 2.0, 2.24, M_PI / 2.0}),
    floor("first", {0.0, 0.0, 3.36, 0.0})};
  spec.flights = {
    flight("lower", 16, {5.0, 0.0, 0.0, 0.0}, "ground", "landing"),
    flight("upper", 8, {10.12, 4.6, 2.24, M_PI}, "landing", "first")};
  return stetro_site::Site(std::move(spec));
}

inline LocalizerSetup setup_of(const LocalizerParams & params, bool drawn = true)
{
  stetro_site::Site site = two_floors(drawn);
  const stetro_site::Flight flight = site.flight("lower");
  return {params, std::move(site), flight, stetro_site::RobotGeometry{}};
}

/// Sends what a robot far from all walls senses: wheels, gyroscope, level blocks, open switches.
class LevelRobot
{
public:
  explicit LevelRobot(Estimator & estimator) : estimator_(estimator) {}

  /// One round of 10 ms at this speed; every third one with ranges that see but the robot itself.
  void tick(double vx_mps, double vy_mps = 0.0, double wz_radps = 0.0)
  {
    now += std::chrono::milliseconds(10);
    ++rounds_;
    estimator_.add_odometry({now, vx_mps, vy_mps, wz_radps}, now);
    // Its reading changes from one to the next, as that of a living one.
    estimator_.add_gyro({now, wz_radps + gyro_bias_radps + (rounds_ % 2 ? 1e-5 : -1e-5)}, now);
    if (rounds_ % 10 == 0) {
      estimator_.add_contacts(open(), now);
      estimator_.tick(now);
    }
    if (rounds_ % 3 == 0) {
      estimator_.add_blocks(level(now), now);
      RangeSample ranges;
      ranges.stamp = now;
      for (RangeReading & reading : ranges.readings) {
        reading = {now, 0.0, 0.0, RangeStatus::kNoTarget};
      }
      for (const Place place : {Place::kBlock1Down, Place::kBlock2Down, Place::kBlock3Front}) {
        ranges[place] = {now, rounds_ % 2 ? 0.035 : 0.036, 0.002, RangeStatus::kValid};
      }
      estimator_.add_ranges(ranges, now);
    }
  }

  void drive(double time_s, double vx_mps, double vy_mps = 0.0, double wz_radps = 0.0)
  {
    for (int i = 0; i < std::lround(time_s * 100.0); ++i) {
      tick(vx_mps, vy_mps, wz_radps);
    }
  }

  [[nodiscard]] static BlockSample level(Nanoseconds stamp)
  {
    BlockSample sample;
    sample.stamp = stamp;
    for (BlockReading & block : sample.blocks) {
      block = {0.0, 1.0 / 3.0, true, false, false};
    }
    return sample;
  }

  Nanoseconds now = std::chrono::seconds(1000);
  double gyro_bias_radps = 0.0;

private:
  [[nodiscard]] ContactSample open() const
  {
    ContactSample sample;
    sample.stamp = now;
    sample.left.fill({true, false});
    sample.right.fill({true, false});
    sample.riser_left = sample.riser_right = {true, false};
    return sample;
  }

  Estimator & estimator_;
  int rounds_ = 0;
};

/// A correction on a floor, of 2 cm and half a degree.
inline PoseCorrection correction_at(
  const std::string & floor, const stetro_site::Pose & pose, Nanoseconds stamp,
  std::uint32_t reset_counter)
{
  PoseCorrection correction;
  correction.stamp = stamp;
  correction.floor_id = floor;
  correction.pose = pose;
  correction.covariance.diagonal() << 4e-4, 4e-4, 1.0, 1.0, 1.0, 8e-5;
  correction.reset_counter = reset_counter;
  return correction;
}

/// The pose of an estimate in `map`.
inline stetro_site::Pose in_map(const SegmentEstimator & estimator)
{
  return estimator.segment().T_map_segment.to_map(estimator.estimate().pose);
}

}  // namespace stetro_localizer

#endif  // SUPPORT__TWO_FLOORS_HPP_
