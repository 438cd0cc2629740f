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

#include "./written_file.hpp"
#include "stetro_config/report.hpp"
#include "stetro_site/robot.hpp"

namespace stetro_site
{
namespace
{

std::string faults_of(const std::string & text)
{
  const WrittenFile file{text};
  stetro_config::Faults faults;
  EXPECT_FALSE(read_robot(file.path(), faults));
  std::string lines;
  for (const auto & fault : faults) {
    lines += std::to_string(fault.line) + " " + fault.name + ": " + fault.value + "\n";
  }
  return lines;
}

TEST(Robot, ThatIsShippedIsTheDefaultOne)
{
  const Robot robot = load_robot(CONFIG_FOLDER "robot/stetro.yaml");
  EXPECT_EQ(stetro_config::to_yaml(robot), stetro_config::to_yaml(Robot{}));
}

TEST(Robot, KeepsItsDevicesAsWritten)
{
  const std::string text = shipped("robot/stetro.yaml");
  const std::string body = text.substr(0, text.find("\ndevices:"));
  const WrittenFile without{body};
  EXPECT_TRUE(load_robot(without.path()).devices.IsNull());
  const WrittenFile file{body + "\ndevices:\n  side_left: {bus: 1, address: 0x29}\n"};
  const Robot robot = load_robot(file.path());
  EXPECT_EQ(robot.devices["side_left"]["address"].Scalar(), "0x29");
  EXPECT_EQ(robot.file, file.path());
}

TEST(Robot, MustBeDescribedInFull)
{
  const std::string good = shipped("robot/stetro.yaml");
  EXPECT_EQ(faults_of(with(good, "  stroke_m: 0.18\n", "")), "0 lift.stroke_m: (missing)\n");
}

TEST(Robot, ReportsEveryFaultAtOnce)
{
  std::string text = with(shipped("robot/stetro.yaml"), "stroke_m: 0.18", "strok_m: 0.18");
  text = with(text, "height_m: 0.40", "height_m: tall");
  EXPECT_EQ(
    faults_of(text), "26 body.height_m: tall\n30 lift.strok_m: 0.18\n0 lift.stroke_m: (missing)\n");
}

TEST(Robot, PlacesItsContradictions)
{
  const std::string text =
    with(shipped("robot/stetro.yaml"), "contact_width_m: 0.23", "contact_width_m: 0.18");
  EXPECT_EQ(faults_of(text), "27 body.contact_width_m: 0.18\n");
}

TEST(Robot, IsNotReadFromAFileThatIsNotThere)
{
  EXPECT_THROW(static_cast<void>(load_robot("no/such.yaml")), stetro_config::ConfigError);
}

}  // namespace
}  // namespace stetro_site
