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
#include "stetro_supervisor/supervisor_setup.hpp"

namespace stetro_supervisor
{

class SupervisorSetupTest : public testing::Test
{
protected:
  SupervisorSetupTest()
  {
    std::filesystem::create_directories(folder);
    params.site_file = (folder / "site.yaml").string();
    params.robot_file = (folder / "robot.yaml").string();
    std::ofstream{params.robot_file} << stetro_config::to_yaml(stetro_site::Robot{});
  }

  ~SupervisorSetupTest() override { std::filesystem::remove_all(folder); }

  void write_site(const std::string & riser_m, const std::string & width_m)
  {
    std::ofstream{params.site_file}
      << "name: toy\nfloors:\n  - {id: ground, elevation_m: 0.0}\n"
      << "  - {id: landing, elevation_m: " << 2 * std::stod(riser_m) << "}\n"
      << "flights:\n  - id: flight\n    joins: [ground, landing]\n    steps: 2\n"
      << "    riser_m: " << riser_m << "\n    tread_m: 0.32\n    width_m: " << width_m << "\n"
      << "    sides: {right: walled, left: walled}\n    wall_overrun_m: 1.0\n"
      << "    pose: {x_m: 0.0, y_m: 0.0, z_m: 0.0, yaw_rad: 0.0}\n";
  }

  std::string told() const
  {
    std::string all;
    for (const auto & fault : faults) {
      all += to_string(fault) + "\n";
    }
    return all;
  }

  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("setup_" + std::to_string(::getpid()));
  SupervisorParams params;
  stetro_config::Faults faults;
};

TEST_F(SupervisorSetupTest, ReadsFlightAndSpeeds)
{
  write_site("0.14", "2.05");
  const auto setup = read_setup(params, faults);
  ASSERT_TRUE(setup) << told();
  EXPECT_EQ(setup->flight.id(), "flight");
  EXPECT_EQ(setup->params.climb.sweep_speed_mps, setup->robot.speeds.sweep_m_s);
}

TEST_F(SupervisorSetupTest, CollectsWhatCannotBeClimbedAndTellsItOnce)
{
  write_site("0.14", "0.30");  // wider than the robot, too narrow to stand clear of both walls
  EXPECT_FALSE(read_setup(params, faults));
  EXPECT_NE(told().find("width_m"), std::string::npos) << told();
  const auto count = faults.size();
  EXPECT_FALSE(read_setup(params, faults));
  EXPECT_EQ(faults.size(), count) << told();
}

TEST_F(SupervisorSetupTest, ChecksThatTheRobotFitsTheSite)
{
  write_site("0.30", "2.05");  // higher than the stroke
  EXPECT_FALSE(read_setup(params, faults));
  EXPECT_NE(told().find("stroke"), std::string::npos) << told();
}

TEST_F(SupervisorSetupTest, NamesTheFlightsWhenThereIsNoSuchOne)
{
  write_site("0.14", "2.05");
  params.flight = "attic";
  EXPECT_FALSE(read_setup(params, faults));
  EXPECT_NE(told().find("accepted: the id of a flight of the site: flight"), std::string::npos)
    << told();
}

}  // namespace stetro_supervisor
