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

#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{
namespace
{

/// Every state a climb of two steps passes through while it works.
const State kVisited[] = {
  State::kSteerToFind, State::kFindStairs,   State::kAlignToStairs, State::kSteerToApproach,
  State::kApproach,    State::kLiftBlock1,   State::kRollToRiser,   State::kLowerBlock1,
  State::kBackOff,     State::kSteerAcross,  State::kSquare,        State::kSteerAlong,
  State::kLiftBlock2,  State::kLowerBlock2,  State::kConfirmStep,   State::kRollBlock3ToRiser,
  State::kLiftBlock3,  State::kSteerToRiser, State::kLowerBlock3,   State::kSweepLeft,
  State::kSweepRight,  State::kSweepToMiddle};

}  // namespace

class MissionTest : public testing::Test
{
protected:
  MissionAnswer ask(RequestKind kind, const std::string & segment = "")
  {
    return mission.request({"r" + std::to_string(++requests), "test", kind, segment});
  }

  void start()
  {
    climb.tick(robot.now, robot.look());
    const auto answer = ask(RequestKind::kCleanFlight, "flight");
    ASSERT_TRUE(answer.accepted) << answer.reason;
  }

  void tick() { climb.tick(robot.now, robot.look()); }

  int requests = 0;
  ToyRobot robot{stairs(2)};
  Climb climb{ClimbParams{}, stairs(2)};
  Mission mission{climb, flight_of(climb.geometry())};
};

class InEveryState : public MissionTest, public testing::WithParamInterface<State>
{
protected:
  void reach()
  {
    start();
    ASSERT_TRUE(run_to_state(climb, robot, GetParam())) << where(climb, robot);
  }
};

TEST_P(InEveryState, PausesAtOnceAndResumesToTheTop)
{
  reach();
  ASSERT_TRUE(ask(RequestKind::kPause).accepted);
  EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
  EXPECT_EQ(mission.status().mission, MissionState::kPaused);
  EXPECT_FALSE(ask(RequestKind::kPause).accepted) << "paused already";
  const auto answer = ask(RequestKind::kResume);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
  EXPECT_EQ(climb.record().step, 2);
}

TEST_P(InEveryState, AbortsAndStandsStill)
{
  reach();
  ASSERT_TRUE(ask(RequestKind::kAbort).accepted);
  EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
  EXPECT_EQ(mission.status().mission, MissionState::kAborted);
  EXPECT_FALSE(ask(RequestKind::kResume).accepted);
}

TEST_P(InEveryState, AFallenDriverHoldsAndNothingMovesUntilAResume)
{
  reach();
  robot.driver_instance = 8;
  for (int i = 0; i < 40; ++i) {
    EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
    robot.act(hold(), 0.05);
  }
  EXPECT_EQ(climb.state(), State::kHeld);
  const auto answer = ask(RequestKind::kResume);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
}

TEST_P(InEveryState, EmergencyStopIsAFaultThatOnlyClearsWhenItIsReleased)
{
  reach();
  robot.meddle = [](Observation & o) { o.contacts->emergency_stop.state = ContactState::kClosed; };
  EXPECT_EQ(climb.tick(robot.now, robot.look()).kind, MotionCommand::Kind::kStop);
  EXPECT_EQ(mission.status().fault, Fault::kEmergencyStop);
  EXPECT_FALSE(ask(RequestKind::kClearFault).accepted);
  EXPECT_FALSE(ask(RequestKind::kAbort).accepted) << "clear the fault first";
  robot.meddle = nullptr;
  tick();
  ASSERT_TRUE(ask(RequestKind::kClearFault).accepted);
  tick();
  EXPECT_EQ(climb.state(), State::kHeld) << "cleared, but a resume is still needed";
  const auto answer = ask(RequestKind::kResume);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
}

TEST_P(InEveryState, ASilentLocalizerStopsAndTheClimbGoesOnByItself)
{
  reach();
  const Time silent_since = robot.now;
  robot.meddle = [&](Observation & o) { o.pose->time = silent_since; };
  const bool needs_pose = row_of(GetParam()).needs_pose;
  run_until(climb, robot, 1.0, [] { return false; });
  if (needs_pose) {
    EXPECT_EQ(climb.state(), State::kWaitPose) << where(climb, robot);
    EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
    EXPECT_FALSE(mission.status().detail.empty());
  }
  robot.meddle = nullptr;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
}

INSTANTIATE_TEST_SUITE_P(
  Climb, InEveryState, testing::ValuesIn(kVisited),
  [](const testing::TestParamInfo<State> & state) { return std::string(to_string(state.param)); });

