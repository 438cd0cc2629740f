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

// What a mission does with a pose that a person tells, and what the climb does afterwards.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "support/toy_robot.hpp"

namespace stetro_supervisor
{

class Relocalisation : public testing::Test
{
protected:
  MissionAnswer ask(RequestKind kind, const std::string & segment = "")
  {
    return mission.request({"r" + std::to_string(++requests), "test", kind, segment});
  }

  /// That the robot stands where it does, or on another tread in the same way.
  MissionRequest told(const std::string & id, int treads_away = 0) const
  {
    MissionRequest request{id, "test", RequestKind::kRelocalise, "flight"};
    request.told.frame_id = "flight";
    const int step = robot.counted_step + treads_away;  // base_link is there, block 2 may be above
    request.told.pose = {robot.x_m + 0.32 * treads_away, robot.y_m, 0.14 * step, 0.0};
    return request;
  }

  bool tick()
  {
    const bool moves = climb.tick(robot.now, robot.look()).moves();
    robot.act(hold(), 0.05);
    return moves;
  }

  void climb_to(State state)
  {
    tick();
    ASSERT_TRUE(ask(RequestKind::kCleanFlight, "flight").accepted);
    ASSERT_TRUE(run_to_state(climb, robot, state)) << where(climb, robot);
  }

  void pause_in(State state)
  {
    climb_to(state);
    ASSERT_TRUE(ask(RequestKind::kPause).accepted);
    tick();
    tick();  // what was moving has come to rest
    ASSERT_EQ(climb.state(), State::kPaused) << where(climb, robot);
  }

  /// Ticks until the answer is there, for at most so long.
  std::optional<MissionAnswer> answer_within(double limit_s)
  {
    for (double waited_s = 0.0; waited_s < limit_s; waited_s += 0.05) {
      moved = tick() || moved;
      if (const auto answer = mission.settle()) {
        return answer;
      }
    }
    return std::nullopt;
  }

  int requests = 0;
  bool moved = false;
  ToyRobot robot{stairs(3)};
  Climb climb{ClimbParams{}, stairs(3)};
  Mission mission{climb, flight_of(climb.geometry())};
};

TEST_F(Relocalisation, HasNoFloorToCheckThePoseOn)
{
  tick();
  const auto answer = ask(RequestKind::kCheckPose);
  EXPECT_FALSE(answer.accepted);
  EXPECT_NE(answer.reason.find("no floor is drawn"), std::string::npos) << answer.reason;
}

TEST_F(Relocalisation, IsAnsweredWhenTheLocalizerHasJumped)
{
  pause_in(State::kSweepLeft);
  const MissionAnswer first = mission.request(told("where"));
  EXPECT_TRUE(first.waits) << first.reason;
  EXPECT_FALSE(first.accepted);
  EXPECT_FALSE(answer_within(1.0)) << "the localizer has said nothing of it";
  EXPECT_TRUE(mission.request(told("where")).waits) << "sent again";
  ++robot.resets;
  const auto answer = answer_within(0.2);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->accepted);
  EXPECT_EQ(answer->request_id, "where");
  EXPECT_EQ(answer->issuer, "test");
  EXPECT_FALSE(mission.settle()) << "once";
  EXPECT_TRUE(mission.request(told("where")).accepted) << "the answer it got";
  EXPECT_EQ(climb.state(), State::kPaused);
}

TEST_F(Relocalisation, IsRefusedWhenTheLocalizerDoesNotFollowInTime)
{
  pause_in(State::kSweepLeft);
  ASSERT_TRUE(mission.request(told("where")).waits);
  EXPECT_FALSE(answer_within(1.9));
  const auto answer = answer_within(0.3);
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->accepted);
  EXPECT_NE(answer->reason.find("within 2"), std::string::npos) << answer->reason;
  EXPECT_EQ(mission.request(told("where")).reason, answer->reason) << "the answer it got";
  EXPECT_TRUE(ask(RequestKind::kResume).accepted) << "nothing waits any more";
}

