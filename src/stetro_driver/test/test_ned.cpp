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

#include <gtest/gtest.h>

#include <random>

#include "linux/imu/ned.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;
constexpr double kGravity = 9.8;

double wrapped(double angle_rad) { return std::remainder(angle_rad, 2.0 * kPi); }

/// What the VN-100 shows, and what that is in REP 103, each worked out with the hands.
struct Posture
{
  const char * words;
  double ned_deg[3];  ///< roll, pitch, yaw as on the VN-100
  double enu_deg[3];  ///< roll, pitch, yaw of base_link
  Axes force_frd;     ///< at rest, in the VN-100's axes, in g
};

const double kCos30 = std::cos(30 * kDegree);
const Posture kPostures[] = {
  {"level, facing north", {0, 0, 0}, {0, 0, 90}, {0, 0, -1}},
  {"level, facing east", {0, 0, 90}, {0, 0, 0}, {0, 0, -1}},
  {"level, facing south", {0, 0, 180}, {0, 0, -90}, {0, 0, -1}},
  {"level, facing west", {0, 0, -90}, {0, 0, 180}, {0, 0, -1}},
  {"level, a little east of north", {0, 0, 17}, {0, 0, 73}, {0, 0, -1}},
  {"nose up, facing east", {0, 30, 90}, {0, -30, 0}, {0.5, 0, -kCos30}},
  {"nose down, facing north", {0, -30, 0}, {0, 30, 90}, {-0.5, 0, -kCos30}},
  {"right side down, facing east", {30, 0, 90}, {30, 0, 0}, {0, -0.5, -kCos30}},
  {"left side down, facing south", {-30, 0, 180}, {-30, 0, -90}, {0, 0.5, -kCos30}},
  {"on its head, facing east", {180, 0, 90}, {180, 0, 0}, {0, 0, 1}},
};

TEST(Ned, EachPostureReadsAsWorkedOutByHand)
{
  const ImuMounting straight(0.0, 0.0, 0.0);
  for (const Posture & posture : kPostures) {
    const double * ned = posture.ned_deg;
    const Quaternion q =
      straight.to_base(from_euler(ned[0] * kDegree, ned[1] * kDegree, ned[2] * kDegree));
    const Axes euler = to_euler(q);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(wrapped(euler[i] - posture.enu_deg[i] * kDegree), 0.0, 1e-9)
        << posture.words << ", angle " << i;
    }
    // At rest the ground pushes the robot up, whichever way it lies.
    const Axes force = straight.to_base(Axes{
      kGravity * posture.force_frd[0], kGravity * posture.force_frd[1],
      kGravity * posture.force_frd[2]});
    const Axes in_world = rotated(q, force);
    EXPECT_NEAR(in_world[0], 0.0, 1e-9) << posture.words;
    EXPECT_NEAR(in_world[1], 0.0, 1e-9) << posture.words;
    EXPECT_NEAR(in_world[2], kGravity, 1e-9) << posture.words;
  }
}

TEST(Ned, TurningLeftIsPositive)
{
  const ImuMounting straight(0.0, 0.0, 0.0);
  // The VN-100 of the papers showed -44.2 degrees after a turn of 45 degrees to the left.
  const Axes before = to_euler(straight.to_base(from_euler(0.0, 0.0, 0.0)));
  const Axes after = to_euler(straight.to_base(from_euler(0.0, 0.0, -44.2 * kDegree)));
  EXPECT_NEAR(after[2] - before[2], 44.2 * kDegree, 1e-9);
  EXPECT_EQ(straight.to_base(Axes{0.0, 0.0, -0.5})[2], 0.5) << "z of the sensor looks down";
  EXPECT_EQ(straight.to_base(Axes{0.0, 0.3, 0.0})[1], -0.3) << "nose up is negative in REP 103";
  EXPECT_EQ(straight.to_base(Axes{0.2, 0.0, 0.0})[0], 0.2) << "right side down is positive in both";
}

TEST(Ned, AMountingIsTakenOutOfAttitudeAndRates)
{
  // Turned a quarter to the left on the robot: its printed x looks to the robot's left.
  const ImuMounting quarter(0.0, 0.0, kPi / 2);
  EXPECT_NEAR(quarter.to_base(Axes{1.0, 0.0, 0.0})[1], 1.0, 1e-12);
  EXPECT_NEAR(quarter.to_base(Axes{0.0, 1.0, 0.0})[0], 1.0, 1e-12) << "printed y looks ahead";
  // The sensor looks north, so the robot looks east.
  EXPECT_NEAR(to_euler(quarter.to_base(from_euler(0.0, 0.0, 0.0)))[2], 0.0, 1e-12);
  // Screwed on its head: printed z looks up.
  const ImuMounting overhead(kPi, 0.0, 0.0);
  EXPECT_NEAR(overhead.to_base(Axes{0.0, 0.0, 0.5})[2], 0.5, 1e-12);
  EXPECT_NEAR(overhead.to_base(Axes{0.0, 0.0, kGravity})[2], kGravity, 1e-12);
}

Quaternion random_attitude(std::mt19937 & random)
{
  std::normal_distribution<double> normal;
  Quaternion q{normal(random), normal(random), normal(random), normal(random)};
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/// The same rotation, whichever of its two signs a quaternion has.
double difference(const Quaternion & a, const Quaternion & b)
{
  return 1.0 - std::fabs(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
}

// Property: there and back is the identity, for any attitude and any mounting.
TEST(Ned, ThereAndBackIsTheIdentity)
{
  std::mt19937 random{20260311};
  std::uniform_real_distribution<double> angle{-kPi, kPi};
  for (int i = 0; i < 2000; ++i) {
    const ImuMounting mounting(angle(random), angle(random) / 2, angle(random));
    const Quaternion q = random_attitude(random);
    EXPECT_NEAR(difference(mounting.to_sensor(mounting.to_base(q)), q), 0.0, 1e-12) << i;
    const Axes v{angle(random), angle(random), angle(random)};
    const Axes back = mounting.to_sensor(mounting.to_base(v));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(back[axis], v[axis], 1e-12) << i;
    }
    const Axes euler = to_euler(q);
    EXPECT_NEAR(difference(from_euler(euler[0], euler[1], euler[2]), q), 0.0, 1e-9) << i;
  }
}

// Property: a vector that the sensor sees is the same arrow of the world by either road, through
// north-east-down by the sensor's own attitude, or through base_link.
TEST(Ned, BothRoadsToTheWorldAgree)
{
  std::mt19937 random{20260312};
  std::uniform_real_distribution<double> angle{-kPi, kPi};
  for (int i = 0; i < 2000; ++i) {
    const ImuMounting mounting(angle(random), angle(random) / 2, angle(random));
    const Quaternion sensor_in_ned = random_attitude(random);
    const Axes seen{angle(random), angle(random), angle(random)};
    const Axes ned = rotated(sensor_in_ned, seen);
    const Axes enu = rotated(mounting.to_base(sensor_in_ned), mounting.to_base(seen));
    EXPECT_NEAR(enu[0], ned[1], 1e-9) << "east, " << i;
    EXPECT_NEAR(enu[1], ned[0], 1e-9) << "north, " << i;
    EXPECT_NEAR(enu[2], -ned[2], 1e-9) << "up, " << i;
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
