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

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "stetro_localizer/state_file.hpp"

namespace stetro_localizer
{
namespace
{

/// A folder of this test's own, removed at its end.
class Folder
{
public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "state_file_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string & name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

StoredState mid_climb()
{
  StoredState state;
  state.segment_id = "east";
  state.step = StepState{7, {{0.14, 0.18, 0.0}, {true, false, true}}, 0.001, 0.1400000001};
  state.calibration.left = {{0.0123456789012345, 1.0 / 3.0}, 0.065};
  state.calibration.right.offset = {-0.02, 2e-6};
  state.calibration.front_difference = {{1e-300, 0.1}, 0.2};
  state.calibration.gyro_bias = {0.005, 1e-9};
  state.reset_counter = 4;
  return state;
}

std::string read(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write(const std::string & path, const std::string & text)
{
  std::ofstream(path, std::ios::binary) << text;
}

TEST(StateFile, GivesBackExactlyWhatWasWritten)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  ASSERT_FALSE(file.write(mid_climb()));
  const StateReading reading = file.read();
  ASSERT_EQ(reading.kind, StateReading::Kind::kFound) << reading.why;
  EXPECT_EQ(to_text(reading.state), to_text(mid_climb()));
  ASSERT_TRUE(reading.state.step);
  EXPECT_EQ(reading.state.step->step, 7);
  EXPECT_EQ(reading.state.step->pattern.bearing, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(reading.state.calibration.left.offset.variance, 1.0 / 3.0);
  EXPECT_EQ(reading.state.reset_counter, 4u);
}

TEST(StateFile, KeepsAnUnknownStepUnknown)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  StoredState state = mid_climb();
  state.step.reset();
  ASSERT_FALSE(file.write(state));
  EXPECT_FALSE(file.read().state.step);
}

TEST(StateFile, IsMissingWhereThereIsNone)
{
  const Folder folder;
  EXPECT_EQ(StateFile(folder.file("state")).read().kind, StateReading::Kind::kMissing);
  EXPECT_EQ(StateFile("").read().kind, StateReading::Kind::kMissing);
  EXPECT_FALSE(StateFile("").write(mid_climb())) << "an empty path keeps nothing";
}

TEST(StateFile, ReplacesTheOldFileWhole)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  ASSERT_FALSE(file.write(mid_climb()));
  StoredState later = mid_climb();
  later.step->step = 8;
  ASSERT_FALSE(file.write(later));
  EXPECT_EQ(file.read().state.step->step, 8);
  EXPECT_FALSE(std::filesystem::exists(folder.file("state.new")));
}

TEST(StateFile, SaysWhatKeepsItFromWriting)
{
  const Folder folder;
  const auto why = StateFile(folder.file("no/such/folder")).write(mid_climb());
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("no/such/folder"), std::string::npos) << *why;
}

// Property: no byte can be lost or changed without the file being known as damaged.
TEST(StateFile, KnowsEveryCutAndEveryFlippedByte)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  ASSERT_FALSE(file.write(mid_climb()));
  const std::string whole = read(file.path());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    write(file.path(), whole.substr(0, i));
    ASSERT_EQ(file.read().kind, StateReading::Kind::kDamaged) << "cut after " << i << " bytes";
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x04);
    write(file.path(), flipped);
    ASSERT_EQ(file.read().kind, StateReading::Kind::kDamaged) << "byte " << i << " flipped";
  }
  write(file.path(), whole);
  EXPECT_EQ(file.read().kind, StateReading::Kind::kFound);
}

// As it stood on robots before the file became a KeptFile.
TEST(StateFile, ReadsWhatEarlierReleasesWrote)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  const std::string text =
    "stetro_localizer_state 1\nflight_id east\nreset_counter 4\nstep.index 7\nstep.bearing 101\n"
    "side_left.value 0.0123456789012345\nside_left.variance 0.3333333333333333\n"
    "side_left.calibrated_at_m 0.065\nside_right.value -0.02\nside_right.variance 2e-06\n"
    "side_right.calibrated_at_m 0\nfront_difference.value 1e-300\n"
    "front_difference.variance 0.1\nfront_difference.calibrated_at_m 0.2\n"
    "gyro_bias.value 0.005\ngyro_bias.variance 1e-09\nstep.lift_off_offset_m 0.001\n"
    "step.lift_off_reference_m 0.1400000001\nstep.height_m.1 0.14\nstep.height_m.2 0.18\n"
    "step.height_m.3 0\nchecksum 9298427001710443462\n";
  write(file.path(), text);
  const StateReading reading = file.read();
  ASSERT_EQ(reading.kind, StateReading::Kind::kFound) << reading.why;
  EXPECT_EQ(to_text(reading.state), to_text(mid_climb()));
  ASSERT_FALSE(file.write(mid_climb()));
  EXPECT_EQ(read(file.path()), text) << "and they can read what we write";
}

TEST(StateFile, NamesTheDamage)
{
  const Folder folder;
  const StateFile file(folder.file("state"));
  write(file.path(), "something else\n");
  EXPECT_NE(file.read().why.find("does not begin with"), std::string::npos) << file.read().why;
  std::filesystem::remove(file.path());
  std::filesystem::create_directory(file.path());
  EXPECT_EQ(file.read().kind, StateReading::Kind::kDamaged);
}

}  // namespace
}  // namespace stetro_localizer