// The pose has jumped, but the blocks do not stand as on that step: the localizer is lost for it.
TEST_F(Relocalisation, IsRefusedWhenTheBlocksContradictTheStep)
{
  pause_in(State::kSweepLeft);
  ASSERT_TRUE(mission.request(told("where")).waits);
  robot.meddle = [](Observation & o) {  // until the blocks have settled
    o.pose->integrity = Integrity::kDegraded;
    o.pose->reasons = kNotInitialised;
  };
  ++robot.resets;
  EXPECT_FALSE(answer_within(0.1));
  robot.meddle = [](Observation & o) {
    o.pose->step = -1;
    o.pose->integrity = Integrity::kLost;
    o.pose->reasons = kStepUncertain;
  };
  const auto answer = answer_within(3.0);
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->accepted);
  EXPECT_NE(answer->reason.find("step uncertain"), std::string::npos) << answer->reason;
}

TEST_F(Relocalisation, IsRefusedWhenTheLocalizerJumpsToAnotherStep)
{
  pause_in(State::kSweepLeft);
  ASSERT_TRUE(mission.request(told("where", 1)).waits);
  ++robot.resets;  // and it goes on to say step 1
  const auto answer = answer_within(3.0);
  ASSERT_TRUE(answer);
  EXPECT_FALSE(answer->accepted);
  EXPECT_NE(answer->reason.find("not on step 2"), std::string::npos) << answer->reason;
}

TEST_F(Relocalisation, IsRefusedWhileAnythingMoves)
{
  climb_to(State::kSweepLeft);
  const std::string running = mission.request(told("a")).reason;
  EXPECT_NE(running.find("'sweep_left'"), std::string::npos) << running;
  EXPECT_NE(running.find("paused"), std::string::npos) << running;
  ASSERT_TRUE(ask(RequestKind::kPause).accepted);
  robot.meddle = [](Observation & o) { o.blocks->block[1].moving = true; };
  tick();
  EXPECT_NE(mission.request(told("b")).reason.find("block 2"), std::string::npos);
  robot.meddle = [](Observation & o) { o.blocks->steering_moving = true; };
  tick();
  EXPECT_NE(mission.request(told("c")).reason.find("steering"), std::string::npos);
  robot.meddle = nullptr;
  tick();
  EXPECT_TRUE(mission.request(told("d")).waits);
}

TEST_F(Relocalisation, NeedsALocalizerThatHasSpoken)
{
  robot.meddle = [](Observation & o) { o.pose.reset(); };
  tick();
  EXPECT_NE(mission.request(told("a")).reason.find("no localizer"), std::string::npos);
}

TEST_F(Relocalisation, IsTakenInEveryStateThatRests)
{
  const auto taken = [&](const std::string & id) {
    const MissionAnswer answer = mission.request(told(id));
    EXPECT_TRUE(answer.waits) << to_string(climb.state()) << ": " << answer.reason;
    ++robot.resets;
    const auto settled = answer_within(0.2);
    return settled && settled->accepted;
  };
  tick();
  EXPECT_TRUE(taken("idle"));
  climb_to(State::kSweepRight);
  robot.driver_instance = 8;
  tick();
  ASSERT_EQ(climb.state(), State::kHeld);
  EXPECT_TRUE(taken("held"));
  robot.meddle = [](Observation & o) { o.contacts->emergency_stop.state = ContactState::kClosed; };
  tick();
  ASSERT_EQ(climb.state(), State::kFault);
  EXPECT_TRUE(taken("fault"));
  robot.meddle = nullptr;
  tick();
  ASSERT_TRUE(ask(RequestKind::kClearFault).accepted);
  tick();
  ASSERT_TRUE(ask(RequestKind::kAbort).accepted);
  tick();
  ASSERT_EQ(climb.state(), State::kAborted);
  EXPECT_TRUE(taken("aborted"));
  ASSERT_TRUE(ask(RequestKind::kCleanFlight, "flight").accepted);
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
  EXPECT_TRUE(taken("finished"));
}

