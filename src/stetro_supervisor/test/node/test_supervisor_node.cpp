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
// The node over DDS, in one process and on simulated time: a toy robot speaks for driver and
// localizer. What the climb does by itself is tested without DDS, beside the core.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "../../src/node/convert.hpp"
#include "stetro_config/report.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_site/robot.hpp"
#include "stetro_supervisor/supervisor_node.hpp"
#include "support/toy_wire.hpp"

namespace stetro_supervisor
{
namespace
{

namespace fs = std::filesystem;
namespace qos = stetro_dds::qos;

constexpr char kSite[] = R"(name: toy
floors:
  - {id: ground, elevation_m: 0.0}
  - {id: landing, elevation_m: 0.28}
flights:
  - id: flight
    joins: [ground, landing]
    steps: 2
    riser_m: 0.14
    tread_m: 0.32
    width_m: 2.05
    sides: {right: walled, left: walled}
    wall_overrun_m: 1.0
    pose: {x_m: 10.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}
)";

}  // namespace

class SupervisorNodeTest : public testing::Test
{
protected:
  SupervisorNodeTest()
  {
    fs::create_directories(folder);
    params.site_file = (folder / "site.yaml").string();
    params.robot_file = (folder / "robot.yaml").string();
    params.state_file = (folder / "mission").string();
    std::ofstream{params.site_file} << kSite;
    std::ofstream{params.robot_file} << stetro_config::to_yaml(stetro_site::Robot{});
    start_node();
    wire.emplace(context, robot);
    executor.add(wire->node());
  }

  ~SupervisorNodeTest() override
  {
    supervisor.reset();
    fs::remove_all(folder);
  }

  void start_node()
  {
    supervisor.emplace(
      context, stetro_dds::NodeOptions{"supervisor", "/stetro", stetro_dds::TimeSource::kByHand},
      params);
    executor.add(supervisor->node());
  }

  void stop_node()
  {
    executor.remove(supervisor->node());
    supervisor.reset();
  }

  /// One tick of 50 ms: senses, lets the node think, acts.
  void step(bool act = true)
  {
    supervisor->node().clock().set(robot.now + clock_ahead);
    wire->publish();
    executor.drain();
    wire->act(act);
  }

  bool run_until(double limit_s, const std::function<bool()> & condition)
  {
    for (double t = 0.0; t < limit_s; t += 0.05) {
      step();
      if (condition()) {
        return true;
      }
    }
    return false;
  }

  /// A value of the task "mission" in the node's diagnostics.
  std::string diagnosed(const std::string & key)
  {
    for (const auto & [task, report] : supervisor->node().diagnostics().reports()) {
      for (const auto & [name, value] : report.values()) {
        if (task == "mission" && name == key) {
          return value;
        }
      }
    }
    return "";
  }

  bool in_state(const std::string & state) { return wire->status && wire->state() == state; }

  const fs::path folder = fs::temp_directory_path() / ("supervisor_" + std::to_string(::getpid()));
  ToyRobot robot{stairs(2)};
  SupervisorParams params;
  stetro_dds::Context context{test_options()};
  stetro_dds::Executor executor;
  std::optional<ToyWire> wire;
  std::optional<SupervisorNode> supervisor;
  Time clock_ahead{0};  ///< how old everything is when it arrives
};

TEST_F(SupervisorNodeTest, ClimbsOverDds)
{
  run_until(0.2, [] { return false; });
  wire->request("1", stetro_msgs::msg::MissionRequest_Constants::KIND_CLEAN_FLIGHT, "flight");
  step();
  step();
  ASSERT_EQ(wire->status->answer(), stetro_msgs::msg::MissionStatus_Constants::ANSWER_ACCEPTED)
    << wire->status->answer_reason().c_str();
  ASSERT_TRUE(run_until(600.0, [&] { return in_state("finished"); })) << wire->state();
  EXPECT_EQ(wire->status->step(), 2);
  ASSERT_TRUE(wire->fleet.has_value());
  EXPECT_NEAR(wire->fleet->robots().at(0).location().x(), 10.0 + robot.x_m, 1e-3) << "in map";
}

TEST_F(SupervisorNodeTest, ARestartedDriverHoldsUntilAResumeRequest)
{
  namespace kind = stetro_msgs::msg::MissionRequest_Constants;
  run_until(0.2, [] { return false; });
  wire->request("1", kind::KIND_CLEAN_FLIGHT, "flight");
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("sweep_right"); })) << wire->state();
  wire->driver_instance = 99;
  ASSERT_TRUE(run_until(1.0, [&] { return in_state("held"); })) << wire->state();
  const double y = robot.y_m;
  EXPECT_FALSE(run_until(2.0, [&] { return !in_state("held"); }));
  EXPECT_EQ(robot.y_m, y);
  wire->request("2", kind::KIND_RESUME);
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("finished"); })) << wire->state();
}

TEST_F(SupervisorNodeTest, ARestartedSupervisorHoldsAndGoesOnFromItsFile)
{
  namespace kind = stetro_msgs::msg::MissionRequest_Constants;
  run_until(0.2, [] { return false; });
  wire->request("1", kind::KIND_CLEAN_FLIGHT, "flight");
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("lift_block3"); })) << wire->state();
  stop_node();
  wire->status.reset();
  start_node();
  ASSERT_TRUE(run_until(1.0, [&] { return in_state("held"); })) << wire->state();
  EXPECT_EQ(wire->status->step(), 1);
  EXPECT_FALSE(run_until(2.0, [&] { return !in_state("held"); }));
  wire->request("2", kind::KIND_RESUME);
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("finished"); })) << wire->state();
}

