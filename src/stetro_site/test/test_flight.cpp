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

#include <limits>
#include <random>
#include <stdexcept>

#include "stetro_site/flight.hpp"

namespace stetro_site
{
namespace
{

FlightSpec papers_spec()
{
  FlightSpec spec;
  spec.id = "stairs";
  spec.steps = equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.05;
  return spec;
}

// S-B eq. (1), in centimetres as the papers print them: x = (i - 1/2) 32, z = i 14.
TEST(Flight, PlacesAllSixteenStepsOfThePapers)
{
  const Flight flight{papers_spec()};
  constexpr int kXCm[] = {16,  48,  80,  112, 144, 176, 208, 240,
                          272, 304, 336, 368, 400, 432, 464, 496};
  constexpr int kZCm[] = {14, 28, 42, 56, 70, 84, 98, 112, 126, 140, 154, 168, 182, 196, 210, 224};
  ASSERT_EQ(flight.steps(), 16);
  for (int i = 1; i <= 16; ++i) {
    EXPECT_NEAR(flight.tread_centre_m(i), kXCm[i - 1] / 100.0, 1e-12) << "step " << i;
    EXPECT_NEAR(flight.tread_z_m(i), kZCm[i - 1] / 100.0, 1e-12) << "step " << i;
  }
  EXPECT_NEAR(flight.total_rise_m(), 2.24, 1e-12);
  EXPECT_NEAR(flight.total_run_m(), 5.12, 1e-12);
  EXPECT_NEAR(flight.centre_to_centre_m(), 4.80, 1e-12);  // the papers' L (D1-10)
}

TEST(Flight, AddsUpStepsThatDiffer)
{
  FlightSpec spec = papers_spec();
  spec.steps = {{0.10, 0.30}, {0.15, 0.40}, {0.12, 0.35}};
  const Flight flight{spec};
  EXPECT_NEAR(flight.riser_x_m(1), 0.0, 1e-12);
  EXPECT_NEAR(flight.riser_x_m(3), 0.70, 1e-12);
  EXPECT_NEAR(flight.tread_start_m(2), 0.30, 1e-12);
  EXPECT_NEAR(flight.tread_end_m(2), 0.70, 1e-12);
  EXPECT_NEAR(flight.tread_centre_m(2), 0.50, 1e-12);
  EXPECT_NEAR(flight.tread_z_m(0), 0.0, 1e-12);
  EXPECT_NEAR(flight.tread_z_m(2), 0.25, 1e-12);
  EXPECT_NEAR(flight.total_rise_m(), 0.37, 1e-12);
  EXPECT_EQ(flight.highest_riser_m(), 0.15);
  EXPECT_EQ(flight.shortest_tread_m(), 0.30);
  EXPECT_EQ(flight.riser_m(3), 0.12);
  EXPECT_EQ(flight.tread_m(3), 0.35);
}

TEST(Flight, FindsTheStepUnderX)
{
  const Flight flight{papers_spec()};
  EXPECT_EQ(flight.step_at(-0.001), 0);
  EXPECT_EQ(flight.step_at(0.0), 1) << "the face of riser 1";
  EXPECT_EQ(flight.step_at(0.319), 1);
  EXPECT_EQ(flight.step_at(0.321), 2);
  EXPECT_EQ(flight.step_at(5.119), 16);
  EXPECT_EQ(flight.step_at(5.121), 16) << "the landing continues tread 16";
  EXPECT_EQ(flight.step_at(100.0), 16);
}

// Property: whatever the steps, a point inside tread i is on step i, and treads leave no gap.
TEST(Flight, FindsEveryTreadOfAnyFlight)
{
  std::mt19937 random{20250301};
  std::uniform_real_distribution<double> riser{0.05, 0.20};
  std::uniform_real_distribution<double> tread{0.20, 0.60};
  std::uniform_real_distribution<double> inside{0.001, 0.999};
  for (int sample = 0; sample < 100; ++sample) {
    FlightSpec spec = papers_spec();
    for (Step & step : spec.steps) {
      step = {riser(random), tread(random)};
    }
    const Flight flight{spec};
    for (int i = 1; i <= flight.steps(); ++i) {
      EXPECT_EQ(flight.step_at(flight.tread_start_m(i) + inside(random) * flight.tread_m(i)), i);
      EXPECT_NEAR(flight.tread_z_m(i) - flight.tread_z_m(i - 1), flight.riser_m(i), 1e-12);
      if (i > 1) {
        EXPECT_EQ(flight.tread_start_m(i), flight.tread_end_m(i - 1));
      }
    }
  }
}

TEST(Flight, WidensInAStraightLine)
{
  FlightSpec spec = papers_spec();
  spec.width_foot_m = 2.00;
  spec.width_top_m = 2.0512;  // 1 cm in a metre
  const Flight flight{spec};
  EXPECT_NEAR(flight.width_m(0.0), 2.00, 1e-12);
  EXPECT_NEAR(flight.width_m(1.0), 2.01, 1e-12);
  EXPECT_NEAR(flight.width_m(-1.0), 1.99, 1e-12) << "the wall runs on straight";
  EXPECT_EQ(flight.narrowest_m(), 2.00);
  EXPECT_EQ(flight.widest_m(), 2.0512);
}

TEST(Flight, RefusesStepsItDoesNotHave)
{
  const Flight flight{papers_spec()};
  EXPECT_THROW(static_cast<void>(flight.tread_m(0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(flight.riser_x_m(17)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(flight.tread_z_m(-1)), std::out_of_range);
}

TEST(Flight, RefusesNumbersThatMakeNoFlight)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](auto spoil) {
    FlightSpec spec = papers_spec();
    spoil(spec);
    EXPECT_THROW(Flight{spec}, std::invalid_argument);
  };
  refuses([](FlightSpec & s) { s.id = ""; });
  refuses([](FlightSpec & s) { s.steps = equal_steps(-1, 0.14, 0.32); });
  refuses([](FlightSpec & s) { s.steps[3].riser_m = 0.0; });
  refuses([&](FlightSpec & s) { s.steps[3].tread_m = nan; });
  refuses([](FlightSpec & s) { s.width_top_m = -1.0; });
  refuses([](FlightSpec & s) { s.wall_overrun_m = -0.1; });
  refuses([&](FlightSpec & s) { s.pose_in_map.yaw_rad = nan; });
}

}  // namespace
}  // namespace stetro_site
