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
#include <set>
#include <string>

#include "stetro_supervisor/mission.hpp"
#include "stetro_supervisor/pose_reason.hpp"
#include "support/toy_house.hpp"
#include "support/two_floors.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTick_s = 0.05;

}  // namespace

class JourneyTest : public testing::Test
{
protected:
  JourneyTest() { house.place("ground", {1.0, 1.0, 0.0, 0.4}); }

  MotionCommand tick()
  {
    const MotionCommand command = journey->tick(house.now, house.look());
    if (journey->check_report() && journey->check_report()->correction) {
      ++corrections;
      house.correct(*journey->check_report()->correction);
    }
    if (!journey->transition().empty()) {
      log += std::to_string(seconds_between(Time{std::chrono::seconds(1000)}, house.now)) + " " +
             journey->transition() + "\n";
    }
    states.insert(mission->status().state_name);
    for (int i = 0; i < 5; ++i) {
      house.act(command, kTick_s / 5.0);
    }
    return command;
  }

  bool run_until(double limit_s, const std::function<bool()> & condition)
  {
    for (double t = 0.0; t < limit_s; t += kTick_s) {
      tick();
      if (condition()) {
        return true;
      }
    }
    return false;
  }

  MissionAnswer ask(RequestKind kind, const std::string & segment = "")
  {
    return mission->request({"r" + std::to_string(++requests), "test", kind, segment});
  }

  void go(const std::string & goal)
  {
    run_until(1.0, [] { return false; });
    const auto answer = ask(RequestKind::kGoToSegment, goal);
    ASSERT_TRUE(answer.accepted) << answer.reason;
  }

  bool finished() const { return mission->status().mission == MissionState::kFinished; }

  std::string where() const
  {
    const auto at = house.in_map();
    return "in state " + mission->status().state_name + " (" + mission->status().detail + ") at " +
           std::to_string(at.x_m) + ", " + std::to_string(at.y_m) + ", " +
           std::to_string(at.yaw_rad) + " on " + house.segment() + "\n" + log;
  }

  void restart()
  {
    const MissionRecord record = decode(encode(journey->record()));
    journey.emplace(site, stetro_site::RobotGeometry{}, ClimbParams{}, FloorParams{}, "lower");
    mission.emplace(*journey);
    ASSERT_EQ(journey->misfit(record), "");
    journey->restore(record);
  }

  int requests = 0;
  int corrections = 0;
  std::set<std::string> states;
  std::string log;
  const stetro_site::Site site = two_floors(3, 2);
  ToyHouse house{site};
  std::optional<Journey> journey{std::in_place, site,          stetro_site::RobotGeometry{},
                                 ClimbParams{}, FloorParams{}, "lower"};
  std::optional<Mission> mission{std::in_place, *journey};
};

TEST_F(JourneyTest, GoesFromFloorToFloorOverBothFlights)
{
  go("first");
  ASSERT_TRUE(run_until(900.0, [this] { return finished(); })) << where();
  EXPECT_EQ(house.segment(), "first");
  EXPECT_LT(house.worst_jump_m, 0.3 * kTick_s + 0.01) << "no jump where frames change";
  EXPECT_GT(corrections, 5);
  EXPECT_EQ(mission->status().segment_id, "first");
}

TEST_F(JourneyTest, EndsAtTheFootOfAFlight)
{
  go("lower");
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
  const auto at = house.in_map();
  EXPECT_NEAR(at.x_m, 5.0 - 0.5, 0.1);
  EXPECT_NEAR(at.y_m, 1.025, 0.1);
  EXPECT_NEAR(at.yaw_rad, 0.0, 0.06);
}

TEST_F(JourneyTest, KeepsOffWallsAndStairs)
{
  go("lower");
  const DrawnFloor floor{site, "ground", 0.05};
  double least = 1e9;
  ASSERT_TRUE(run_until(
    120.0,
    [&] {
      const auto at = house.in_map();
      least = std::min(least, floor.free_space().clearance_m({at.x_m, at.y_m}));
      return finished();
    }))
    << where();
  EXPECT_GT(least, body_radius_m(stetro_site::RobotGeometry{}));
}

TEST_F(JourneyTest, RefusesWhatItCannotDo)
{
  run_until(1.0, [] { return false; });
  EXPECT_NE(
    ask(RequestKind::kGoToSegment, "attic").reason.find("accepted: 'ground'"), std::string::npos);
  house.lost = true;
  tick();
  EXPECT_NE(ask(RequestKind::kGoToSegment, "first").reason.find("LOST"), std::string::npos);
  house.lost = false;
  house.place("first", {3.0, 5.0, 0.0, 0.0});
  run_until(1.0, [] { return false; });
  EXPECT_NE(ask(RequestKind::kGoToSegment, "ground").reason.find("gone down"), std::string::npos);
  go("first");
  EXPECT_NE(ask(RequestKind::kGoToSegment, "first").reason.find("under way"), std::string::npos);
  ASSERT_TRUE(run_until(5.0, [this] { return finished(); })) << where();
}

