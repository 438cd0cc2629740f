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

#include "stetro_localizer/measurement/front_pair.hpp"
#include "support/papers_tables.hpp"

namespace stetro_localizer
{
namespace
{

using papers::kFrontBaselineCm;
using papers::kHeadingA;
using papers::kHeadingB;

constexpr double kDeg = M_PI / 180.0;

template <class Table>
double mean_signed_error_deg(const Table & table)
{
  double sum = 0.0;
  for (const auto & row : table) {
    sum += row.tof_deg - row.vn100_deg;
  }
  return sum / static_cast<double>(table.size());
}

// D1-6: the row called "+45, turned left, CCW" holds -44.2: the tables are clockwise positive.
TEST(PapersHeading, TablesAreClockwisePositive)
{
  for (const auto & table : {kHeadingA, kHeadingB}) {
    EXPECT_LT(table[1].vn100_deg, -40.0);
    EXPECT_LT(table[1].tof_deg, -40.0);
    EXPECT_GT(table[3].vn100_deg, 40.0);
    // Ours is their negative: the left beam reads more, psi is near +45 deg.
    const double difference_cm = kFrontBaselineCm * std::tan(-table[1].tof_deg * kDeg);
    EXPECT_GT(difference_cm, 0.0);
    EXPECT_NEAR(
      heading_from_pair(difference_cm / 100, kFrontBaselineCm / 100) / kDeg, -table[1].tof_deg,
      1e-9);
  }
}

// D1-8: all five errors have one sign; the means are -1.40 and -1.74 as printed (CW positive).
TEST(PapersHeading, SignedErrorsAreABias)
{
  EXPECT_NEAR(mean_signed_error_deg(kHeadingA), -1.402, 5e-4);
  EXPECT_NEAR(mean_signed_error_deg(kHeadingB), -1.74, 5e-4);
  for (const auto & table : {kHeadingA, kHeadingB}) {
    for (const auto & row : table) {
      EXPECT_LT(row.tof_deg - row.vn100_deg, 0.0) << row.label;
    }
  }
}

// S-A's errors are the differences; in S-B row 3 prints 0.80 where the difference is 2.00.
TEST(PapersHeading, PrintedErrorsAreTheDifferencesButForOne)
{
  for (const auto & row : kHeadingA) {
    EXPECT_NEAR(std::abs(row.tof_deg - row.vn100_deg), row.error_deg, 1e-9) << row.label;
  }
  for (std::size_t i = 0; i < kHeadingB.size(); ++i) {
    const auto & row = kHeadingB[i];
    EXPECT_NEAR(std::abs(row.tof_deg - row.vn100_deg), i == 2 ? 2.00 : row.error_deg, 1e-9);
  }
}

// D1-8: as a difference of ranges: 0.35 cm at 0 deg, 1.33 (S-B 2.07) at 44 deg, 1.19 on the other
// side: calibration data of a left/right bias, not the noise of oblique beams.
TEST(PapersHeading, ErrorsAreADifferenceOfRanges)
{
  const auto bias_cm = [](const papers::HeadingRow & row) {
    return kFrontBaselineCm * (std::tan(row.tof_deg * kDeg) - std::tan(row.vn100_deg * kDeg));
  };
  EXPECT_NEAR(bias_cm(kHeadingA[0]), -0.35, 0.005);
  EXPECT_NEAR(bias_cm(kHeadingA[1]), -1.33, 0.01);
  EXPECT_NEAR(bias_cm(kHeadingB[1]), -2.07, 0.02);
  EXPECT_NEAR(bias_cm(kHeadingA[3]), -1.19, 0.01);
}

/// A robot that turns on the spot before a riser, and Algorithm I's correction.
struct TurningRobot
{
  double psi_rad;  // counter-clockwise positive

  [[nodiscard]] double difference_m() const { return 0.20 * std::tan(psi_rad); }
  void rotate_cw() { psi_rad -= 0.1 * kDeg; }
  void rotate_ccw() { psi_rad += 0.1 * kDeg; }
};

// D1-6: psi > 0 asks for a clockwise turn. The command reduces |psi| from either side.
TEST(PapersHeading, CommandReducesTheMisalignment)
{
  for (const double start_deg : {-20.0, -4.0, 3.5, 15.0}) {
    TurningRobot robot{start_deg * kDeg};
    for (int i = 0; i < 300; ++i) {
      const double before = std::abs(robot.psi_rad);
      const double measured = heading_from_pair(robot.difference_m(), 0.20);
      measured > 0.0 ? robot.rotate_cw() : robot.rotate_ccw();
      if (before > 0.1 * kDeg) {
        ASSERT_LT(std::abs(robot.psi_rad), before) << "from " << start_deg << " deg";
      }
    }
    EXPECT_LE(std::abs(robot.psi_rad), 0.11 * kDeg);
  }
}

// With the printed eq. (2), theta = atan((d2 - d1) / D), "theta > 0 -> rotateCW" runs away.
TEST(PapersHeading, PrintedSignsAreAPositiveFeedback)
{
  TurningRobot robot{1.0 * kDeg};
  for (int i = 0; i < 100; ++i) {
    const double theta = std::atan2(-robot.difference_m(), 0.20);
    theta > 0.0 ? robot.rotate_cw() : robot.rotate_ccw();
  }
  EXPECT_NEAR(robot.psi_rad, 11.0 * kDeg, 1e-9);
}

}  // namespace
}  // namespace stetro_localizer
