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

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "stetro_bringup/trace.hpp"

namespace stetro_bringup
{
namespace
{

std::string written(const TraceRow & row)
{
  std::ostringstream out;
  TraceWriter writer{out};
  writer.write(row);
  return out.str();
}

std::ptrdiff_t commas(const std::string & line)
{
  return std::count(line.begin(), line.end(), ',');
}

}  // namespace

TEST(TraceWriter, GivesEveryRowTheColumnsOfTheHeader)
{
  TraceRow bare;
  TraceRow full;
  full.truth = StairSample{};
  full.sensors["side_left"] = {0.75, "fused"};
  for (const TraceRow & row : {bare, full}) {
    std::istringstream lines{written(row)};
    std::string header;
    std::string line;
    std::getline(lines, header);
    std::getline(lines, line);
    EXPECT_EQ(commas(header), commas(line)) << line;
  }
}

TEST(TraceWriter, PrintsStampsToTheNanosecondAndLengthsToTheMicrometre)
{
  TraceRow row;
  row.estimate.stamp = std::chrono::nanoseconds{1000000000123};
  row.estimate.step = 7;
  row.estimate.x_m = 2.0800005;
  const std::string text = written(row);
  EXPECT_NE(text.find("\n1000000000123,7,2.080001,"), std::string::npos) << text;
}

TEST(TraceWriter, LeavesWhatIsUnknownEmptyAndNamesInfinities)
{
  TraceRow row;
  row.sigma.x_m = std::numeric_limits<double>::quiet_NaN();
  row.integrity = "OK";
  row.sensors["front_left"] = {std::numeric_limits<double>::infinity(), "not_visible"};
  const std::string text = written(row);
  EXPECT_NE(text.find(",inf,not_visible"), std::string::npos) << text;
  EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

}  // namespace stetro_bringup
