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

#include <cmath>
#include <random>

#include "stetro_localizer/measurement/front_pair.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kDeg = M_PI / 180.0;
constexpr double kBaseline = 0.20;

// D1-6: turned left, counter-clockwise, the left beam reads more, and psi is positive.
TEST(FrontPair, IsPositiveCounterClockwise)
{
  EXPECT_NEAR(heading_from_pair(0.20, kBaseline), 45 * kDeg, 1e-12);
  EXPECT_NEAR(heading_from_pair(-0.20, kBaseline), -45 * kDeg, 1e-12);
  EXPECT_EQ(heading_from_pair(0.0, kBaseline), 0.0);
}

// The beams of a robot turned by psi in front of a riser, worked by geometry.
TEST(FrontPair, RecoversTheHeadingBeforeAWall)
{
  for (const double yaw_deg : {-30.0, -5.0, 1.0, 20.0}) {
    const double yaw = yaw_deg * kDeg;
    const auto beam_m = [yaw](double mount_y_m) {
      const double start_x = -mount_y_m * std::sin(yaw);  // of the beam, turned with the robot
      return (0.3 - start_x) / std::cos(yaw);
    };
    EXPECT_NEAR(heading_from_pair(beam_m(0.1) - beam_m(-0.1), kBaseline), yaw, 1e-12);
  }
}

// D1-7: one degree is 0.35 cm; +-3 cm on one sensor is 8.5 deg, of opposite signs 16.7 deg.
TEST(FrontPair, HasTheSensitivityOfItsBaseline)
{
  EXPECT_NEAR(heading_from_pair(0.0035, kBaseline), 1.0 * kDeg, 0.01 * kDeg);
  EXPECT_NEAR(heading_from_pair(0.03, kBaseline), 8.5 * kDeg, 0.05 * kDeg);
  EXPECT_NEAR(heading_from_pair(0.06, kBaseline), 16.7 * kDeg, 0.05 * kDeg);
  EXPECT_NEAR(heading_from_pair(0.03, 0.45), 3.8 * kDeg, 0.05 * kDeg);
}

// D1-7: a standard deviation of 0.93 deg is 0.23 cm of each sensor.
TEST(FrontPair, PropagatesTheRangeNoise)
{
  const double variance = heading_variance(0.0, kBaseline, 2 * 0.0023 * 0.0023);
  EXPECT_NEAR(std::sqrt(variance), 0.93 * kDeg, 0.01 * kDeg);
}

TEST(FrontPair, VarianceAgreesWithMonteCarlo)
{
  std::mt19937 random{20260302};
  const double sigma_m = 0.003;
  for (const double difference_m : {0.0, 0.05, 0.15}) {
    std::normal_distribution<double> noisy{difference_m, sigma_m};
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kRuns = 20000;
    for (int i = 0; i < kRuns; ++i) {
      const double psi = heading_from_pair(noisy(random), kBaseline);
      sum += psi;
      squares += psi * psi;
    }
    const double mean = sum / kRuns;
    const double variance = squares / kRuns - mean * mean;
    const double expected = heading_variance(difference_m, kBaseline, sigma_m * sigma_m);
    EXPECT_NEAR(variance / expected, 1.0, 0.04) << "difference " << difference_m;
  }
}

}  // namespace
}  // namespace stetro_localizer
