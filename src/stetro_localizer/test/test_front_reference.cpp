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

#include "stetro_localizer/front_reference.hpp"

namespace stetro_localizer
{
namespace
{

stetro_site::Flight papers_flight()
{
  stetro_site::FlightSpec spec;
  spec.id = "papers";
  spec.steps = stetro_site::equal_steps(16, 0.14, 0.32);
  spec.width_foot_m = spec.width_top_m = 2.05;
  return stetro_site::Flight(spec);
}

TEST(FrontReference, IsTheNextRiserAbove)
{
  const auto flight = papers_flight();
  EXPECT_EQ(riser_ahead(flight, 0.07, 0.015), 1) << "block 1 on the floor";
  EXPECT_EQ(riser_ahead(flight, 0.14 + 0.07, 0.015), 2) << "block 1 on tread 1";
  EXPECT_EQ(riser_ahead(flight, 0.14 + 0.18 + 0.07, 0.015), 3) << "lifted from tread 1";
}

// While block 2 sweeps N - 1 and N, block 1 is level with the landing: no reference.
TEST(FrontReference, EndsWithTheFlight)
{
  const auto flight = papers_flight();
  EXPECT_EQ(riser_ahead(flight, 15 * 0.14 + 0.07, 0.015), 16) << "block 1 on tread 15";
  EXPECT_FALSE(riser_ahead(flight, 16 * 0.14 + 0.07, 0.015)) << "block 1 on tread 16";
}

TEST(FrontReference, IsNotTrustedCloseToANosing)
{
  const auto flight = papers_flight();
  EXPECT_FALSE(riser_ahead(flight, 0.13, 0.015));
  EXPECT_FALSE(riser_ahead(flight, 0.15, 0.015));
  EXPECT_EQ(riser_ahead(flight, 0.16, 0.015), 2);
}

}  // namespace
}  // namespace stetro_localizer