TEST_F(Relocalisation, NothingStartsWhileTheLocalizerIsBeingTold)
{
  pause_in(State::kSweepLeft);
  ASSERT_TRUE(mission.request(told("where")).waits);
  const std::string resume = ask(RequestKind::kResume).reason;
  EXPECT_NE(resume.find("'where'"), std::string::npos) << resume;
  EXPECT_FALSE(ask(RequestKind::kCleanFlight, "flight").accepted);
  EXPECT_FALSE(mission.request(told("again")).waits);
  EXPECT_TRUE(ask(RequestKind::kAbort).accepted) << "to stop is always allowed";
}

TEST_F(Relocalisation, AnIdThatToldAnotherPoseIsRefused)
{
  pause_in(State::kSweepLeft);
  ASSERT_TRUE(mission.request(told("where")).waits);
  EXPECT_EQ(mission.request(told("where", 1)).reason, "request_id was used for another request");
}

class AfterRelocalisation : public Relocalisation, public testing::WithParamInterface<State>
{
};

TEST_P(AfterRelocalisation, APausedClimbWaitsForAResumeAndGoesOnToTheTop)
{
  pause_in(GetParam());
  const MissionAnswer first = mission.request(told("where"));
  ASSERT_TRUE(first.waits) << first.reason;
  ++robot.resets;
  ASSERT_TRUE(answer_within(0.2));
  EXPECT_FALSE(answer_within(2.0));
  EXPECT_FALSE(moved) << "before a resume request";
  EXPECT_EQ(climb.state(), State::kPaused);
  const auto resumed = ask(RequestKind::kResume);
  ASSERT_TRUE(resumed.accepted) << resumed.reason;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
  EXPECT_EQ(climb.record().step, 3);
}

// A person says that the robot is two treads higher than the mission: blocks alone cannot tell.
TEST_P(AfterRelocalisation, AClimbIsNotResumedOnAnotherStepThanItsOwn)
{
  pause_in(GetParam());
  const int step = robot.counted_step;
  ASSERT_TRUE(mission.request(told("where", 2)).waits);
  robot.meddle = [step](Observation & o) { o.pose->step = step + 2; };
  ++robot.resets;
  const auto answer = answer_within(0.2);
  ASSERT_TRUE(answer && answer->accepted);
  const auto resumed = ask(RequestKind::kResume);
  EXPECT_FALSE(resumed.accepted);
  EXPECT_NE(resumed.reason.find("step " + std::to_string(step + 2)), std::string::npos)
    << resumed.reason;
  EXPECT_FALSE(tick());
  EXPECT_EQ(climb.state(), State::kPaused);
  EXPECT_TRUE(ask(RequestKind::kAbort).accepted) << "the way out: abort, and clean from here";
}

TEST_P(AfterRelocalisation, AClimbThatWaitsForThePoseIsHeldAndNotLeftToItself)
{
  climb_to(GetParam());
  robot.meddle = [](Observation & o) { o.pose->integrity = Integrity::kLost; };
  ASSERT_TRUE(run_to_state(climb, robot, State::kWaitPose, 5.0)) << where(climb, robot);
  answer_within(0.2);
  const MissionAnswer first = mission.request(told("where"));
  ASSERT_TRUE(first.waits) << first.reason;
  moved = false;
  answer_within(0.1);
  EXPECT_EQ(climb.state(), State::kHeld);
  EXPECT_NE(climb.note().find("told"), std::string::npos) << climb.note();
  robot.meddle = nullptr;
  ++robot.resets;
  ASSERT_TRUE(answer_within(0.2));
  EXPECT_FALSE(answer_within(2.0));
  EXPECT_FALSE(moved) << "a person is beside it";
  const auto resumed = ask(RequestKind::kResume);
  ASSERT_TRUE(resumed.accepted) << resumed.reason;
  ASSERT_TRUE(run_to_state(climb, robot, State::kFinished)) << where(climb, robot);
}

INSTANTIATE_TEST_SUITE_P(
  States, AfterRelocalisation,
  testing::Values(
    State::kSteerToRiser, State::kRollToRiser, State::kBackOff, State::kSweepLeft,
    State::kSweepRight, State::kSquare, State::kRollBlock3ToRiser),
  [](const testing::TestParamInfo<State> & state) { return std::string(to_string(state.param)); });

}  // namespace stetro_supervisor
