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

// Another vendor's DDS beside the running robot: it hears, it commands, and every kind of reader
// that ROS 2 tools use gets its data.

#include <MissionRequest.h>
#include <MissionStatus.h>
#include <PoseWithCovarianceStamped.h>
#include <StairPose.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <string>

#include "cyclone/known_topics.hpp"
#include "cyclone/peer.hpp"
#include "integration/simulated_time.hpp"
#include "stetro_msgs/MissionRequest.hpp"
#include "stetro_msgs/MissionStatus.hpp"

namespace stetro_tests
{

namespace kind = stetro_msgs::msg::MissionRequest_Constants;
namespace says = stetro_msgs::msg::MissionStatus_Constants;
using CyclonePose = geometry_msgs_msg_dds__PoseWithCovarianceStamped_;
using CycloneStairPose = stetro_msgs_msg_dds__StairPose_;
using CycloneRequest = stetro_msgs_msg_dds__MissionRequest_;
using CycloneStatus = stetro_msgs_msg_dds__MissionStatus_;
constexpr cyclone::Quality kReliable{true, false, 5};
constexpr cyclone::Quality kBestEffort{false, false, 5};
constexpr cyclone::Quality kLatched{true, true, 1};

class StackWithCyclone : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    run_ = std::make_unique<RobotRun>();
    theirs_ = std::make_unique<cyclone::Peer>(run_->domain.id());
    ASSERT_EQ(run_->wait_ready(), "");
  }

  static void TearDownTestSuite()
  {
    theirs_.reset();
    run_.reset();
  }

  static std::unique_ptr<RobotRun> run_;
  static std::unique_ptr<cyclone::Peer> theirs_;
};

std::unique_ptr<RobotRun> StackWithCyclone::run_;
std::unique_ptr<cyclone::Peer> StackWithCyclone::theirs_;

CycloneRequest request(const char * id, std::uint8_t request_kind)
{
  static char no_frame[] = "";
  CycloneRequest result{};
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  result.header.stamp.sec =
    static_cast<std::int32_t>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
  result.header.frame_id = no_frame;
  std::strncpy(result.request_id, id, sizeof result.request_id - 1);
  std::strncpy(result.issuer, "cyclone", sizeof result.issuer - 1);
  std::strncpy(result.segment_id, "stairs", sizeof result.segment_id - 1);
  result.kind = request_kind;
  result.step = kind::STEP_UNKNOWN;
  return result;
}

TEST_F(StackWithCyclone, HearsPoseStairPoseAndMissionStatus)
{
  cyclone::Reader<CyclonePose> pose(
    *theirs_, geometry_msgs_msg_dds__PoseWithCovarianceStamped__desc, "rt/stetro/pose", kReliable);
  cyclone::Reader<CycloneStairPose> stair_pose(
    *theirs_, stetro_msgs_msg_dds__StairPose__desc, "rt/stetro/stair_pose", kLatched);
  cyclone::Reader<CycloneStatus> status(
    *theirs_, stetro_msgs_msg_dds__MissionStatus__desc, "rt/stetro/mission_status", kLatched);

  EXPECT_TRUE(pose.wait_for(
    [](const CyclonePose & seen) { return std::strcmp(seen.header.frame_id, "map") == 0; }, 10s))
    << run_->stack.tails();
  EXPECT_TRUE(stair_pose.wait_for(
    [](const CycloneStairPose & seen) {
      return std::strcmp(seen.segment_id, "stairs") == 0 && seen.step_count == 4;
    },
    10s))
    << run_->stack.tails();
  EXPECT_TRUE(status.wait_for(
    [](const CycloneStatus & seen) { return seen.mission == says::MISSION_IDLE; }, 10s))
    << run_->stack.tails();
}

TEST_F(StackWithCyclone, EveryKindOfReaderGetsEverySensorTopic)
{
  for (const auto & topic : cyclone::published_topics()) {
    if (!topic.sensor || !topic.spoken) {
      continue;
    }
    const dds_entity_t entity = theirs_->make_topic(*topic.type, topic.dds_name());
    const auto anything = [](const void *) { return true; };
    EXPECT_TRUE(cyclone::wait_for_sample(theirs_->make_reader(entity, kReliable), anything, 10s))
      << topic.name << ", as RViz asks for it";
    EXPECT_TRUE(cyclone::wait_for_sample(theirs_->make_reader(entity, kBestEffort), anything, 10s))
      << topic.name << ", as sensor data";
  }
}

TEST_F(StackWithCyclone, ALateJoinerGetsEveryLatchedTopic)
{
  for (const auto & topic : cyclone::published_topics()) {
    if (!topic.latched) {
      continue;
    }
    const dds_entity_t reader =
      theirs_->make_reader(theirs_->make_topic(*topic.type, topic.dds_name()), kLatched);
    EXPECT_TRUE(cyclone::wait_for_sample(
      reader, [](const void *) { return true; }, 10s))
      << topic.name;
  }
}

bool is_answer(const CycloneStatus & status, const std::string & id)
{
  return id == status.request_id && std::strcmp(status.issuer, "cyclone") == 0 &&
         status.answer != says::ANSWER_NONE;
}

// The last one: it sets the robot in motion.
TEST_F(StackWithCyclone, StartsAndPausesAMission)
{
  cyclone::Writer<CycloneRequest> requests(
    *theirs_, stetro_msgs_msg_dds__MissionRequest__desc, "rt/stetro/mission", kReliable);
  cyclone::Reader<CycloneStatus> status(
    *theirs_, stetro_msgs_msg_dds__MissionStatus__desc, "rt/stetro/mission_status", kLatched);
  const auto answered = [&](const std::string & id, std::uint8_t mission) {
    return status.wait_for(
      [&](const CycloneStatus & seen) {
        return is_answer(seen, id) && seen.answer == says::ANSWER_ACCEPTED &&
               seen.mission == mission;
      },
      20s);
  };
  ASSERT_TRUE(poll_until([&] { return requests.matched() > 0; }, 10s));

  // Right after the start the pose may not be trusted yet: a refusal is final for its id only.
  std::string start;
  int asked = 0;
  const auto accepted = [&] {
    start = "start-" + std::to_string(++asked);
    bool yes = false;
    requests.write(request(start.c_str(), kind::KIND_CLEAN_FLIGHT));
    status.wait_for(
      [&](const CycloneStatus & seen) {
        yes = is_answer(seen, start) && seen.answer == says::ANSWER_ACCEPTED;
        return is_answer(seen, start);
      },
      5s);
    return yes;
  };
  ASSERT_TRUE(poll_until(accepted, 20s)) << run_->stack.tails();
  ASSERT_TRUE(answered(start, says::MISSION_RUNNING)) << run_->stack.tails();
  const std::size_t first = run_->truth.count() - 1;
  EXPECT_TRUE(poll_until([&] { return last_motion(run_->truth.samples(first)).count() > 0; }, 20s));

  ASSERT_TRUE(requests.write(request("pause", kind::KIND_PAUSE)));
  ASSERT_TRUE(answered("pause", says::MISSION_PAUSED)) << run_->stack.tails();
  ASSERT_TRUE(let_pass(*run_, 1s));
  const auto standing = now_simulated(*run_);
  ASSERT_TRUE(let_pass(*run_, 2s));
  EXPECT_EQ(last_motion(truths_after(*run_, first, standing)).count(), 0);
}

}  // namespace stetro_tests
