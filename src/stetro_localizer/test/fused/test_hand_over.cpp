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

#include "stetro_localizer/fused/hand_over.hpp"

namespace stetro_localizer
{
namespace
{

constexpr Nanoseconds kStart = std::chrono::seconds(1000);
constexpr double kTau_s = 0.1;

Nanoseconds after(double s) { return kStart + nanoseconds(s); }

// A second sensor comes into sight and moves the filter by 10 mm along y: nothing of it is seen at
// first, after tau all but 1/e, after ten nothing is missing.
TEST(HandOver, LetsACorrectionOutOverTime)
{
  HandOver hand_over(kTau_s);
  hand_over.note(0b01, kStart, {0.0, 0.0});
  hand_over.note(0b11, after(0.033), {0.0, 0.010});
  EXPECT_NEAR(hand_over.withheld_m(1, after(0.033)), -0.010, 1e-12);
  EXPECT_NEAR(hand_over.withheld_m(1, after(0.133)), -0.010 / std::exp(1.0), 1e-12);
  EXPECT_NEAR(hand_over.withheld_m(1, after(1.033)), 0.0, 1e-6);
  EXPECT_EQ(hand_over.withheld_m(0, after(0.033)), 0.0);
}

TEST(HandOver, WithholdsNothingFromTheSameSensors)
{
  HandOver hand_over(kTau_s);
  hand_over.note(0b11, kStart, {0.0, 0.0});
  hand_over.note(0b11, after(0.033), {0.004, 0.010});
  EXPECT_EQ(hand_over.withheld_m(0, after(0.033)), 0.0);
  EXPECT_EQ(hand_over.withheld_m(1, after(0.033)), 0.0);
}

// What was withheld goes on shrinking while later samples come, from the same sensors or others.
TEST(HandOver, AddsWhatIsWithheldAnew)
{
  HandOver hand_over(kTau_s);
  hand_over.note(0b01, kStart, {0.0, 0.0});
  hand_over.note(0b11, kStart, {0.008, 0.0});
  hand_over.note(0b11, after(kTau_s), {0.002, 0.0});
  EXPECT_NEAR(hand_over.withheld_m(0, after(kTau_s)), -0.008 / std::exp(1.0), 1e-12);
  hand_over.note(0b10, after(kTau_s), {-0.003, 0.0});
  EXPECT_NEAR(hand_over.withheld_m(0, after(kTau_s)), -0.008 / std::exp(1.0) + 0.003, 1e-12);
}

TEST(HandOver, AContactLetsAllOut)
{
  HandOver hand_over(kTau_s);
  hand_over.note(0b01, kStart, {0.005, 0.010});
  hand_over.let_out(1);
  EXPECT_EQ(hand_over.withheld_m(1, kStart), 0.0);
  EXPECT_NEAR(hand_over.withheld_m(0, kStart), -0.005, 1e-12);
}

// 3 cm are withheld at most, and with no time nothing is.
TEST(HandOver, DoesNotHideWhatIsAJump)
{
  HandOver hand_over(kTau_s);
  hand_over.note(0b01, kStart, {0.05, -0.05});
  EXPECT_EQ(hand_over.withheld_m(0, kStart), -0.03);
  EXPECT_EQ(hand_over.withheld_m(1, kStart), 0.03);
  HandOver at_once(0.0);
  at_once.note(0b01, kStart, {0.01, 0.01});
  EXPECT_EQ(at_once.withheld_m(0, kStart), 0.0);
}

}  // namespace
}  // namespace stetro_localizer
