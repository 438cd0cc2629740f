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
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "sim/snapshot_file.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr std::size_t kSize = 4000;

std::vector<std::uint8_t> full_of(std::uint8_t value)
{
  return std::vector<std::uint8_t>(kSize, value);
}

class SnapshotFileTest : public ::testing::Test
{
protected:
  SnapshotFileTest() : path_(::testing::TempDir() + "snapshot_file") { remove(); }
  ~SnapshotFileTest() override { remove(); }

  void remove() const
  {
    std::filesystem::remove(path_);
    std::filesystem::remove(path_ + ".refused");
  }
  std::unique_ptr<SnapshotFile> open(std::uint64_t world = 1) const
  {
    return std::make_unique<SnapshotFile>(path_, world, kSize);
  }
  /// Turns over one byte of the file.
  void damage(std::streamoff at) const
  {
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 0x5a);
    file.seekp(at);
    file.put(byte);
  }

  std::string path_;
};

TEST_F(SnapshotFileTest, IsEmptyAtFirst)
{
  EXPECT_EQ(open()->found().outcome, ResumeOutcome::kFresh);
  EXPECT_EQ(open()->found().outcome, ResumeOutcome::kFresh) << "opened, nothing stored";
}

TEST_F(SnapshotFileTest, GivesBackTheLastStore)
{
  for (std::uint8_t i = 1; i < 8; ++i) {
    open()->store(full_of(i));
    const auto file = open();
    ASSERT_EQ(file->found().outcome, ResumeOutcome::kResumed);
    EXPECT_EQ(file->found().bytes, full_of(i));
  }
}

TEST_F(SnapshotFileTest, FallsBackToTheOtherSlot)
{
  {
    const auto file = open();
    file->store(full_of(1));  // slot 1
    file->store(full_of(2));  // slot 0
  }
  damage(100);  // in slot 0: as if killed half-way through the second store
  const auto file = open();
  ASSERT_EQ(file->found().outcome, ResumeOutcome::kResumed);
  EXPECT_EQ(file->found().bytes, full_of(1));
  file->store(full_of(3));
  EXPECT_EQ(file->found().number, 1u);
}

TEST_F(SnapshotFileTest, NeverOverwritesTheOnlyGoodSlot)
{
  {
    const auto file = open();
    file->store(full_of(1));
    file->store(full_of(2));
  }
  damage(100);
  open()->store(full_of(3));  // must have gone to slot 0, over the damaged one
  damage(100);
  const auto file = open();
  ASSERT_EQ(file->found().outcome, ResumeOutcome::kResumed);
  EXPECT_EQ(file->found().bytes, full_of(1));
}

TEST_F(SnapshotFileTest, RefusesADamagedFileAndKeepsIt)
{
  {
    const auto file = open();
    file->store(full_of(1));
    file->store(full_of(2));
  }
  damage(100);
  damage(static_cast<std::streamoff>(std::filesystem::file_size(path_)) - 200);
  EXPECT_EQ(open()->found().outcome, ResumeOutcome::kDamaged);
  EXPECT_TRUE(std::filesystem::exists(path_ + ".refused"));
  EXPECT_EQ(open()->found().outcome, ResumeOutcome::kFresh);
}

TEST_F(SnapshotFileTest, RefusesAnotherWorld)
{
  {
    const auto file = open(1);
    file->store(full_of(1));
    file->store(full_of(2));
  }
  EXPECT_EQ(open(2)->found().outcome, ResumeOutcome::kForeign);
}

TEST_F(SnapshotFileTest, BelongsToOneProcessAtATime)
{
  const auto mine = open();
  EXPECT_THROW(open(), HardwareError);
}

TEST_F(SnapshotFileTest, OfALiveProcessStaysWhereItIs)
{
  const auto mine = open(1);
  mine->store(full_of(1));
  mine->store(full_of(2));
  EXPECT_THROW(open(2), HardwareError) << "another world's driver, by mistake on the same file";
  EXPECT_FALSE(std::filesystem::exists(path_ + ".refused"));
  EXPECT_THROW(open(1), HardwareError) << "still locked";
  mine->store(full_of(3));
  EXPECT_TRUE(std::filesystem::exists(path_));
}

TEST_F(SnapshotFileTest, SetAsideByItsReaderLeavesANewOneLocked)
{
  {
    const auto file = open();
    file->store(full_of(1));
  }
  const auto file = open();
  ASSERT_EQ(file->found().outcome, ResumeOutcome::kResumed);
  file->refuse_found("it has no end");
  EXPECT_EQ(file->found().outcome, ResumeOutcome::kDamaged);
  EXPECT_TRUE(std::filesystem::exists(path_ + ".refused"));
  EXPECT_THROW(open(), HardwareError);
  file->store(full_of(9));
}

// Whenever the writer is killed, what it stored last or the store before is there, and whole.
TEST_F(SnapshotFileTest, SurvivesKillAtAnyMoment)
{
  std::uint64_t least = 0;
  for (int round = 0; round < 20; ++round) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      SnapshotFile file{path_, 1, kSize};
      for (std::uint64_t i = least + 1;; ++i) {
        std::vector<std::uint8_t> bytes = full_of(static_cast<std::uint8_t>(i));
        std::memcpy(bytes.data(), &i, sizeof i);
        file.store(bytes);
        if (i == least + 100 && ::write(ready[1], "x", 1) != 1) {
          ::_exit(1);
        }
      }
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::usleep(static_cast<useconds_t>(100 * round));  // somewhere inside a store
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    const auto file = open();
    ASSERT_EQ(file->found().outcome, ResumeOutcome::kResumed) << "round " << round;
    std::uint64_t number = 0;
    std::memcpy(&number, file->found().bytes.data(), sizeof number);
    ASSERT_GE(number, least + 100);
    ASSERT_TRUE(std::all_of(
      file->found().bytes.begin() + sizeof number, file->found().bytes.end(),
      [&](std::uint8_t b) { return b == static_cast<std::uint8_t>(number); }));
    least = number;
  }
}

}  // namespace
}  // namespace stetro_driver::sim
