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

#include "stetro_bringup/journey_report.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""s;
using std::chrono_literals::operator""ms;

/// A floor, ten steps up from its right-hand corner at (5, 1), and a floor above.
stetro_site::Site building()
{
  stetro_site::FlightSpec flight;
  flight.id = "stairs";
  flight.steps = stetro_site::equal_steps(10, 0.14, 0.32);
  flight.width_foot_m = flight.width_top_m = 2.0;
  flight.pose_in_map = {5.0, 1.0, 0.0, 0.0};
  flight.lower_floor = "ground";
  flight.upper_floor = "first";
  stetro_site::SiteSpec spec;
  spec.name = "building";
  spec.floors = {{"ground", {}, {}}, {"first", {8.2, 0.0, 1.4, M_PI / 2.0}, {}}};
  spec.flights = {stetro_site::Flight(flight)};
  return stetro_site::Site(spec);
}

StairSample sample(const std::string & segment, double x_m, double y_m, double yaw_rad = 0.0)
{
  StairSample one;
  one.segment = segment;
  one.x_m = x_m;
  one.y_m = y_m;
  one.heading_rad = yaw_rad;
  return one;
}

TraceRow row(
  std::chrono::nanoseconds since, const StairSample & estimate, const StairSample & truth,
  const char * integrity = "OK")
{
  TraceRow one;
  one.estimate = estimate;
  one.estimate.stamp = 1000s + since;
  one.truth = truth;
  one.integrity = integrity;
  return one;
}

}  // namespace

TEST(SegmentFrames, PlaceASampleInMap)
{
  const SegmentFrames frames(building());
  const auto on_stairs = frames.in_map(sample("stairs", 0.1, 0.5, 0.2));
  ASSERT_TRUE(on_stairs);
  EXPECT_NEAR(on_stairs->x_m, 5.1, 1e-12);
  EXPECT_NEAR(on_stairs->y_m, 1.5, 1e-12);
  EXPECT_NEAR(on_stairs->yaw_rad, 0.2, 1e-12);
  const auto on_first = frames.in_map(sample("first", 1.0, 0.5));
  ASSERT_TRUE(on_first);
  EXPECT_NEAR(on_first->x_m, 7.7, 1e-12);  // 8.2 - 0.5: its x axis is map's y axis
  EXPECT_NEAR(on_first->y_m, 1.0, 1e-12);
  EXPECT_NEAR(on_first->z_m, 1.4, 1e-12);
  EXPECT_FALSE(frames.in_map(sample("cellar", 0.0, 0.0)));
  EXPECT_FALSE(frames.in_map(sample("ground", std::nan(""), 0.0)));
}

TEST(JourneyReport, MeasuresAHandOverBeyondTheMotion)
{
  JourneyReport report{SegmentFrames(building())};
  report.add(row(0ms, sample("ground", 4.40, 2.02), sample("ground", 4.41, 2.00)));
  // The robot rolls 1 cm; the estimate goes 1 cm and 3 mm aside, and turns by 0.01.
  report.add(row(33ms, sample("stairs", -0.59, 1.023, 0.01), sample("ground", 4.42, 2.00)));
  ASSERT_EQ(report.hand_overs().size(), 1u);
  EXPECT_EQ(report.hand_overs()[0].from, "ground");
  EXPECT_EQ(report.hand_overs()[0].to, "stairs");
  EXPECT_NEAR(report.hand_overs()[0].jump_m, 0.003, 1e-12);
  EXPECT_NEAR(report.hand_overs()[0].turn_rad, 0.01, 1e-12);
  EXPECT_NEAR(report.hand_overs()[0].time_s, 0.033, 1e-12);
  // The truth follows into the same frame: no jump of either.
  report.add(row(66ms, sample("stairs", -0.58, 1.023, 0.01), sample("stairs", -0.57, 1.0)));
  EXPECT_EQ(report.hand_overs().size(), 1u);
  EXPECT_TRUE(report.kidnaps().empty());
}

TEST(JourneyReport, APoseFoundAnewIsNoHandOver)
{
  JourneyReport report{SegmentFrames(building())};
  report.add(row(0ms, sample("ground", 1.0, 1.0), sample("first", 1.0, 1.0), "LOST"));
  report.add(row(33ms, sample("first", 1.0, 1.0), sample("first", 1.0, 1.0)));
  EXPECT_TRUE(report.hand_overs().empty());
}

TEST(JourneyReport, CountsTheMotionUntilAKidnapIsNoticed)
{
  JourneyReport report{SegmentFrames(building())};
  report.add(row(0s, sample("ground", 1.0, 1.0), sample("ground", 1.0, 1.0)));
  report.add(row(1s, sample("ground", 1.0, 1.0), sample("ground", 2.0, 1.0, 0.5)));  // carried
  report.add(row(2s, sample("ground", 1.0, 1.0), sample("ground", 2.0, 1.0, 0.5)));  // stands
  report.add(row(3s, sample("ground", 1.2, 1.0), sample("ground", 2.2, 1.0, 0.5)));
  ASSERT_EQ(report.kidnaps().size(), 1u);
  EXPECT_EQ(report.kidnaps()[0].from.x_m, 1.0);
  EXPECT_EQ(report.kidnaps()[0].to.x_m, 2.0);
  auto doubted = row(3s, sample("ground", 1.2, 1.0), sample("ground", 2.2, 1.0, 0.5), "DEGRADED");
  doubted.reasons = 2u;
  report.add(doubted);
  EXPECT_FALSE(report.kidnaps()[0].noticed_after_s) << "a doubt for another reason";
  report.add(row(4s, sample("ground", 1.4, 1.0), sample("ground", 2.4, 1.0, 0.5), "LOST"));
  EXPECT_NEAR(report.kidnaps()[0].distance_m, 1.0, 1e-12);
  EXPECT_NEAR(report.kidnaps()[0].turned_rad, 0.5, 1e-12);
  ASSERT_TRUE(report.kidnaps()[0].noticed_after_s);
  EXPECT_NEAR(*report.kidnaps()[0].noticed_after_s, 2.0, 1e-12);
  // OK and wrong is not relocalised.
  report.add(row(5s, sample("ground", 1.4, 1.0), sample("ground", 2.4, 1.0, 0.5)));
  EXPECT_FALSE(report.kidnaps()[0].relocalised_after_s);
  report.add(row(6s, sample("ground", 2.4, 1.1, 0.5), sample("ground", 2.4, 1.0, 0.5)));
  ASSERT_TRUE(report.kidnaps()[0].relocalised_after_s);
  EXPECT_NEAR(*report.kidnaps()[0].relocalised_after_s, 2.0, 1e-12);
}

}  // namespace stetro_bringup
