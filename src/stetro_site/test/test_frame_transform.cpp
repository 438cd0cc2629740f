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

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "stetro_site/frame_transform.hpp"

namespace stetro_site
{
namespace
{

constexpr double kPi = 3.141592653589793;

TEST(FrameTransform, TurnsAndMovesByHand)
{
  const FrameTransform transform{{10.0, 20.0, 3.0, kPi / 2}};  // up the stairs is map's +y
  const Pose pose = transform.to_map(Pose{1.0, 0.5, 0.14, 0.1});
  EXPECT_NEAR(pose.x_m, 9.5, 1e-12);
  EXPECT_NEAR(pose.y_m, 21.0, 1e-12);
  EXPECT_NEAR(pose.z_m, 3.14, 1e-12);
  EXPECT_NEAR(pose.yaw_rad, kPi / 2 + 0.1, 1e-12);
}

TEST(FrameTransform, TurnsTheCovarianceWithTheFrame)
{
  const FrameTransform transform{{1.0, 2.0, 3.0, kPi / 2}};
  Covariance in_flight = Covariance::Zero();
  in_flight.diagonal() << 1.0, 4.0, 9.0, 0.1, 0.2, 0.3;
  in_flight(0, 5) = in_flight(5, 0) = 0.05;  // along the stairs against yaw
  const Covariance in_map = transform.to_map(in_flight);
  EXPECT_NEAR(in_map(0, 0), 4.0, 1e-12) << "across the stairs is now x";
  EXPECT_NEAR(in_map(1, 1), 1.0, 1e-12);
  EXPECT_NEAR(in_map(2, 2), 9.0, 1e-12);
  EXPECT_NEAR(in_map(3, 3), 0.2, 1e-12);
  EXPECT_NEAR(in_map(4, 4), 0.1, 1e-12);
  EXPECT_NEAR(in_map(5, 5), 0.3, 1e-12);
  EXPECT_NEAR(in_map(1, 5), 0.05, 1e-12);
  EXPECT_NEAR(in_map(0, 5), 0.0, 1e-12);
}

TEST(PlanarCovariance, IsThatOfXYAndYaw)
{
  Covariance covariance;
  for (int i = 0; i < 36; ++i) {
    covariance(i / 6, i % 6) = 10.0 * (i / 6) + i % 6;  // 35: row 3, column 5
  }
  Eigen::Matrix3d expected;
  expected << 0.0, 1.0, 5.0, 10.0, 11.0, 15.0, 50.0, 51.0, 55.0;
  EXPECT_EQ(planar(covariance), expected);
}

TEST(PlanarCovariance, IsSetAndTheRestStays)
{
  Covariance covariance = Covariance::Constant(-1.0);
  Eigen::Matrix3d part;
  part << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  set_planar(covariance, part);
  EXPECT_EQ(planar(covariance), part);
  EXPECT_EQ((covariance.array() == -1.0).count(), 27);
}

TEST(FrameTransform, WrapsTheHeading)
{
  EXPECT_NEAR(wrap_angle(3 * kPi / 2), -kPi / 2, 1e-12);
  EXPECT_NEAR(wrap_angle(-7.0), -7.0 + 2 * kPi, 1e-12);
  EXPECT_NEAR(
    FrameTransform({0, 0, 0, 3.0}).to_map(Pose{0, 0, 0, 3.0}).yaw_rad, 6 - 2 * kPi, 1e-12);
}

TEST(FrameTransform, RefusesAPoseThatIsNone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(FrameTransform({nan, 0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(FrameTransform({0, 0, 0, HUGE_VAL}), std::invalid_argument);
}

// Property: there and back is the identity, for poses, points and covariances, and a covariance
// stays symmetric and positive.
TEST(FrameTransform, ThereAndBackIsTheIdentity)
{
  std::mt19937 random{20250301};
  std::uniform_real_distribution<double> metre{-50.0, 50.0};
  std::uniform_real_distribution<double> yaw{-3.1, 3.1};
  for (int i = 0; i < 500; ++i) {
    const FrameTransform transform{{metre(random), metre(random), metre(random), yaw(random)}};
    const Pose pose{metre(random), metre(random), metre(random), yaw(random)};
    const Pose back = transform.to_frame(transform.to_map(pose));
    EXPECT_NEAR(back.x_m, pose.x_m, 1e-10);
    EXPECT_NEAR(back.y_m, pose.y_m, 1e-10);
    EXPECT_NEAR(back.z_m, pose.z_m, 1e-10);
    EXPECT_NEAR(back.yaw_rad, pose.yaw_rad, 1e-10);

    const Eigen::Vector3d point{pose.x_m, pose.y_m, pose.z_m};
    EXPECT_TRUE(transform.to_map(transform.to_frame(point)).isApprox(point, 1e-10));

    Covariance root;
    for (double & number : root.reshaped()) {
      number = yaw(random);
    }
    const Covariance covariance = root * root.transpose() + Covariance::Identity();
    const Covariance in_map = transform.to_map(covariance);
    EXPECT_TRUE(transform.to_frame(in_map).isApprox(covariance, 1e-10));
    EXPECT_TRUE(in_map.isApprox(in_map.transpose(), 1e-12));
    EXPECT_NEAR(in_map.determinant() / covariance.determinant(), 1.0, 1e-8);
  }
}

}  // namespace
}  // namespace stetro_site
