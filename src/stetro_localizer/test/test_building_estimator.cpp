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
#include <limits>
#include <string>

#include "stetro_localizer/building_estimator.hpp"
#include "stetro_tests/counted_allocations.hpp"
#include "support/bias_named.hpp"
#include "support/two_floors.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr double kTop = 16 * 0.32;  // run of the lower flight [m]

const stetro_site::Covariance kTold =
  (stetro_site::Covariance() << stetro_site::Covariance::Identity() * 4e-4).finished();

/// The building, and a robot in it.
struct Rig
{
  explicit Rig(const LocalizerParams & params = {}, bool drawn = true)
  : building(setup_of(params, drawn)), robot(building)
  {
    building.begin({});
  }

  [[nodiscard]] stetro_site::Pose at() const
  {
    return building.segment().T_map_segment.to_map(building.estimate().pose);
  }

  /// A correction as of now, on that floor.
  CorrectionOutcome correct(
    const std::string & floor, const stetro_site::Pose & pose, Nanoseconds late = Nanoseconds{0})
  {
    const std::uint32_t resets = building.estimate().reset_counter;
    return building.take_correction(
      correction_at(floor, pose, robot.now - late, resets), robot.now);
  }

  BuildingEstimator building;
  LevelRobot robot;
};

TEST(BuildingEstimator, DoesNotKnowWhereItIsUntilTwoCorrectionsAgree)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  EXPECT_EQ(rig.building.segment().kind, SegmentKind::kNowhere);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kLost);
  EXPECT_EQ(rig.building.estimate().reasons, kNotInitialised);
  EXPECT_FALSE(rig.building.estimate().step);

  EXPECT_EQ(rig.correct("ground", {2.0, 1.0, 0.0, 0.5}), CorrectionOutcome::kAwaited);
  rig.robot.drive(0.3, 0.0);
  EXPECT_EQ(rig.correct("ground", {2.01, 1.0, 0.0, 0.5}), CorrectionOutcome::kReset);
  EXPECT_EQ(rig.building.segment().id, "ground");
  EXPECT_EQ(rig.building.segment().kind, SegmentKind::kFloor);
  const StairEstimate & estimate = rig.building.estimate();
  EXPECT_EQ(estimate.integrity, Integrity::kOk) << reason_names(estimate.reasons);
  EXPECT_EQ(estimate.reset_counter, 1u);
  EXPECT_EQ(estimate.reset_cause, ResetCause::kCorrected);
  EXPECT_EQ(estimate.step, 0);
  EXPECT_NEAR(estimate.pose.x_m, 2.005, 1e-3);
  EXPECT_FALSE(rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.5}, kTold)) << "told there";
  EXPECT_EQ(rig.building.corrections()[static_cast<std::size_t>(CorrectionOutcome::kReset)], 1u);
}

TEST(BuildingEstimator, IsLostWhenItIsCarriedAwayAndFoundAgain)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(0.5, 0.1);
  EXPECT_EQ(rig.correct("ground", {2.05, 1.0, 0.0, 0.0}), CorrectionOutcome::kFused);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kOk);

  // Somebody lifts it 2 m along y and turns it by a right angle; then it drives along y.
  double y_m = 3.0;
  const auto check = [&] {
    rig.robot.drive(1.0, 0.1);
    y_m += 0.1;
    return rig.correct("ground", {2.05, y_m, 0.0, M_PI / 2.0});
  };
  EXPECT_EQ(check(), CorrectionOutcome::kGated);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kDegraded);
  EXPECT_TRUE(rig.building.estimate().reasons & kProfileDisagrees);
  EXPECT_EQ(check(), CorrectionOutcome::kGated);
  EXPECT_EQ(check(), CorrectionOutcome::kGatedLost);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kLost);
  const std::uint32_t resets = rig.building.estimate().reset_counter;
  EXPECT_EQ(check(), CorrectionOutcome::kAwaited);
  EXPECT_EQ(check(), CorrectionOutcome::kReset);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kOk);
  EXPECT_EQ(rig.building.estimate().reset_counter, resets + 1);
  EXPECT_NEAR(rig.building.estimate().pose.y_m, y_m, 0.01);
  EXPECT_NEAR(rig.building.estimate().pose.yaw_rad, M_PI / 2.0, 0.01);
}

