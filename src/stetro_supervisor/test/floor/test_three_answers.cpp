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

#include "stetro_supervisor/floor/three_answers.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kSigmas = 3.5;

FloorPlace at(double x_m, double yaw_rad, double sigma_m, double sigma_rad)
{
  FloorPlace place{"ground", {x_m, 1.0}, yaw_rad, Eigen::Matrix3d::Zero()};
  place.covariance.diagonal() << sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad;
  return place;
}

ThreeAnswers answers(double profile_x_m)
{
  ThreeAnswers three;
  three.told = at(2.0, 0.0, 0.04, 0.01);
  three.profile_verdict = Verdict::kCorrected;
  three.profile = at(profile_x_m, 0.0, 0.03, 0.01);
  return three;
}

}  // namespace

// 4 cm and 3 cm are 5 cm together: 17 cm are 3.4 of them, 18 cm are 3.6.
TEST(ThreeAnswers, AgreeWithinTheirErrorsTogether)
{
  const Conclusion near = weigh(answers(2.17), kSigmas);
  EXPECT_EQ(near.verdict, Verdict::kAgrees);
  EXPECT_NEAR(near.distance, 3.4, 1e-9);
  EXPECT_TRUE(near.corrects) << "small corrections are worth telling too";
  EXPECT_FALSE(near.against_told);
  const Conclusion far = weigh(answers(2.18), kSigmas);
  EXPECT_EQ(far.verdict, Verdict::kCorrected);
  EXPECT_TRUE(far.corrects);
  EXPECT_TRUE(far.against_told);
}

TEST(ThreeAnswers, CompareHeadingsAcrossPi)
{
  ThreeAnswers three = answers(2.0);
  three.told.yaw_rad = 3.14;
  three.profile->yaw_rad = -3.14;  // 0.0032 rad on
  EXPECT_EQ(weigh(three, kSigmas).verdict, Verdict::kAgrees);
}

TEST(ThreeAnswers, SayNothingWhenTheBeamsExcludeTheProfilesPlace)
{
  ThreeAnswers three = answers(3.0);
  three.beams_allow_profile = false;
  const Conclusion conclusion = weigh(three, kSigmas);
  EXPECT_EQ(conclusion.verdict, Verdict::kNoVerdict);
  EXPECT_FALSE(conclusion.corrects);
  EXPECT_FALSE(conclusion.against_told);
  three.beams_allow_told = false;
  EXPECT_TRUE(weigh(three, kSigmas).against_told);
}

TEST(ThreeAnswers, ACrowdAloneIsNotAgainstThePose)
{
  ThreeAnswers three = answers(2.0);
  three.profile.reset();
  three.profile_verdict = Verdict::kNoVerdict;
  three.profile_reason = NoVerdictReason::kNotExplained;
  EXPECT_FALSE(weigh(three, kSigmas).against_told);
  three.beams_allow_told = false;
  EXPECT_TRUE(weigh(three, kSigmas).against_told);
  three.beams_allow_told = true;
  three.profile_reason = NoVerdictReason::kBeyondTheWalls;
  EXPECT_TRUE(weigh(three, kSigmas).against_told) << "beams through walls speak against it";
}

// Where the floor has changed the ends of the beams bear a pose out, and contradict none.
TEST(ThreeAnswers, EndsBearOutWhatWasTold)
{
  ThreeAnswers three = answers(2.17);
  three.by_ends = true;
  three.profile_reason = NoVerdictReason::kBeyondTheWalls;
  const Conclusion near = weigh(three, kSigmas);
  EXPECT_EQ(near.verdict, Verdict::kAgrees);
  EXPECT_TRUE(near.corrects);
  EXPECT_FALSE(near.against_told);
  three.beams_allow_told = false;
  EXPECT_TRUE(weigh(three, kSigmas).against_told);
  EXPECT_FALSE(weigh(three, kSigmas).corrects);
}

TEST(ThreeAnswers, EndsElsewhereCountAsNoProfile)
{
  ThreeAnswers three = answers(2.5);
  three.by_ends = true;
  three.profile_reason = NoVerdictReason::kNotExplained;
  EXPECT_EQ(weigh(three, kSigmas).verdict, Verdict::kNoVerdict);
  EXPECT_FALSE(weigh(three, kSigmas).corrects);
  EXPECT_FALSE(weigh(three, kSigmas).against_told);
  three.profile_reason = NoVerdictReason::kBeyondTheWalls;
  EXPECT_TRUE(weigh(three, kSigmas).against_told) << "the beams through walls still speak";
}

TEST(ThreeAnswers, SeveralPlacesAreAmbiguous)
{
  ThreeAnswers three = answers(2.0);
  three.profile.reset();
  three.profile_verdict = Verdict::kAmbiguous;
  const Conclusion conclusion = weigh(three, kSigmas);
  EXPECT_EQ(conclusion.verdict, Verdict::kAmbiguous);
  EXPECT_FALSE(conclusion.corrects);
}

}  // namespace stetro_supervisor
