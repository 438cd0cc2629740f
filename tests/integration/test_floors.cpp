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

// On a floor: somebody carries the robot off, and somebody tells it where it stands.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "integration/simulated_time.hpp"

namespace stetro_tests
{

namespace kind = stetro_msgs::msg::MissionRequest_Constants;
namespace says = stetro_msgs::msg::MissionStatus_Constants;
namespace pose_constants = stetro_msgs::msg::StairPose_Constants;
using stetro_msgs::msg::StairPose;

constexpr auto kAnswerWithin = 20s;
constexpr double kCarried_m = 0.5;  // from one truth to the next: a robot rolls millimetres
constexpr double kNoticed_s = 5.0;  // of motion
constexpr double kFound_m = 0.1;

double apart_m(const StairPose & a, const StairPose & b)
{
  const auto & p = a.pose().pose().position();
  const auto & q = b.pose().pose().position();
  return std::hypot(p.x() - q.x(), p.y() - q.y());
}

bool is_ok(const StairPose & pose) { return pose.integrity() == pose_constants::INTEGRITY_OK; }

/// On the landing, 3 m from the foot of the upper flight, looking elsewhere.
class OnTheLanding : public testing::Test
{
protected:
  static StackOptions options()
  {
    StackOptions landing;
    landing.site = find_share("stetro_bringup", "config/site/two_floors.yaml");
    landing.driver_extra = {
      {"flight", "upper"}, {"sim.start", "[-1.2, 3.6, 1.0]"}, {"sim.faults", "kidnap:landing@2"}};
    return landing;
  }

  /// Nobody has told the localizer where the robot starts: the supervisor finds it.
  void wait_until_found()
  {
    ASSERT_EQ(run_.wait_ready(), "");
    EXPECT_EQ(std::string(run_.pose.last()->segment_id().c_str()), "landing");
    EXPECT_LT(apart_m(*run_.pose.last(), *run_.truth.last()), kFound_m);
  }

  /// That the robot stands aside of the truth, told in the floor's frame.
  [[nodiscard]] Operator::Request told(double aside_x_m, double aside_y_m) const
  {
    const auto truth = run_.truth.last();
    Operator::Request request;
    request.header().frame_id("landing");
    request.kind(kind::KIND_RELOCALISE);
    request.segment_id("landing");
    request.pose().pose(truth->pose().pose());
    request.pose().pose().position().x(truth->pose().pose().position().x() + aside_x_m);
    request.pose().pose().position().y(truth->pose().pose().position().y() + aside_y_m);
    for (const std::size_t i : {0u, 7u, 35u}) {
      request.pose().covariance()[i] = 0.0025;  // x, y and heading within 5 cm and 3 degrees
    }
    request.step(0);
    return request;
  }

  /// Why the supervisor refused; "accepted" or "no answer" if it did not.
  [[nodiscard]] std::string refusal(const Operator::Request & request)
  {
    const auto status = run_.operators.ask(request, kAnswerWithin);
    if (!status) {
      return "no answer";
    }
    return status->answer() == says::ANSWER_REFUSED ? status->answer_reason().c_str() : "accepted";
  }

  /// Sends the robot to the foot of the upper flight.
  [[nodiscard]] std::string go()
  {
    Operator::Request request;
    request.kind(kind::KIND_GO_TO_SEGMENT);
    request.segment_id("upper");
    request.step(kind::STEP_UNKNOWN);
    return refusal(request);
  }

  RobotRun run_{options()};
};

TEST_F(OnTheLanding, AKidnapIsNoticedAndTheRobotFindsItsWay)
{
  wait_until_found();
  const std::size_t first = run_.truth.count();
  const auto accepted = [this] { return go() == "accepted"; };
  ASSERT_TRUE(poll_until(accepted, kPatience)) << "the supervisor has to hear of the pose, too\n"
                                               << run_.stack.tails();
  run_.pose.forget();
  const auto noticed = run_.pose.wait_for(
    [](const StairPose & pose) {
      return (pose.reasons() & pose_constants::REASON_PROFILE_DISAGREES) != 0u;
    },
    kPatience);
  ASSERT_TRUE(noticed) << run_.stack.tails();
  const Truths truths = run_.truth.samples(first);
  bool carried = false;
  double moved_s = 0.0;
  for (std::size_t i = 1; i < truths.size(); ++i) {
    const Displacement step = between(truths[i - 1].message, truths[i].message);
    if (time_of(truths[i].message) > time_of(*noticed)) {
      break;
    }
    const auto dt = time_of(truths[i].message) - time_of(truths[i - 1].message);
    moved_s += carried && moved(step) ? std::chrono::duration<double>(dt).count() : 0.0;
    carried = carried || step.position_m > kCarried_m;
  }
  ASSERT_TRUE(carried) << "it doubts its pose before anybody has carried it off";
  EXPECT_LT(moved_s, kNoticed_s);
  ASSERT_TRUE(run_.pose.wait_for(is_ok, kPatience)) << run_.stack.tails();
  EXPECT_LT(apart_m(*run_.pose.last(), *run_.truth.last()), kFound_m);
  const auto finished = run_.operators.status().wait_for(
    [](const Operator::Status & status) { return status.mission() == says::MISSION_FINISHED; },
    2 * kPatience);
  ASSERT_TRUE(finished) << run_.stack.tails();
  // Half a metre before the flight's first riser: at (10.62, 3.575) of the landing.
  const auto & at = run_.truth.last()->pose().pose().position();
  EXPECT_NEAR(at.x(), 10.62, 0.1);
  EXPECT_NEAR(at.y(), 3.575, 0.1);
}

TEST_F(OnTheLanding, APersonTellsTheRobotWhereItStands)
{
  wait_until_found();
  const StairPose before = run_.pose.last().value();
  const std::string behind_a_wall = refusal(told(5.0, 0.0));
  EXPECT_NE(behind_a_wall.find("in a wall or outside"), std::string::npos) << behind_a_wall;
  auto elsewhere = told(0.0, 0.0);
  elsewhere.segment_id("attic");
  const std::string no_floor = refusal(elsewhere);
  EXPECT_NE(no_floor.find("segment_id 'attic'"), std::string::npos) << no_floor;
  EXPECT_EQ(run_.pose.last()->reset_counter(), before.reset_counter()) << "nothing was told";

  run_.pose.forget();
  const auto right = told(0.03, 0.0);
  ASSERT_EQ(refusal(right), "accepted") << run_.stack.tails();
  const auto jumped = run_.pose.wait_for(
    [&](const StairPose & pose) { return pose.reset_counter() != before.reset_counter(); },
    kPatience);
  ASSERT_TRUE(jumped) << run_.stack.tails();
  EXPECT_EQ(jumped->reset_counter(), before.reset_counter() + 1);
  EXPECT_NEAR(jumped->pose().pose().position().x(), right.pose().pose().position().x(), 0.02);
}

// Who is told wrongly looks for itself.
TEST_F(OnTheLanding, APersonWhoIsWrongIsContradicted)
{
  wait_until_found();
  const auto before = run_.pose.last()->reset_counter();
  const auto wrong = told(0.0, 1.0);
  ASSERT_EQ(refusal(wrong), "accepted") << run_.stack.tails();
  run_.pose.forget();
  const auto back = run_.pose.wait_for(
    [&](const StairPose & pose) {
      return is_ok(pose) && pose.reset_counter() == before + 2 &&
             apart_m(pose, *run_.truth.last()) < kFound_m;
    },
    kPatience);
  EXPECT_TRUE(back) << run_.stack.tails();
}

}  // namespace stetro_tests