TEST(BuildingEstimator, RefusesCorrectionsThatAreStaleOrUnfit)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(3.0, 0.0);
  const stetro_site::Pose here{2.0, 1.0, 0.0, 0.0};
  const Nanoseconds now = rig.robot.now;
  const auto take = [&](const PoseCorrection & correction) {
    return rig.building.take_correction(correction, now);
  };
  EXPECT_EQ(take(correction_at("ground", here, now, 0)), CorrectionOutcome::kStaleCounter);
  EXPECT_EQ(take(correction_at("cellar", here, now, 1)), CorrectionOutcome::kOtherFloor);
  EXPECT_EQ(
    take(correction_at("ground", here, now + milliseconds(500), 1)), CorrectionOutcome::kFuture);
  EXPECT_EQ(
    take(correction_at("ground", here, now - milliseconds(2500), 1)), CorrectionOutcome::kTooOld);
  PoseCorrection bad = correction_at("ground", here, now, 1);
  bad.covariance(0, 1) = bad.covariance(1, 0) = 1.0;  // more in common than each has
  EXPECT_EQ(take(bad), CorrectionOutcome::kUnfit);
  bad = correction_at("ground", here, now, 1);
  bad.pose.x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(take(bad), CorrectionOutcome::kUnfit);
  const Nanoseconds before = now - milliseconds(100);
  EXPECT_EQ(take(correction_at("landing", here, before, 1)), CorrectionOutcome::kOtherFloor);
  EXPECT_EQ(take(correction_at("ground", here, now, 1)), CorrectionOutcome::kFused);
  EXPECT_EQ(take(correction_at("ground", here, now, 1)), CorrectionOutcome::kOutOfOrder);
  EXPECT_EQ(rig.building.estimate().integrity, Integrity::kOk);
}

// A metre before the stairs the flight's estimator begins, and nothing jumps.
TEST(BuildingEstimator, GoesFromTheFloorToTheFlightWithoutAJump)
{
  Rig rig;
  rig.robot.gyro_bias_radps = 0.003;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {3.9, 1.0, 0.0, 0.1}, kTold));
  rig.robot.drive(1.0, 0.0);
  const double bias = bias_named(rig.building, "gyro").value;
  EXPECT_NEAR(bias, 0.003, 1e-4);
  EXPECT_EQ(rig.building.segment().id, "ground");
  for (int i = 0; i < 400 && rig.building.segment().id == "ground"; ++i) {
    const stetro_site::Pose before = rig.at();
    rig.robot.tick(0.1);
    EXPECT_LE(std::hypot(rig.at().x_m - before.x_m, rig.at().y_m - before.y_m), 0.0032);
    EXPECT_LE(std::abs(rig.at().yaw_rad - before.yaw_rad), 2e-4);
    EXPECT_EQ(rig.building.estimate().integrity, Integrity::kOk)
      << reason_names(rig.building.estimate().reasons);
  }
  const StairEstimate & estimate = rig.building.estimate();
  ASSERT_EQ(rig.building.segment().id, "lower");
  EXPECT_EQ(estimate.step, 0);
  EXPECT_GE(estimate.pose.x_m, -1.0);
  EXPECT_NEAR(estimate.pose.x_m, -1.0, 0.005);
  EXPECT_EQ(estimate.reset_counter, 1u) << "of the told pose only";
  EXPECT_NEAR(bias_named(rig.building, "gyro").value, bias, 1e-4);
  rig.robot.drive(0.5, 0.0);
  EXPECT_EQ(estimate.integrity, Integrity::kOk) << reason_names(rig.building.estimate().reasons);
  EXPECT_EQ(rig.building.crossings(), 2u) << "told, and handed over";
}

TEST(BuildingEstimator, GoesBackToTheFloorWhenItTurnsAway)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {4.5, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(0.5, 0.0);
  ASSERT_EQ(rig.building.segment().id, "lower");
  const stetro_site::Pose before = rig.at();
  rig.robot.drive(2.0, -0.45);
  EXPECT_EQ(rig.building.segment().id, "ground");
  EXPECT_NEAR(rig.at().x_m, before.x_m - 0.9, 0.01);
  rig.robot.drive(1.0, 0.0);
  EXPECT_EQ(rig.building.segment().id, "ground") << "it does not flutter";
}

