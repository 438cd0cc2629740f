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

// On a machine whose kernel simulates GPIO chips (gpio-sim), libgpiod is tried against one; that
// takes root. Everywhere else what can be tried without a chip is.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "device_bench.hpp"
#include "linux/lines/gpiod_lines.hpp"

namespace stetro_driver::linux_io
{
namespace
{

namespace fs = std::filesystem;

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(GpiodLines, NamesAChipThatIsNotThere)
{
  const OpenResources before;
  GpiodLines lines;
  for (int time = 0; time < 2; ++time) {
    const auto fault = lines.open({{"no_such_chip", 3}});
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, IoFaultKind::kSilent);
    EXPECT_EQ(fault->detail.find("chip no_such_chip cannot be opened"), 0u) << fault->detail;
  }
  EXPECT_TRUE(OpenResources{} == before);
}

TEST(GpiodLines, WithoutLinesAWaitIsAWait)
{
  GpiodLines lines;
  std::vector<LineEdge> edges{{}};
  EXPECT_FALSE(lines.wait(milliseconds{1}, edges));
  EXPECT_TRUE(edges.empty());
  EXPECT_TRUE(lines.levels().ok());
}

/// A chip of 8 lines that the kernel simulates.
class SimulatedChip
{
public:
  static bool possible()
  {
    return geteuid() == 0 && fs::is_directory("/sys/kernel/config/gpio-sim");
  }

  SimulatedChip()
  {
    fs::create_directories(bank_);
    write(bank_ / "num_lines", "8");
    write(device_ / "live", "1");
    chip_ = read(bank_ / "chip_name");
    pulls_ = fs::path{"/sys/devices/platform"} / read(device_ / "dev_name") / chip_;
  }
  ~SimulatedChip()
  {
    std::error_code ignored;
    write(device_ / "live", "0");
    fs::remove(bank_, ignored);
    fs::remove(device_, ignored);
  }
  SimulatedChip(const SimulatedChip &) = delete;
  SimulatedChip & operator=(const SimulatedChip &) = delete;

  void pull(int line, bool up)
  {
    write(pulls_ / ("sim_gpio" + std::to_string(line)) / "pull", up ? "pull-up" : "pull-down");
  }
  [[nodiscard]] const std::string & name() const { return chip_; }

private:
  static void write(const fs::path & path, const std::string & text)
  {
    std::ofstream file{path};
    file << text << "\n";
  }
  static std::string read(const fs::path & path)
  {
    std::string line;
    std::ifstream file{path};
    std::getline(file, line);
    return line;
  }

  fs::path device_ =
    fs::path{"/sys/kernel/config/gpio-sim"} / ("stetro_" + std::to_string(getpid()));
  fs::path bank_ = device_ / "bank0";
  fs::path pulls_;
  std::string chip_;
};

TEST(GpiodLines, SeesLevelsAndEdgesOfASimulatedChip)
{
  if (!SimulatedChip::possible()) {
    GTEST_SKIP() << "no gpio-sim here: it takes root, configfs and `modprobe gpio-sim`";
  }
  SimulatedChip chip;
  chip.pull(3, true);
  chip.pull(4, false);
  GpiodLines lines;
  const auto refused = lines.open({{chip.name(), 8}});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->kind, IoFaultKind::kBadAnswer);

  const auto fault =
    lines.open({{chip.name(), 3, true, LineBias::kNone}, {chip.name(), 4, false, LineBias::kNone}});
  ASSERT_FALSE(fault) << fault->detail;
  EXPECT_EQ(lines.levels().value().to_ulong(), 0u);
  GpiodLines second;
  EXPECT_TRUE(second.open({{chip.name(), 3}})) << "taken";

  chip.pull(3, false);
  std::vector<LineEdge> edges;
  ASSERT_FALSE(lines.wait(seconds{5}, edges));
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_EQ(edges[0].line, 0u);
  EXPECT_TRUE(edges[0].active) << "active-low, pulled down";
  EXPECT_EQ(lines.levels().value().to_ulong(), 0b01u);
}

}  // namespace
}  // namespace stetro_driver::linux_io
