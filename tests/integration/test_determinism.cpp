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

// In one process on simulated time: the same seed gives the same bytes, and the truth is for
// looking at only.

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "stetro_tests/deadline.hpp"
#include "stetro_tests/demo_run.hpp"
#include "stetro_tests/stack.hpp"

namespace stetro_tests
{

/// The demo in one process on the short flight, with further arguments.
class InProcessRun
{
public:
  explicit InProcessRun(const std::vector<std::string> & extra) : demo_(arguments(extra)) {}

  /// What it wrote as trace.csv once it has ended; fails the test if it did not end well.
  std::string trace()
  {
    EXPECT_EQ(demo_.wait(120s), 0) << demo_.tail();
    std::string text = demo_.file("trace.csv");
    EXPECT_GT(text.size(), 10000U) << "a climb leaves a longer trace";
    return text;
  }

private:
  static std::vector<std::string> arguments(const std::vector<std::string> & extra)
  {
    std::vector<std::string> all = {"--in-process", "--no-plots",  "--seed", "7",
                                    "--site",       short_flight()};
    all.insert(all.end(), extra.begin(), extra.end());
    return all;
  }

  DemoRun demo_;
};

std::vector<std::string> cells_of(const std::string & line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

/// A trace without the columns that tell the truth.
std::string without_truth(const std::string & trace)
{
  std::istringstream lines(trace);
  std::string line;
  std::getline(lines, line);
  const auto names = cells_of(line);
  std::ostringstream result;
  do {
    const auto cells = cells_of(line);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (names.at(i).find("true") == std::string::npos) {
        result << cells[i] << ",";
      }
    }
    result << "\n";
  } while (std::getline(lines, line));
  return result.str();
}

TEST(Determinism, SameSeedSameBytes)
{
  InProcessRun first({});
  InProcessRun second({});
  EXPECT_TRUE(first.trace() == second.trace()) << "the traces differ";
}

TEST(Determinism, TruthIsForLookingOnly)
{
  InProcessRun seen({});
  InProcessRun unseen({"--no-ground-truth"});
  EXPECT_TRUE(without_truth(seen.trace()) == without_truth(unseen.trace())) << "the traces differ";
}

}  // namespace stetro_tests
