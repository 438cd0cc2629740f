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
#include <sstream>

#include "stetro_bringup/climb_report.hpp"

namespace stetro_bringup
{
namespace
{

const ReportFacts kPapers{{{"stairs", 2.05}}, 0.23};

TraceRow sweeping(int step, double y_m, double true_y_m, double heading_rad = 0.0)
{
  TraceRow row;
  row.estimate.segment = "stairs";
  row.estimate.step = step;
  row.estimate.tread_y_m = y_m;
  row.estimate.heading_rad = heading_rad;
  row.truth = row.estimate;
  row.truth->tread_y_m = true_y_m;
  row.truth->heading_rad = 0.0;
  return row;
}

}  // namespace

// Table 3, step 1 of S-B: 205 - ((193.1 - 14.0) + 23.0) = 2.9 cm.
TEST(ClimbReport, ClosesAsTheFirstRowOfTableThree)
{
  ClimbReport report{kPapers};
  report.add_sweeping(sweeping(1, 1.00, 1.00));
  report.add_sweeping(sweeping(1, 1.931, 1.931));
  report.add_sweeping(sweeping(1, 0.140, 0.140));
  ASSERT_EQ(report.steps().size(), 1u);
  EXPECT_NEAR(report.steps()[0].closure_error_m, 0.029, 1e-12);
  EXPECT_NEAR(report.errors().closure_error_m.mean(), 0.029, 1e-12);
}

TEST(ClimbReport, MeasuresErrorsAgainstTheWorld)
{
  ClimbReport report{kPapers};
  report.add_sweeping(sweeping(1, 1.03, 1.00, 0.1));
  report.add_sweeping(sweeping(2, 1.00, 1.04, -0.1));
  const auto errors = report.errors();
  EXPECT_NEAR(errors.y_error_m.mean(), -0.005, 1e-12);                // (0.03 - 0.04) / 2
  EXPECT_NEAR(errors.y_error_m.rms(), std::sqrt(0.0025 / 2), 1e-12);  // 9e-4 + 16e-4
  EXPECT_NEAR(errors.heading_error_rad.max_abs(), 0.1, 1e-12);
  EXPECT_EQ(errors.wrong_step, 0u);
}

TEST(ClimbReport, WrapsTheHeading)
{
  ClimbReport report{kPapers};
  auto row = sweeping(1, 1.0, 1.0, M_PI - 0.01);
  row.truth->heading_rad = -M_PI + 0.01;
  report.add_sweeping(row);
  EXPECT_NEAR(report.errors().heading_error_rad.mean(), -0.02, 1e-9);
}

TEST(ClimbReport, CountsEstimatesOnTheWrongStep)
{
  ClimbReport report{kPapers};
  auto row = sweeping(3, 1.0, 1.0);
  row.truth->step = 0;
  row.truth->tread_x_m = std::nan("");  // the floor is no tread
  report.add_sweeping(row);
  EXPECT_EQ(report.errors().wrong_step, 1u);
  EXPECT_EQ(report.errors().y_error_m.count(), 0u);
}

TEST(ClimbReport, HasNoErrorsWithoutTruth)
{
  ClimbReport report{kPapers};
  auto row = sweeping(1, 1.0, 1.0);
  row.truth.reset();
  report.add_sweeping(row);
  EXPECT_EQ(report.errors().y_error_m.count(), 0u);
  EXPECT_EQ(report.steps()[0].estimates, 1u);
}

TEST(ClimbReport, KeepsTheFlightsApart)
{
  ClimbReport report{{{{"lower", 2.05}, {"upper", 1.60}}, 0.23}};
  auto row = sweeping(1, 1.0, 1.0);
  row.estimate.segment = row.truth->segment = "lower";
  report.add_sweeping(row);
  row.estimate.segment = "upper";
  report.add_sweeping(row);
  ASSERT_EQ(report.steps().size(), 2u);
  EXPECT_NEAR(report.steps()[0].closure_error_m, 2.05 - 0.23, 1e-12);
  EXPECT_NEAR(report.steps()[1].closure_error_m, 1.60 - 0.23, 1e-12);
  EXPECT_EQ(report.errors().wrong_step, 1u) << "the truth was on the lower flight";
  std::ostringstream table;
  print_table(table, report);
  EXPECT_NE(table.str().find("\nflight upper\n"), std::string::npos) << table.str();
}

TEST(ClimbReport, TakesNoErrorFromALostPose)
{
  ClimbReport report{kPapers};
  report.add_sweeping(sweeping(1, std::nan(""), 1.0));
  EXPECT_TRUE(report.steps().empty());
}

TEST(ClimbReport, WritesARowATread)
{
  ClimbReport report{kPapers};
  report.add_sweeping(sweeping(1, 1.0, 1.0));
  auto unseen = sweeping(2, 1.0, 1.0);
  unseen.truth.reset();
  report.add_sweeping(unseen);
  report.add_sweeping(sweeping(0, 1.0, 1.0));  // the floor is not a tread
  std::ostringstream csv;
  write_steps_csv(csv, report);
  std::istringstream lines{csv.str()};
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line.substr(0, 5), "step,");
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line.substr(0, 4), "1,1,");
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line.substr(0, 4), "2,1,");
  EXPECT_EQ(line.substr(line.rfind(',')), ",stairs");
  EXPECT_EQ(line.find("nan"), std::string::npos) << "what is not known stays empty: " << line;
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace stetro_bringup