TEST(BuildingEstimator, GoesFromTheLastStepToTheFloorAbove)
{
  Rig rig;
  rig.robot.drive(0.5, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("lower", {kTop - 0.085, 1.0, 2.24, 0.0}, kTold));
  rig.robot.drive(1.0, 0.0);
  ASSERT_EQ(rig.building.segment().id, "lower");
  ASSERT_EQ(rig.building.estimate().step, 16);
  for (int i = 0; i < 200 && rig.building.segment().id == "lower"; ++i) {
    const stetro_site::Pose before = rig.at();
    rig.robot.tick(0.1);
    EXPECT_LE(std::hypot(rig.at().x_m - before.x_m, rig.at().y_m - before.y_m), 0.0032);
  }
  ASSERT_EQ(rig.building.segment().id, "landing");
  const StairEstimate & estimate = rig.building.estimate();
  EXPECT_EQ(estimate.integrity, Integrity::kOk) << reason_names(estimate.reasons);
  EXPECT_EQ(estimate.reset_counter, 1u);
  // By hand: in map (5 + 5.07, 1), in a frame at (1, 2) turned by a quarter (-1, -9.07).
  EXPECT_NEAR(estimate.pose.x_m, -1.0, 0.01);
  EXPECT_NEAR(estimate.pose.y_m, -9.07, 0.01);
  EXPECT_NEAR(estimate.pose.yaw_rad, -M_PI / 2.0, 0.01);
  EXPECT_NEAR(estimate.pose.z_m, 0.0, 0.005);
}

// Carried away while it stood before the stairs: the floor's corrections say so.
TEST(BuildingEstimator, ACorrectionThatContradictsStepZeroTakesItBackToTheFloor)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {4.5, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(0.5, 0.0);
  ASSERT_EQ(rig.building.segment().id, "lower");
  EXPECT_EQ(rig.correct("ground", {4.5, 1.0, 0.0, 0.0}), CorrectionOutcome::kNotOnFloor)
    << "it agrees, and the flight's ranges know better";
  const auto contradict = [&] {
    rig.robot.drive(0.5, 0.0);
    return rig.correct("ground", {2.0, 3.0, 0.0, 1.0});
  };
  EXPECT_EQ(contradict(), CorrectionOutcome::kGated);
  rig.robot.drive(0.5, 0.0);
  EXPECT_EQ(rig.building.segment().id, "ground") << "and no flight while it is doubted";
  EXPECT_EQ(contradict(), CorrectionOutcome::kGated);
  EXPECT_EQ(contradict(), CorrectionOutcome::kGated);
  EXPECT_EQ(contradict(), CorrectionOutcome::kGatedLost);
}

// Carried up to the landing, from the floor or from before the stairs: its corrections find it.
TEST(BuildingEstimator, IsFoundOnTheFloorThatItWasCarriedTo)
{
  for (const double x_m : {2.0, 4.5}) {
    Rig rig;
    rig.robot.drive(1.0, 0.0);
    ASSERT_FALSE(rig.building.tell_pose("ground", {x_m, 1.0, 0.0, 0.0}, kTold));
    rig.robot.drive(0.5, 0.0);
    ASSERT_EQ(rig.building.segment().id, x_m < 3.0 ? "ground" : "lower");
    for (int i = 0; i < 8 && rig.building.segment().id != "landing"; ++i) {
      rig.robot.drive(0.5, 0.0);
      rig.correct("landing", {11.0, 4.0, 0.0, 1.0});
    }
    EXPECT_EQ(rig.building.segment().id, "landing") << x_m;
    EXPECT_EQ(rig.building.estimate().integrity, Integrity::kOk);
    EXPECT_NEAR(rig.building.estimate().pose.x_m, 11.0, 0.01);
  }
}

