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
#include <functional>
#include <limits>

#include "stetro_localizer/paper_estimator.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

class BadInput : public ::testing::Test
{
protected:
  BadInput() : estimator_(params(), stetro_site::RobotGeometry{}, papers_flight())
  {
    estimator_.begin({});
    robot_.stand_on(3);
    robot_.rest(1.0);
  }

  static LocalizerParams params()
  {
    LocalizerParams params;
    params.initial_step = 3;
    return params;
  }

  void expect_unharmed()
  {
    robot_.rest(0.2);
    EXPECT_EQ(estimator_.estimate().integrity, Integrity::kOk)
      << reason_names(estimator_.estimate().reasons);
    EXPECT_NEAR(estimator_.estimate().pose.y_m, 1.0, 1e-6);
    EXPECT_NEAR(estimator_.estimate().pose.yaw_rad, 0.0, 1e-6);
    EXPECT_EQ(estimator_.estimate().step, 3);
  }

  [[nodiscard]] std::uint64_t refused(Source source, Refusal why) const
  {
    return estimator_.reports()[source].refused[static_cast<std::size_t>(why)];
  }

  PaperEstimator estimator_;
  StairRobot robot_{estimator_};
};

TEST_F(BadInput, BadStampsAreRefusedAndCountedForEveryInput)
{
  const Nanoseconds now = robot_.now;
  struct Case
  {
    Nanoseconds stamp;
    Refusal why;
  };
  const Case cases[]{
    {Nanoseconds{0}, Refusal::kZeroStamp},
    {now + seconds(3600), Refusal::kFuture},
    {now - milliseconds(500), Refusal::kOutOfOrder},
  };
  for (const Case & bad : cases) {
    RangeSample ranges = robot_.ranges();
    BlockSample blocks = robot_.blocks();
    ranges.stamp = blocks.stamp = bad.stamp;
    ContactSample contacts;
    contacts.stamp = bad.stamp;
    EXPECT_EQ(estimator_.add_ranges(ranges, now).refusal, bad.why);
    EXPECT_EQ(estimator_.add_blocks(blocks, now).refusal, bad.why);
    EXPECT_EQ(estimator_.add_contacts(contacts, now).refusal, bad.why);
    EXPECT_EQ(estimator_.add_gyro({bad.stamp, 1.0}, now).refusal, bad.why);
    EXPECT_EQ(estimator_.add_odometry({bad.stamp, 1.0, 1.0, 1.0}, now).refusal, bad.why);
    for (const Source input : InputWatch::kInputs) {
      EXPECT_EQ(refused(input, bad.why), 1u) << to_string(input) << ", " << to_string(bad.why);
    }
  }
  expect_unharmed();
}

TEST_F(BadInput, LateSamplesAreRefused)
{
  const Nanoseconds later = robot_.now + seconds(1);
  EXPECT_EQ(
    estimator_.add_gyro({robot_.now + milliseconds(1), 1.0}, later).refusal, Refusal::kTooOld);
  expect_unharmed();
}

TEST_F(BadInput, NumbersThatAreNoneAreRefused)
{
  for (const double bad : {kNan, kInf, -kInf}) {
    const Nanoseconds stamp = robot_.now + milliseconds(1);
    EXPECT_EQ(estimator_.add_gyro({stamp, bad}, robot_.now).refusal, Refusal::kNotFinite);
    EXPECT_EQ(
      estimator_.add_odometry({stamp, 0.0, bad, 0.0}, robot_.now).refusal, Refusal::kNotFinite);
    BlockSample blocks = robot_.blocks();
    blocks.stamp = stamp;
    blocks.blocks[1].height_m = bad;
    EXPECT_EQ(estimator_.add_blocks(blocks, robot_.now).refusal, Refusal::kNotFinite);
  }
  BlockSample below = robot_.blocks();
  below.stamp = robot_.now + milliseconds(1);
  below.blocks[0].height_m = -0.01;
  EXPECT_EQ(estimator_.add_blocks(below, robot_.now).refusal, Refusal::kNegative);
  expect_unharmed();
}

// A range that calls itself valid and is none does not reach the estimate (D1-5).
TEST_F(BadInput, RangesThatAreNoneAreNotSeen)
{
  for (const double bad : {kNan, kInf, -kInf, -0.2}) {
    robot_.now += milliseconds(10);
    RangeSample ranges = robot_.ranges();
    for (RangeReading & reading : ranges.readings) {
      reading.status = RangeStatus::kValid;
      reading.range_m = bad;
    }
    EXPECT_FALSE(estimator_.add_ranges(ranges, robot_.now).is_refused());
    EXPECT_TRUE(std::isfinite(estimator_.estimate().pose.y_m));
    EXPECT_TRUE(std::isfinite(estimator_.estimate().pose.yaw_rad));
  }
  expect_unharmed();
}

// 65535 mm, and a spurious near reading: gated or out of range, never W - 819 cm.
TEST_F(BadInput, ImpossibleRangesAreGated)
{
  for (const double bad : {65.535, 8.190, 0.02}) {
    robot_.now += milliseconds(33);
    RangeSample ranges = robot_.ranges();
    ranges[Place::kSideRight] = {robot_.now, bad, 0.0, RangeStatus::kValid};
    ranges[Place::kFrontLeft] = {robot_.now, bad, 0.0, RangeStatus::kValid};
    estimator_.add_ranges(ranges, robot_.now);
    EXPECT_EQ(estimator_.reports()[Source::kSideRight].outcome, Outcome::kGated) << bad;
    EXPECT_NE(estimator_.reports()[Source::kFrontPair].outcome, Outcome::kFused) << bad;
    EXPECT_NEAR(estimator_.estimate().pose.y_m, 1.0, 1e-6) << bad;
  }
  expect_unharmed();
}

TEST_F(BadInput, SilenceIsNoticedAndEnds)
{
  estimator_.tick(robot_.now + milliseconds(400));
  EXPECT_EQ(estimator_.estimate().integrity, Integrity::kOk);
  estimator_.tick(robot_.now + milliseconds(700));
  EXPECT_EQ(estimator_.estimate().integrity, Integrity::kDegraded);
  EXPECT_TRUE(estimator_.estimate().reasons & kInputSilent);
  robot_.rest(0.2);
  estimator_.tick(robot_.now);
  EXPECT_EQ(estimator_.estimate().integrity, Integrity::kOk);
}

TEST_F(BadInput, ThePublishedStampNeverRunsBackwards)
{
  const Nanoseconds before = estimator_.estimate().stamp;
  RangeSample old = robot_.ranges();
  old.stamp = before - milliseconds(100);
  estimator_.add_ranges(old, robot_.now);
  estimator_.tick(robot_.now - seconds(10));
  EXPECT_EQ(estimator_.estimate().stamp, before);
}

}  // namespace
}  // namespace stetro_localizer
