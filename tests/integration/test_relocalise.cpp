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

// A person tells where the robot stands: the pose follows, or the answer says why not.

#include <gtest/gtest.h>

#include <string>

#include "integration/simulated_time.hpp"

namespace stetro_tests
{

namespace kind = stetro_msgs::msg::MissionRequest_Constants;
namespace says = stetro_msgs::msg::MissionStatus_Constants;
namespace pose_constants = stetro_msgs::msg::StairPose_Constants;
using stetro_msgs::msg::StairPose;

constexpr auto kAnswerWithin = 20s;
constexpr double kAside = 0.03;  // told beside the truth, to see it followed [m]

class Relocalise : public testing::TestWithParam<std::string>
{
protected:
  static StackOptions with_estimator(const std::string & name)
  {
    StackOptions options;
    options.localizer_extra = {{"estimator", name}};
    return options;
  }

  /// That the robot stands where the truth is, but for its y.
  [[nodiscard]] Operator::Request told(double aside_m, int step) const
  {
    const auto truth = run_.truth.last();
    Operator::Request request;
    request.header().frame_id("stairs");
    request.kind(kind::KIND_RELOCALISE);
    request.segment_id("stairs");
    request.pose().pose(truth->pose().pose());
    request.pose().pose().position().y(truth->pose().pose().position().y() + aside_m);
    for (const std::size_t i : {0u, 7u, 35u}) {
      request.pose().covariance()[i] = 0.0025;  // x, y and heading within 5 cm and 3 degrees
    }
    request.step(step);
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

  /// All three have spoken; far from the first riser the pose need not be sound.
  void wait_until_heard()
  {
    ASSERT_TRUE(run_.truth.wait_next(kPatience)) << run_.stack.tails();
    ASSERT_TRUE(run_.operators.status().wait_next(kPatience)) << run_.stack.tails();
    const auto on_the_floor = [](const StairPose & pose) { return pose.step_index() == 0; };
    ASSERT_TRUE(run_.pose.wait_for(on_the_floor, kPatience)) << run_.stack.tails();
  }

  void pause()
  {
    const auto paused = run_.operators.ask(kind::KIND_PAUSE, kAnswerWithin);
    ASSERT_TRUE(paused && paused->answer() == says::ANSWER_ACCEPTED) << run_.stack.tails();
    ASSERT_TRUE(let_pass(run_, 1s)) << "the wheels come to rest";
  }

  RobotRun run_{with_estimator(GetParam())};
};

TEST_P(Relocalise, TheLocalizerFollowsAndThePausedClimbGoesOnWhenAsked)
{
  wait_until_heard();
  ASSERT_EQ(run_.operators.start_climb(kPatience), "") << run_.stack.tails();
  ASSERT_EQ(wait_moment(run_, {"sweep_left", 1}), "");
  const std::string moving = refusal(told(kAside, 1));
  EXPECT_NE(moving.find("the mission is running"), std::string::npos) << moving;
  pause();
  const std::string wrong_step = refusal(told(kAside, 3));
  EXPECT_NE(wrong_step.find("step 3, but x"), std::string::npos) << wrong_step;
  EXPECT_NE(wrong_step.find("step 1"), std::string::npos) << wrong_step;

  const StairPose before = run_.pose.last().value();
  const std::size_t first_truth = run_.truth.count() - 1;
  const auto request = told(kAside, 1);
  run_.pose.forget();
  ASSERT_EQ(refusal(request), "accepted") << run_.stack.tails();
  const auto jumped = run_.pose.wait_for(
    [&](const StairPose & pose) { return pose.reset_counter() != before.reset_counter(); },
    kPatience);
  ASSERT_TRUE(jumped) << run_.stack.tails();
  EXPECT_EQ(jumped->reset_counter(), before.reset_counter() + 1);
  EXPECT_EQ(jumped->step_index(), 1);
  const double told_y_m = request.pose().pose().position().y();
  EXPECT_NEAR(jumped->pose().pose().position().y(), told_y_m, 1e-6);
  const double was_y_m = before.pose().pose().position().y();
  EXPECT_NEAR(jumped->reset_delta_y(), told_y_m - was_y_m, 0.01);
  EXPECT_NEAR(jumped->reset_delta_z(), 0.0, 0.02);

  run_.pose.forget();
  const auto sound = run_.pose.wait_for(
    [](const StairPose & p) { return p.integrity() == pose_constants::INTEGRITY_OK; }, kPatience);
  ASSERT_TRUE(sound) << run_.stack.tails();
  EXPECT_EQ(sound->reset_counter(), before.reset_counter() + 1) << "one jump, not two";
  ASSERT_TRUE(let_pass(run_, 2s));
  EXPECT_EQ(last_motion(run_.truth.samples(first_truth)).count(), 0)
    << "nothing may move before it is asked to";

  ASSERT_EQ(run_.operators.resume(kPatience), "") << run_.stack.tails();
  EXPECT_EQ(wait_moment(run_, {"sweep_left", 2}), "");
  EXPECT_EQ(contradicted_step(run_, first_truth), "");
}

TEST_P(Relocalise, IsRefusedWhenNoLocalizerFollows)
{
  wait_until_heard();
  const auto accepted = [this] { return refusal(told(0.0, 0)) == "accepted"; };
  ASSERT_TRUE(poll_until(accepted, kPatience)) << "the supervisor has to hear the localizer\n"
                                               << run_.stack.tails();
  run_.stack.localizer().kill_hard();
  const std::string reason = refusal(told(0.0, 0));
  EXPECT_NE(reason.find("has not taken the pose within 2 s"), std::string::npos) << reason;
}

INSTANTIATE_TEST_SUITE_P(
  Estimators, Relocalise, testing::Values("paper", "fused"),
  [](const testing::TestParamInfo<std::string> & name) { return name.param; });

}  // namespace stetro_tests