TEST(BuildingEstimator, FindsTheSegmentOfAPoseInMap)
{
  Rig rig;
  rig.robot.drive(0.5, 0.0);
  const auto tell = [&](const stetro_site::Pose & pose) -> std::string {
    const auto refused = rig.building.tell_pose("map", pose, kTold);
    return refused ? refused->reason : rig.building.segment().id;
  };
  EXPECT_EQ(tell({2.0, 1.0, 0.0, 0.0}), "ground");
  EXPECT_EQ(tell({5.0 + 2.5 * 0.32, 1.0, 3 * 0.14, 0.0}), "lower");
  EXPECT_EQ(rig.building.estimate().step, 3);
  EXPECT_EQ(tell({11.0, 4.0, 2.24, 0.0}), "landing");
  EXPECT_EQ(tell({10.12 - 0.16, 3.6, 2.38, M_PI}), "upper");
  EXPECT_EQ(tell({2.0, 1.0, 1.0, 0.0}), "implausible") << "in the air";
  EXPECT_EQ(tell({100.0, 1.0, 0.0, 0.0}), "implausible") << "outside";
  EXPECT_EQ(rig.building.tell_pose("odom", {}, kTold)->reason, std::string("frame"));
  EXPECT_EQ(rig.building.segment().id, "upper") << "what is refused changes nothing";
}

TEST(BuildingEstimator, BeginsOnAFloorLostAfterARestartButCalibrated)
{
  StateReading stored;
  {
    Rig rig;
    rig.robot.gyro_bias_radps = 0.004;
    rig.robot.drive(1.0, 0.0);
    ASSERT_FALSE(rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.0}, kTold));
    rig.robot.drive(1.0, 0.0);
    std::string why;
    const auto parsed = parse_stored_state(to_text(rig.building.state_to_store()), why);
    ASSERT_TRUE(parsed) << why;
    stored = {StateReading::Kind::kFound, *parsed, ""};
  }
  BuildingEstimator building(setup_of({}));
  building.begin(stored);
  EXPECT_EQ(building.segment().id, "ground");
  EXPECT_EQ(building.estimate().integrity, Integrity::kLost);
  EXPECT_EQ(building.estimate().reset_counter, 2u);
  EXPECT_TRUE(std::isnan(building.estimate().pose.x_m));
  EXPECT_NEAR(bias_named(building, "gyro").value, 0.004, 1e-4);
}

TEST(BuildingEstimator, WithoutDrawnFloorsThereIsNothingButTheFlight)
{
  Rig rig({}, false);
  rig.robot.drive(1.0, 0.0);
  EXPECT_EQ(rig.building.segment().id, "lower");
  EXPECT_EQ(rig.building.estimate().step, 0);
  EXPECT_EQ(rig.correct("ground", {2.0, 1.0, 0.0, 0.5}), CorrectionOutcome::kNotOnFloor);
  EXPECT_EQ(
    rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.0}, kTold)->reason, std::string("frame"));
  ASSERT_FALSE(rig.building.tell_pose("map", {3.0, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(1.0, 0.0);
  EXPECT_EQ(rig.building.segment().id, "lower") << "two metres before the stairs, too";
}

// Silent inputs on a floor are told, and the doubt grows.
TEST(BuildingEstimator, SaysThatItsInputsAreSilentOnAFloor)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {2.0, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(1.0, 0.1);
  for (int i = 0; i < 20; ++i) {
    rig.robot.now += milliseconds(100);
    rig.building.tick(rig.robot.now);
  }
  EXPECT_TRUE(rig.building.estimate().reasons & kInputSilent);
  EXPECT_EQ(rig.building.estimate().stamp, rig.robot.now);
  EXPECT_GT(rig.building.estimate().protection_heading_rad, 0.15);
}

TEST(BuildingEstimator, CorrectsAndHandsOverWithoutAllocating)
{
  Rig rig;
  rig.robot.drive(1.0, 0.0);
  ASSERT_FALSE(rig.building.tell_pose("ground", {3.9, 1.0, 0.0, 0.0}, kTold));
  rig.robot.drive(0.5, 0.1);
  const PoseCorrection correction =
    correction_at("ground", {3.92, 1.0, 0.0, 0.0}, rig.robot.now - milliseconds(300), 1);
  const std::size_t before = allocations;
  const CorrectionOutcome outcome = rig.building.take_correction(correction, rig.robot.now);
  rig.robot.drive(2.0, 0.1);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(outcome, CorrectionOutcome::kFused);
  EXPECT_EQ(rig.building.segment().id, "lower");
}

}  // namespace
}  // namespace stetro_localizer