TEST_F(JourneyTest, FindsItselfAfterAKidnapAndGoesOn)
{
  go("lower");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  run_until(1.0, [] { return false; });
  house.kidnap({3.5, 3.2, 0.0, -2.0});
  const Time since = house.now;
  ASSERT_TRUE(run_until(5.0, [this] { return mission->status().mission == MissionState::kHeld; }))
    << where();
  ASSERT_TRUE(run_until(10.0, [this] { return house.resets == 1; })) << where();
  EXPECT_LT(seconds_between(since, house.now), 10.0);
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
  EXPECT_NEAR(house.in_map().y_m, 1.025, 0.1);
}

TEST_F(JourneyTest, SetsOutAnewFromTheFloorThatItWasCarriedTo)
{
  go("first");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  house.kidnap("landing", {7.2, 1.3, 0.0, 2.1});
  ASSERT_TRUE(run_until(30.0, [this] { return house.resets == 1; })) << where();
  ASSERT_TRUE(run_until(900.0, [this] { return finished(); })) << where();
  EXPECT_NE(log.find("found on 'landing'"), std::string::npos) << log;
  EXPECT_EQ(house.segment(), "first");
}

TEST_F(JourneyTest, IsAbortedWhenItWasCarriedPastItsGoal)
{
  go("lower");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  house.kidnap("landing", {7.2, 1.3, 0.0, 2.1});
  ASSERT_TRUE(
    run_until(60.0, [this] { return mission->status().mission == MissionState::kAborted; }))
    << where();
  EXPECT_NE(mission->status().detail.find("no way to 'lower' from 'landing'"), std::string::npos)
    << mission->status().detail;
  EXPECT_FALSE(tick().moves());
  go("first");
  ASSERT_TRUE(run_until(900.0, [this] { return finished(); })) << where();
}

// What it was about to do, straight on off the stairs, was for another place.
TEST_F(JourneyTest, SetsOutAnewFromWhereItIsFoundAfterAKidnap)
{
  const auto & upper = site.flight("upper");
  const double beyond_m = upper.total_run_m() + 0.15;
  const auto end = upper.T_map_flight().to_map(stetro_site::Pose{beyond_m, 1.0, 0.0, 0.0});
  house.place("first", end);
  go("first");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }))
    << where();
  ASSERT_EQ(journey->part(), Part::kRollOff);
  const stetro_site::Pose elsewhere{3.0, 5.0, 0.0, 1.0};
  house.kidnap(elsewhere);
  ASSERT_TRUE(run_until(60.0, [this] { return finished(); })) << where();
  EXPECT_EQ(house.resets, 1) << log;
  EXPECT_NE(log.find("found on 'first'"), std::string::npos) << log;
  const auto at = house.in_map();
  EXPECT_LT(std::hypot(at.x_m - elsewhere.x_m, at.y_m - elsewhere.y_m), 0.4)
    << "it is on its goal already and has no reason to go back to the stairs\n"
    << where();
}

TEST_F(JourneyTest, TakesItsPlaceOnAFloorFromAPerson)
{
  run_until(1.0, [] { return false; });
  MissionRequest request{"where", "test", RequestKind::kRelocalise, "ground"};
  request.told.frame_id = "ground";
  request.told.pose = {1.0, 1.0, 0.0, 0.4};
  request.told.step = 0;
  ASSERT_TRUE(mission->request(request).waits);
  tick();
  EXPECT_FALSE(mission->settle()) << "the localizer has not jumped yet";
  ++house.resets;
  tick();
  const auto answer = mission->settle();
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->accepted) << answer->reason;
}

TEST_F(JourneyTest, IsHeldWhenAPersonTellsItsPlaceWhileItWaitsForThePose)
{
  go("lower");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  house.meddle = [](Observation & o) {
    o.pose->integrity = Integrity::kLost;
    o.pose->reasons = kProfileDisagrees;
    o.scan.reset();
  };
  ASSERT_TRUE(run_until(5.0, [this] { return mission->status().state_name == "floor_wait_pose"; }));
  MissionRequest request{"where", "test", RequestKind::kRelocalise, "ground"};
  request.told.frame_id = "map";
  request.told.pose = house.in_map();
  ASSERT_TRUE(mission->request(request).waits);
  ++house.resets;
  house.meddle = nullptr;
  ASSERT_TRUE(run_until(2.0, [this] { return mission->settle().has_value(); }));
  run_until(3.0, [] { return false; });
  EXPECT_EQ(mission->status().state_name, "floor_held") << where();
  ASSERT_TRUE(ask(RequestKind::kResume).accepted);
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
}