TEST_F(MissionTest, RefusesToClimbWithoutAnOkPoseAndSaysWhy)
{
  robot.meddle = [](Observation & o) { o.pose->integrity = Integrity::kDegraded; };
  tick();
  const auto answer = ask(RequestKind::kCleanFlight, "flight");
  EXPECT_FALSE(answer.accepted);
  EXPECT_NE(answer.reason.find("DEGRADED"), std::string::npos) << answer.reason;
  EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
}

TEST_F(MissionTest, ApproachesFromAfarWithoutAFrontReferenceButLiftsNothingWithoutOne)  // D3-9
{
  robot.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kNoFrontReference;
  };
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kApproach, 60.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 60.0)) << where(climb, robot);
  EXPECT_NEAR(robot.z_m[0], 0.0, 1e-9);
  EXPECT_NE(mission.status().detail.find("no front reference"), std::string::npos);
  robot.meddle = nullptr;
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock1, 60.0)) << where(climb, robot);
}

TEST_F(MissionTest, RefusesAStartOnATreadOrInMoreDoubtThanAFarRiserMakes)
{
  std::uint32_t reasons = kNoFrontReference | kNoSideRange;
  robot.meddle = [&reasons](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = reasons;
  };
  tick();
  EXPECT_FALSE(ask(RequestKind::kCleanFlight, "flight").accepted);
  reasons = kNoFrontReference;
  robot.x_m = 0.32 - 0.085;
  robot.z_m = {0.28, 0.14, 0.14};
  robot.counted_step = 1;
  tick();
  const auto answer = ask(RequestKind::kCleanFlight, "flight");
  EXPECT_FALSE(answer.accepted);
  EXPECT_NE(answer.reason.find("no front reference"), std::string::npos) << answer.reason;
}

TEST_F(MissionTest, FinishesASweepOnADegradedPoseButStartsNoClimb)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  robot.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kClosureViolated;  // the sides do not add up: the next wall puts that right
  };
  ASSERT_TRUE(run_to_state(climb, robot, State::kSquare, 100.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 1.0)) << where(climb, robot);
  robot.meddle = nullptr;
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock2, 20.0)) << where(climb, robot);
}

TEST_F(MissionTest, SweepsAgainWhereOnlyAWallCanPutThePoseRight)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepToMiddle, 100.0)) << where(climb, robot);
  robot.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kClosureViolated | kProtectionExceeded;
  };
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 100.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft, 20.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepRight, 100.0)) << where(climb, robot);
  robot.meddle = nullptr;  // the left wall has told
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock2, 100.0)) << where(climb, robot);
}

TEST_F(MissionTest, SweepsAgainOnceAndWaitsThen)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepToMiddle, 100.0)) << where(climb, robot);
  robot.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kClosureViolated;
  };
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft, 100.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 200.0)) << where(climb, robot);
  ASSERT_TRUE(run_to_state(climb, robot, State::kFault, 200.0)) << where(climb, robot);
  EXPECT_EQ(climb.fault(), Fault::kPoseLost);
}

TEST_F(MissionTest, AStepInDoubtStopsAtOnce)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  robot.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kClosureViolated | kStepUncertain;
  };
  EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
  EXPECT_EQ(climb.state(), State::kWaitPose);
}

TEST_F(MissionTest, RefusesWhatIsNotSupportedOrUnknown)
{
  tick();
  EXPECT_FALSE(ask(RequestKind::kGoToSegment, "flight").accepted);
  EXPECT_NE(ask(RequestKind::kGoToSegment).reason.find("down"), std::string::npos);
  EXPECT_FALSE(ask(RequestKind::kRelocalise).accepted);
  EXPECT_FALSE(ask(RequestKind::kUnknown).accepted);
  EXPECT_FALSE(ask(RequestKind::kResume).accepted);
  EXPECT_FALSE(ask(RequestKind::kPause).accepted);
  EXPECT_FALSE(ask(RequestKind::kAbort).accepted);
  EXPECT_FALSE(ask(RequestKind::kClearFault).accepted);
  const auto answer = ask(RequestKind::kCleanFlight, "attic");
  EXPECT_NE(answer.reason.find("attic"), std::string::npos) << answer.reason;
  EXPECT_FALSE(mission.request({"", "test", RequestKind::kPause, ""}).accepted);
}

TEST_F(MissionTest, ADuplicateGetsTheSameAnswerAndChangesNothing)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  const MissionRequest pause{"p", "test", RequestKind::kPause, ""};
  ASSERT_TRUE(mission.request(pause).accepted);
  tick();
  ASSERT_TRUE(ask(RequestKind::kResume).accepted);
  tick();
  tick();
  EXPECT_TRUE(mission.request(pause).accepted) << "the answer it got";
  tick();
  EXPECT_NE(climb.state(), State::kPaused) << "and no second pause";
  EXPECT_EQ(mission.request(pause).request_id, "p");
}

