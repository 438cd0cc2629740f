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

#include "stetro_config/loader.hpp"
#include "stetro_config/report.hpp"
#include "stetro_localizer/params.hpp"

namespace stetro_localizer
{
namespace
{

/// A loader with the two files that have no default.
struct Loader : stetro_config::Loader<LocalizerParams>
{
  Loader()
  {
    set("site_file", "site.yaml", "command line");
    set("robot_file", "robot.yaml", "command line");
  }
};

TEST(Params, DefaultsAreInTheirOwnBounds)
{
  Loader loader;
  EXPECT_NO_THROW(static_cast<void>(loader.finish()));
}

TEST(Params, CollectEveryFault)
{
  Loader loader;
  loader.set("lateral.gate_sgima", "4.0", "command line");
  loader.set("estimator", "best", "command line");
  loader.set("gyro.white_radps", "-1.0", "command line");
  stetro_config::Faults faults;
  static_cast<void>(loader.finish(faults));
  EXPECT_EQ(faults.size(), 3u);
}

TEST(Params, RefuseWindowsThatCannotFill)
{
  Loader loader;
  loader.set("lateral.average.window", "4", "command line");
  loader.set("lateral.average.least_count", "5", "command line");
  stetro_config::Faults faults;
  static_cast<void>(loader.finish(faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "lateral.average.least_count");
}

// What is too old for the estimator never reaches the window.
TEST(Params, RefuseAWindowThatSamplesCannotReach)
{
  Loader loader;
  loader.set("fused.window_s", "0.4", "command line");
  loader.set("max_sample_age_s", "0.35", "command line");
  stetro_config::Faults faults;
  static_cast<void>(loader.finish(faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "fused.window_s");
}

TEST(Params, RefuseARetreatWithoutRoomBeforeTheApproach)
{
  Loader loader;
  loader.set("floor.retreat_yaw_rad", "0.4", "command line");
  stetro_config::Faults faults;
  static_cast<void>(loader.finish(faults));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].name, "floor.retreat_yaw_rad");
}

TEST(Params, DocumentEveryName)
{
  const std::string table = stetro_config::reference_table<LocalizerParams>();
  EXPECT_NE(table.find("heading.systematic.gain_sigma"), std::string::npos);
  EXPECT_NE(table.find("[rad]"), std::string::npos);
}

}  // namespace
}  // namespace stetro_localizer
