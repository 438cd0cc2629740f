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
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "stetro_config/report.hpp"
#include "stetro_localizer/localizer_setup.hpp"
#include "stetro_site/robot.hpp"

namespace stetro_localizer
{
namespace
{

namespace fs = std::filesystem;

constexpr char kSite[] = R"(name: papers
floors:
  - {id: ground, elevation_m: 0.0}
  - {id: landing, elevation_m: 2.24}
flights:
  - id: papers
    joins: [ground, landing]
    steps: 16
    riser_m: 0.14
    tread_m: 0.32
    width_m: 2.05
    sides: {right: walled, left: walled}
    wall_overrun_m: 1.0
    pose: {x_m: 10.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}
)";

class LocalizerSetupTest : public testing::Test
{
protected:
  LocalizerSetupTest()
  {
    fs::create_directories(folder_);
    params_.site_file = (folder_ / "site.yaml").string();
    params_.robot_file = (folder_ / "robot.yaml").string();
    std::ofstream{params_.site_file} << kSite;
    std::ofstream{params_.robot_file} << stetro_config::to_yaml(stetro_site::Robot{});
  }
  ~LocalizerSetupTest() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::temp_directory_path() / ("setup_" + std::to_string(::getpid()));
  LocalizerParams params_;
  stetro_config::Faults faults_;
};

TEST_F(LocalizerSetupTest, FindsTheOnlyFlight)
{
  const auto setup = read_setup(params_, faults_);
  ASSERT_TRUE(setup && faults_.empty());
  EXPECT_EQ(setup->flight.id(), "papers");
  EXPECT_EQ(setup->site.flights().size(), 1u);
}

TEST_F(LocalizerSetupTest, RefusesAnInitialStepThatTheFlightDoesNotHave)
{
  params_.initial_step = 17;
  EXPECT_FALSE(read_setup(params_, faults_));
  ASSERT_EQ(faults_.size(), 1u);
  EXPECT_EQ(faults_[0].name, "initial_step");
  EXPECT_EQ(faults_[0].value, "17");
  EXPECT_EQ(faults_[0].accepted, "-1 to 16, the steps of flight papers");
  for (const int step : {-1, 0, 16}) {
    params_.initial_step = step;
    EXPECT_TRUE(read_setup(params_, faults_)) << step;
  }
}

TEST_F(LocalizerSetupTest, RefusesAFlightThatTheSiteDoesNotHave)
{
  params_.flight = "spiral";
  EXPECT_FALSE(read_setup(params_, faults_));
  ASSERT_EQ(faults_.size(), 1u);
  EXPECT_EQ(faults_[0].accepted, "one of papers");
}

TEST_F(LocalizerSetupTest, ReportsTheFaultsOfAFileOnceForAllWhoReadIt)
{
  std::ofstream{params_.site_file, std::ios::app} << "    stepz: 16\n";
  EXPECT_FALSE(read_setup(params_, faults_));
  const auto count = faults_.size();
  EXPECT_GT(count, 0u);
  EXPECT_FALSE(read_setup(params_, faults_));
  EXPECT_EQ(faults_.size(), count);
}

TEST_F(LocalizerSetupTest, BeginsOnASegmentOfTheSiteWhoseFloorIsDrawn)
{
  const auto replace = [](std::string text, const std::string & from, const std::string & to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string drawn = replace(
    kSite, "- {id: ground, elevation_m: 0.0}",
    "- id: ground\n    elevation_m: 0.0\n    walls: {outline: [{x_m: 0, y_m: 0}, {x_m: 9, y_m: 0}, "
    "{x_m: 9, y_m: 9}]}");
  std::ofstream{params_.site_file} << drawn;
  for (const char * id : {"", "ground", "papers"}) {
    params_.initial_segment = id;
    const auto setup = read_setup(params_, faults_);
    ASSERT_TRUE(setup) << id;
    EXPECT_TRUE(setup->site.has_drawn_floor());
  }
  params_.initial_segment = "landing";
  EXPECT_FALSE(read_setup(params_, faults_)) << "nobody has drawn it";
  ASSERT_EQ(faults_.size(), 1u);
  EXPECT_EQ(faults_[0].name, "initial_segment");
  EXPECT_EQ(faults_[0].accepted, "empty, or one of papers ground");
}

}  // namespace
}  // namespace stetro_localizer
