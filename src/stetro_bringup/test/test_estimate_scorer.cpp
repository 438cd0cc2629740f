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

#include "accuracy/estimate_scorer.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;
using stetro_localizer::Integrity;
using stetro_supervisor::State;

constexpr std::uint32_t kBothSides = 0b11000;
constexpr std::uint32_t kLeftOnly = 0b10000;

stetro_site::Flight four_steps()
{
  stetro_site::FlightSpec spec;
  spec.id = "stairs";
  spec.steps = stetro_site::equal_steps(4, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.0;
  return stetro_site::Flight(spec);
}

/// A scorer of one estimate that stands on tread 2 without any error, tick by tick of 10 ms.
class EstimateScorerTest : public testing::Test
{
protected:
  EstimateScorerTest()
  {
    now.accepted = true;
    now.refreshed = true;
    now.state = State::kSweepLeft;
    now.in_sight = kBothSides;
    now.time = 1000'000ms;
    now.estimate.integrity = Integrity::kOk;
    now.estimate.tread_covariance.diagonal().setConstant(1e-4);
    now.estimate.protection_along_m = 0.010;
    now.estimate.protection_across_m = 0.020;
    now.estimate.protection_heading_rad = 0.030;
    stand_on(2);
  }

  /// Both the robot and what is said of it.
  void stand_on(int step)
  {
    truly_on(step);
    say(step);
  }

  void truly_on(int step)
  {
    now.truth.step = step;
    now.truth.x_m = 0.32 * (step - 1) + 0.235;
    now.truth.y_m = 1.0;
    now.truth.z_m = 0.14 * step;
    now.truth.tread_x_m = 0.235;
    now.truth.riser_ahead_m = 0.085;
    now.truth.block_heights_m = {0.14 * (step + 1), 0.14 * step, 0.14 * step};
  }

  void say(int step)
  {
    now.estimate.step = step;
    now.estimate.pose = {0.32 * (step - 1) + 0.235, 1.0, 0.14 * step, 0.0};
    now.estimate.tread_x_m = 0.235;
    now.estimate.riser_ahead_m = 0.085;
    now.estimate.block_heights_m = {0.14 * (step + 1), 0.14 * step, 0.14 * step};
  }

  void err_in_y(double error_m) { now.estimate.pose.y_m = now.truth.y_m + error_m; }

  void tick(int count = 1)
  {
    for (int i = 0; i < count; ++i) {
      now.time += 10ms;
      now.elapsed_s += 0.01;
      now.truth.time = now.time;
      if (now.refreshed) {
        now.estimate.stamp = now.time;
        now.truth_at_stamp = now.truth;
      }
      scorer.watch(now);
    }
  }

  void lift_on(int step)
  {
    const State before = now.state;
    stand_on(step);
    now.state = State::kLiftBlock2;
    tick();
    now.state = before;
  }

  /// On tread 2 with the first one behind it, the touch-down counted.
  void past_the_first_tread()
  {
    lift_on(1);
    stand_on(2);
    tick();
  }

  const stetro_site::Flight flight = four_steps();
  EstimateScorer scorer{flight, std::nullopt};
  Moment now;
};

// The robot moved 1.5 mm and the estimate 5.5 mm across; 2 mm and 1 mm along.
TEST_F(EstimateScorerTest, AHandOverIsTheIncrementLessTheTrueOne)
{
  past_the_first_tread();
  tick();
  now.in_sight = kLeftOnly;
  now.truth.y_m += 0.0015;
  now.estimate.pose.y_m += 0.0055;
  now.truth.x_m += 0.002;
  now.truth.riser_ahead_m -= 0.002;
  now.estimate.pose.x_m += 0.001;
  now.estimate.riser_ahead_m -= 0.001;
  tick();
  tick();  // the same set: whatever it does is no hand-over
  now.estimate.pose.y_m += 0.010;
  tick();
  const ClimbScore score = scorer.take();
  ASSERT_EQ(score.hand_overs.size(), 1u);
  EXPECT_NEAR(score.hand_overs[0].y_m, 0.004, 1e-12);
  EXPECT_NEAR(score.hand_overs[0].x_m, -0.001, 1e-12);
}

TEST_F(EstimateScorerTest, AnErrorThatStaysIsNoJump)
{
  past_the_first_tread();
  err_in_y(0.015);
  tick();
  now.in_sight = kLeftOnly;
  tick();
  const ClimbScore score = scorer.take();
  ASSERT_EQ(score.hand_overs.size(), 1u);
  EXPECT_NEAR(score.hand_overs[0].y_m, 0.0, 1e-12);
}

TEST_F(EstimateScorerTest, HandsNothingOverAcrossATreadAStopOrTheFirstTread)
{
  stand_on(1);
  tick();
  now.in_sight = kLeftOnly;  // on the first tread
  tick();
  past_the_first_tread();
  now.in_sight = kBothSides;
  stand_on(3);  // with the change of tread
  tick();
  now.state = State::kPaused;
  tick();
  now.in_sight = kLeftOnly;  // while it stood
  now.state = State::kSweepLeft;
  tick();
  truly_on(4);  // touched down, not counted yet
  now.in_sight = kBothSides;
  tick();
  say(4);
  now.in_sight = kLeftOnly;
  tick();
  EXPECT_TRUE(scorer.take().hand_overs.empty());
}

// 21 estimates beyond the level across, 20 mm: 0.2 s from the first to the last.
TEST_F(EstimateScorerTest, TimesTheLongestStretchBeyondALevel)
{
  past_the_first_tread();
  err_in_y(0.021);
  tick(21);
  err_in_y(0.019);
  tick();
  err_in_y(-0.021);
  tick(11);
  const ClimbScore score = scorer.take();
  EXPECT_NEAR(score.longest_exceedance_s, 0.20, 1e-12);
  EXPECT_EQ(score.treads, 2u);
  EXPECT_EQ(score.treads_exceeded, 1u);
}

// 101 estimates last 1.00 s, which is tolerated; 102 do not.
TEST_F(EstimateScorerTest, CountsTreadsBeyondALevelForLongerThanASecond)
{
  past_the_first_tread();
  now.estimate.integrity_risk = 1e-4;
  err_in_y(0.021);
  tick(101);
  err_in_y(0.0);
  tick();
  stand_on(3);
  err_in_y(0.021);
  tick(102);
  const ClimbScore score = scorer.take();
  EXPECT_EQ(score.treads, 3u);
  EXPECT_EQ(score.treads_exceeded, 2u);
  EXPECT_EQ(score.treads_misled, 1u);
  EXPECT_EQ(score.stated_risk, 1e-4);
}

TEST_F(EstimateScorerTest, EachAxisHasItsLevel)
{
  past_the_first_tread();
  now.estimate.riser_ahead_m = 0.085 - 0.011;
  tick(2);
  now.estimate.riser_ahead_m = 0.085;
  stand_on(3);
  now.estimate.pose.yaw_rad = -0.031;
  tick(2);
  stand_on(4);
  now.estimate.pose.yaw_rad = 0.0;
  err_in_y(1.0);
  now.estimate.protection_across_m = std::nan("");
  tick(2);
  EXPECT_EQ(scorer.take().treads_exceeded, 2u) << "a level that is not given is not exceeded";
}

TEST_F(EstimateScorerTest, AnAlarmEndsAStretchWithOrWithoutANewEstimate)
{
  past_the_first_tread();
  err_in_y(0.5);
  now.estimate.integrity = Integrity::kDegraded;
  tick(50);
  now.estimate.integrity = Integrity::kOk;
  tick(11);  // 0.1 s
  now.refreshed = false;
  now.estimate.integrity = Integrity::kLost;
  tick(100);
  now.refreshed = true;
  now.estimate.integrity = Integrity::kOk;
  tick(16);  // 0.15 s
  EXPECT_NEAR(scorer.take().longest_exceedance_s, 0.15, 1e-12);
}

TEST_F(EstimateScorerTest, WaitingWithAWrongPoseIsBeyondItsLevelToo)
{
  past_the_first_tread();
  err_in_y(0.5);
  tick(11);
  now.state = State::kHeld;
  tick(100);
  const ClimbScore score = scorer.take();
  EXPECT_NEAR(score.longest_exceedance_s, 1.10, 1e-12);
  EXPECT_EQ(score.samples.size(), 1u + 1u + 11u) << "but it is no working estimate";
}

TEST_F(EstimateScorerTest, NeitherBeginsNorEndsAStretchWhileATouchDownIsCounted)
{
  past_the_first_tread();
  truly_on(3);  // a whole tread off, for 0.2 s
  tick(20);
  say(3);
  tick();
  EXPECT_EQ(scorer.take().longest_exceedance_s, 0.0);
}

TEST_F(EstimateScorerTest, AStretchGoesOnBeyondATouchDown)
{
  past_the_first_tread();
  err_in_y(0.5);
  tick(11);
  truly_on(3);
  tick(20);
  say(3);
  err_in_y(0.5);
  tick(11);
  EXPECT_NEAR(scorer.take().longest_exceedance_s, 0.41, 1e-12);
}

TEST_F(EstimateScorerTest, MarksTheEstimatesOfATouchDownForHalfASecond)
{
  past_the_first_tread();
  truly_on(3);
  tick(60);  // the first at 0 s, the 51st at 0.5 s
  const ClimbScore score = scorer.take();
  int confirming = 0;
  for (const ScoredEstimate & sample : score.samples) {
    confirming += sample.confirming ? 1 : 0;
  }
  EXPECT_EQ(confirming, 51);
  EXPECT_NEAR(score.longest_confirmation_s, 0.51, 1e-9) << "given up then";
}

TEST_F(EstimateScorerTest, CountsAlarmsByTheirBeginning)
{
  stand_on(1);
  tick(3);
  now.estimate.integrity = Integrity::kDegraded;  // on the first tread
  tick(3);
  now.estimate.integrity = Integrity::kOk;
  past_the_first_tread();
  now.estimate.integrity = Integrity::kDegraded;
  tick(10);
  now.estimate.integrity = Integrity::kLost;  // the same one, worse
  tick(10);
  now.estimate.integrity = Integrity::kOk;
  tick();
  now.refreshed = false;
  now.estimate.integrity = Integrity::kLost;
  tick();
  const ClimbScore score = scorer.take();
  EXPECT_EQ(score.alarms, 2u);
  EXPECT_EQ(score.steps.on_stairs, 1u);
  EXPECT_EQ(score.treads_alarmed, 2u);
  EXPECT_EQ(score.ticks_degraded, 13u);
  EXPECT_EQ(score.ticks_lost, 11u);
  EXPECT_EQ(score.ticks_ok, 3u + 2u + 1u);
}

TEST_F(EstimateScorerTest, ScoresWhatIsNewWorkingAndOnTheStairs)
{
  past_the_first_tread();
  now.accepted = false;
  tick();
  now.accepted = true;
  now.refreshed = false;
  tick();
  now.refreshed = true;
  now.state = State::kWaitPose;
  tick();
  now.state = State::kSweepRight;
  now.estimate.pose.y_m = std::nan("");
  tick();
  now.estimate.pose.y_m = 1.003;
  tick();
  stand_on(0);
  tick();
  stand_on(3);
  now.truth_at_stamp.reset();
  scorer.watch(now);
  const ClimbScore score = scorer.take();
  ASSERT_EQ(score.samples.size(), 2u + 1u);
  EXPECT_NEAR(score.samples.back().errors.y_m, 0.003, 1e-12);
  EXPECT_NEAR(score.samples.back().nees, 0.09, 1e-9) << "(3 mm / 10 mm)^2";
  EXPECT_NEAR(score.samples.back().sigma_y_m, 0.010, 1e-12);
  EXPECT_EQ(score.without_value, 1u);
  EXPECT_EQ(score.out_of_truth, 1u);
}

TEST_F(EstimateScorerTest, KeepsTheLastClosureOfEachTread)
{
  stand_on(1);
  now.estimate.contact_closure_m = 0.007;
  tick();
  stand_on(2);
  now.estimate.contact_closure_m = 0.001;
  tick();
  now.estimate.contact_closure_m = -0.002;
  tick();
  stand_on(3);
  now.estimate.contact_closure_m.reset();
  tick();
  const ClimbScore score = scorer.take();
  EXPECT_EQ(score.first_closures_m, std::vector<double>{0.007});
  EXPECT_EQ(score.closures_m, std::vector<double>{-0.002});
}

TEST_F(EstimateScorerTest, TimesAFaultAndMarksWhatComesAfterIt)
{
  EstimateScorer struck(flight, FaultOnset{now.elapsed_s + 0.015, TellingMotion::kAny});
  for (int i = 0; i < 4; ++i) {
    now.elapsed_s += 0.01;
    now.truth_at_stamp = now.truth;
    now.estimate.integrity = i < 3 ? Integrity::kOk : Integrity::kDegraded;
    struck.watch(now);
  }
  const ClimbScore score = struck.take();
  ASSERT_TRUE(score.detection);
  EXPECT_TRUE(score.detection->detected);
  EXPECT_DOUBLE_EQ(score.detection->time_s, 0.02);
  EXPECT_FALSE(score.samples[0].after_onset);
  EXPECT_TRUE(score.samples[1].after_onset);
  EXPECT_FALSE(scorer.take().detection) << "without a fault there is nothing to notice";
}

}  // namespace
}  // namespace stetro_bringup