TEST_F(JourneyTest, ChecksItsPoseWhenAsked)
{
  run_until(1.0, [] { return false; });
  ASSERT_FALSE(run_until(2.0, [this] { return journey->check_report().has_value(); }))
    << "it stands, and checks only what moves";
  const auto answer = ask(RequestKind::kCheckPose);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_until(0.5, [this] { return journey->check_report().has_value(); }));
  EXPECT_EQ(journey->check_report()->verdict, Verdict::kAgrees) << journey->check_report()->reason;
  EXPECT_EQ(mission->status().mission, MissionState::kIdle);
  EXPECT_FALSE(run_until(2.0, [this] { return journey->check_report().has_value(); })) << "once";
}

TEST_F(JourneyTest, RefusesACheckThatCannotBeMade)
{
  const auto why = [this] {
    const auto answer = ask(RequestKind::kCheckPose);
    EXPECT_FALSE(answer.accepted);
    return answer.reason;
  };
  EXPECT_NE(why().find("silent"), std::string::npos) << "nothing has been heard";
  house.meddle = [](Observation & o) { o.scan.reset(); };
  run_until(1.0, [] { return false; });
  EXPECT_NE(why().find("no scan within 0.5 s"), std::string::npos);
  house.meddle = nullptr;
  house.lost = true;
  run_until(0.1, [] { return false; });
  EXPECT_NE(why().find("lost"), std::string::npos);
  house.lost = false;
  house.meddle = [](Observation & o) {
    o.pose->segment_id = "lower";
    o.pose->on_flight = true;
    o.pose->step = 2;
  };
  run_until(0.1, [] { return false; });
  EXPECT_NE(why().find("'lower', step 2, accepted: a drawn floor"), std::string::npos);
}

TEST_F(JourneyTest, CorrectsAnOdometryThatIsTooLong)
{
  house.drift = 0.10;
  go("lower");
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
  EXPECT_NEAR(house.in_map().x_m, 5.0 - 0.5, 0.15);
}

TEST_F(JourneyTest, WaitsForWhatStandsInTheWayAndThenGoesRoundIt)
{
  house.place("ground", {1.0, 1.0, 0.0, 0.0});
  for (const auto & wall : rectangle({2.6, 0.9}, {3.0, 1.3})) {
    house.unmapped.push_back(wall);
  }
  go("lower");
  ASSERT_TRUE(run_until(240.0, [this] { return finished(); })) << where();
  EXPECT_EQ(states.count("floor_blocked"), 1u) << log;
}

TEST_F(JourneyTest, PausesAndResumesOnAFloor)
{
  go("lower");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  ASSERT_TRUE(ask(RequestKind::kPause).accepted);
  EXPECT_FALSE(tick().moves());
  EXPECT_EQ(mission->status().mission, MissionState::kPaused);
  tick();
  const auto answer = ask(RequestKind::kResume);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
}

TEST_F(JourneyTest, AbortsOnAFloorAndTakesANewRequest)
{
  go("first");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  ASSERT_TRUE(ask(RequestKind::kAbort).accepted);
  EXPECT_FALSE(tick().moves());
  EXPECT_EQ(mission->status().mission, MissionState::kAborted);
  go("lower");
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
}

TEST_F(JourneyTest, IsHeldAfterARestartAndGoesOnWhenAsked)
{
  go("first");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  restart();
  run_until(2.0, [] { return false; });
  EXPECT_EQ(mission->status().mission, MissionState::kHeld);
  EXPECT_EQ(journey->goal(), "first");
  ASSERT_TRUE(ask(RequestKind::kResume).accepted);
  ASSERT_TRUE(run_until(300.0, [this] { return mission->status().state_name == "sweep_left"; }))
    << where();
  restart();
  run_until(2.0, [] { return false; });
  EXPECT_EQ(mission->status().mission, MissionState::kHeld) << "on the stairs too";
  const auto answer = ask(RequestKind::kResume);
  ASSERT_TRUE(answer.accepted) << answer.reason;
  ASSERT_TRUE(run_until(900.0, [this] { return finished(); })) << where();
  EXPECT_EQ(house.segment(), "first");
}

TEST_F(JourneyTest, EmergencyStopOnAFloorIsAFaultUntilItIsCleared)
{
  go("lower");
  ASSERT_TRUE(run_until(20.0, [this] { return mission->status().state_name == "floor_roll"; }));
  house.meddle = [](Observation & o) { o.contacts->emergency_stop.state = ContactState::kClosed; };
  EXPECT_EQ(tick().kind, MotionCommand::Kind::kStop);
  EXPECT_EQ(mission->status().fault, Fault::kEmergencyStop);
  EXPECT_FALSE(ask(RequestKind::kClearFault).accepted);
  house.meddle = nullptr;
  tick();
  ASSERT_TRUE(ask(RequestKind::kClearFault).accepted);
  tick();
  EXPECT_EQ(mission->status().mission, MissionState::kHeld);
  ASSERT_TRUE(ask(RequestKind::kResume).accepted);
  ASSERT_TRUE(run_until(120.0, [this] { return finished(); })) << where();
}

}  // namespace stetro_supervisor