TEST_F(SupervisorNodeTest, ADamagedMissionFileIsReportedAndNotUsed)
{
  stop_node();
  std::ofstream{params.state_file} << "stetro_mission 1\nactive 1\n";
  start_node();
  step();
  EXPECT_TRUE(run_until(1.0, [&] { return in_state("idle"); })) << wire->state();
  for (const auto & [task, report] : supervisor->node().diagnostics().reports()) {
    if (task == "mission") {
      EXPECT_EQ(report.health(), stetro_dds::Health::kError) << report.message();
    }
  }
}

TEST_F(SupervisorNodeTest, SilenceOfTheDriverHolds)
{
  run_until(0.2, [] { return false; });
  wire->request("1", stetro_msgs::msg::MissionRequest_Constants::KIND_CLEAN_FLIGHT, "flight");
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("sweep_left"); })) << wire->state();
  wire->silent = true;
  ASSERT_TRUE(run_until(1.0, [&] { return in_state("held"); })) << wire->state();
}

TEST_F(SupervisorNodeTest, WhatWaitedInAQueueIsNotFresh)
{
  run_until(0.2, [] { return false; });
  wire->request("1", stetro_msgs::msg::MissionRequest_Constants::KIND_CLEAN_FLIGHT, "flight");
  ASSERT_TRUE(run_until(300.0, [&] { return in_state("sweep_left"); })) << wire->state();
  clock_ahead = std::chrono::milliseconds(250);
  EXPECT_FALSE(run_until(1.0, [&] { return !in_state("sweep_left"); })) << "a late network";
  clock_ahead = std::chrono::milliseconds(800);
  EXPECT_TRUE(run_until(1.0, [&] { return in_state("held"); })) << wire->state();
}

TEST_F(SupervisorNodeTest, RefusesRequestsByTheirStampsAndSaysSo)
{
  namespace kind = stetro_msgs::msg::MissionRequest_Constants;
  namespace says = stetro_msgs::msg::MissionStatus_Constants;
  run_until(0.2, [] { return false; });
  const auto refusal = [&](const std::string & id) {
    run_until(0.2, [&] { return wire->status->request_id() == id.c_str(); });
    EXPECT_STREQ(wire->status->request_id().c_str(), id.c_str());
    EXPECT_EQ(wire->status->answer(), says::ANSWER_REFUSED);
    return std::string(wire->status->answer_reason().c_str());
  };
  wire->request_stamp = Time{0};
  wire->request("1", kind::KIND_CLEAN_FLIGHT, "flight");
  EXPECT_NE(refusal("1").find("zero"), std::string::npos);
  wire->request_stamp = std::chrono::seconds(1'700'000'000);  // the clock on the wall
  wire->request("2", kind::KIND_CLEAN_FLIGHT, "flight");
  ASSERT_TRUE(run_until(1.0, [&] { return in_state("steer_to_find"); })) << wire->state();
  *wire->request_stamp -= std::chrono::seconds(1);
  wire->request("3", kind::KIND_PAUSE);
  EXPECT_NE(refusal("3").find("before"), std::string::npos);
  EXPECT_EQ(wire->status->mission(), says::MISSION_RUNNING);
}

TEST_F(SupervisorNodeTest, TellsTheLocalizerAndAnswersWhenItHasFollowed)
{
  namespace says = stetro_msgs::msg::MissionStatus_Constants;
  run_until(0.2, [] { return false; });
  const auto answered = [&](const char * id) {
    return run_until(3.0, [&] { return wire->status->request_id() == id; });
  };
  wire->relocalise("a", 1);  // it stands before the first riser
  ASSERT_TRUE(answered("a"));
  EXPECT_EQ(wire->status->answer(), says::ANSWER_REFUSED);
  const std::string reason = wire->status->answer_reason().c_str();
  EXPECT_NE(reason.find("step 1, but x -0.600 m"), std::string::npos) << reason;
  EXPECT_FALSE(wire->told) << "it does not reach the localizer";

  wire->relocalise("b", 0);
  ASSERT_TRUE(answered("b"));
  EXPECT_EQ(wire->status->answer(), says::ANSWER_ACCEPTED) << wire->status->answer_reason().c_str();
  ASSERT_TRUE(wire->told);
  EXPECT_STREQ(wire->told->header().frame_id().c_str(), "flight");
  EXPECT_LE(stetro_dds::time_of(wire->told->header().stamp()), robot.now);
  EXPECT_EQ(wire->told->pose().pose().position().x(), robot.x_m);
  EXPECT_EQ(wire->told->pose().covariance()[7], 0.0025);
  EXPECT_EQ(diagnosed("last relocalisation"), "taken by the localizer");

  wire->localizer_takes = false;
  wire->relocalise("c", -1);
  EXPECT_FALSE(run_until(1.8, [&] { return wire->status->request_id() == "c"; }));
  EXPECT_EQ(diagnosed("last relocalisation"), "waits for the localizer");
  ASSERT_TRUE(answered("c"));
  EXPECT_EQ(wire->status->answer(), says::ANSWER_REFUSED);
  EXPECT_EQ(diagnosed("last relocalisation"), wire->status->answer_reason().c_str());
}

TEST_F(SupervisorNodeTest, AnUnknownFlightStartsNothing)
{
  stop_node();
  params.flight = "attic";
  EXPECT_THROW(start_node(), stetro_config::ConfigError);
  params.flight = "";
  start_node();
}

}  // namespace stetro_supervisor