TEST_F(MissionTest, AnIdUsedForAnotherRequestIsRefused)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  const MissionRequest started{"r1", "test", RequestKind::kCleanFlight, "flight"};
  EXPECT_TRUE(mission.request(started).accepted);
  for (const RequestKind kind : {RequestKind::kPause, RequestKind::kAbort}) {
    const auto answer = mission.request({"r1", "test", kind, ""});
    EXPECT_FALSE(answer.accepted) << "or the operator believes that the robot stops";
    EXPECT_EQ(answer.reason, "request_id was used for another request");
  }
  EXPECT_FALSE(mission.request({"r1", "test", RequestKind::kCleanFlight, "attic"}).accepted);
  EXPECT_TRUE(mission.request({"r1", "other", RequestKind::kPause, ""}).accepted) << "its own id";
}

TEST_F(MissionTest, TheIdOfAMissionFromBeforeARestartIsNotThatOfAPause)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  Mission restarted{climb, flight_of(climb.geometry())};
  EXPECT_FALSE(restarted.request({"r1", "test", RequestKind::kPause, ""}).accepted);
  Mission again{climb, flight_of(climb.geometry())};
  EXPECT_TRUE(again.request({"r1", "test", RequestKind::kCleanFlight, "flight"}).accepted);
}

TEST_F(MissionTest, APoseThatFlickersDoesNotEvadeTheLimits)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  const Integrity lost = Integrity::kLost;
  int times = 0;
  const auto flickers = [&] {
    robot.meddle = [lost](Observation & o) { o.pose->integrity = lost; };
    run_to_state(climb, robot, State::kWaitPose, 1.0);
    robot.meddle = nullptr;
    ++times;
    const auto leaves = [&] {
      return climb.state() != State::kWaitPose && climb.state() != State::kRejoin;
    };
    run_until(climb, robot, 5.0, leaves);
    return climb.state() != State::kFault;
  };
  while (times < 50 && flickers()) {
  }
  EXPECT_EQ(times, climb.params().max_rejoins + 1);
  EXPECT_EQ(climb.fault(), Fault::kPoseLost) << where(climb, robot);
}

TEST_F(MissionTest, RefusesASecondMissionAndGoingDown)
{
  start();
  tick();
  EXPECT_FALSE(ask(RequestKind::kCleanFlight, "flight").accepted);
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
  const auto answer = ask(RequestKind::kCleanFlight, "flight");
  EXPECT_FALSE(answer.accepted);
  EXPECT_NE(answer.reason.find("down"), std::string::npos) << answer.reason;
}

TEST_F(MissionTest, ADriverThatKeepsRefusingIsAFault)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  robot.meddle = [](Observation & o) {
    o.driver_answer = DriverAnswer{o.contacts->time, true, "wheels not across"};
  };
  ASSERT_TRUE(run_to_state(climb, robot, State::kFault, 5.0)) << where(climb, robot);
  EXPECT_EQ(climb.fault(), Fault::kCommandRefused);
  EXPECT_NE(climb.note().find("wheels not across"), std::string::npos) << climb.note();
}

TEST_F(MissionTest, AClockThatGoesBackHolds)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepLeft)) << where(climb, robot);
  robot.now -= std::chrono::seconds(5);
  EXPECT_FALSE(climb.tick(robot.now, robot.look()).moves());
  EXPECT_EQ(climb.state(), State::kHeld);
}

TEST_F(MissionTest, ABrokenBlockOrSwitchIsAFault)
{
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kLiftBlock2)) << where(climb, robot);
  robot.meddle = [](Observation & o) { o.contacts->riser_left.fault = true; };
  tick();
  EXPECT_EQ(climb.fault(), Fault::kContactFault);
}

TEST_F(MissionTest, StatusCountsStepsSharesAndTime)
{
  EXPECT_EQ(mission.status().step, -1) << "nothing is known before the first tick";
  start();
  ASSERT_TRUE(run_to_state(climb, robot, State::kSweepRight)) << where(climb, robot);
  const MissionStatus status = mission.status();
  EXPECT_EQ(status.mission, MissionState::kRunning);
  EXPECT_EQ(status.step, 1);
  EXPECT_EQ(status.step_count, 2);
  ASSERT_EQ(status.swept_share.size(), 2u);
  EXPECT_NEAR(status.swept_share[0], 0.5 + 0.115 / 2.05, 0.02) << "from the middle to the left";
  EXPECT_EQ(status.swept_share[1], 0.0);
  EXPECT_EQ(status.time_limit_s, climb.params().sweep_limit_s);
}

}  // namespace stetro_supervisor
