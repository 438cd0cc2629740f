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
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "stetro_supervisor/mission_record.hpp"

namespace
{

int folders_flushed = 0;

}  // namespace

/// In place of the system's: notes what is flushed.
extern "C" int fsync(int file)
{
  struct stat found = {};
  folders_flushed += ::fstat(file, &found) == 0 && S_ISDIR(found.st_mode) ? 1 : 0;
  return ::fdatasync(file);
}

namespace stetro_supervisor
{
namespace
{

MissionRecord example()
{
  MissionRecord record;
  record.active = true;
  record.segment_id = "flight one";
  record.request_id = "a \"quoted\" id";
  record.issuer = "dashboard";
  record.state = State::kSweepRight;
  record.step = 7;
  record.leg = Leg::kSecond;
  record.rolled_m = 0.1234567890123;
  record.swept = {{0.115, 1.935, true}, {0.0, 0.0, false}};
  return record;
}

}  // namespace

TEST(MissionRecord, ReadsBackWhatWasWritten)
{
  const MissionRecord record = decode(encode(example()));
  EXPECT_EQ(encode(record), encode(example()));
  EXPECT_EQ(record.request_id, "a \"quoted\" id");
  EXPECT_EQ(record.state, State::kSweepRight);
  EXPECT_EQ(record.step, 7);
  EXPECT_EQ(record.rolled_m, 0.1234567890123);
  ASSERT_EQ(record.swept.size(), 2u);
  EXPECT_EQ(record.swept[0].y_max_m, 1.935);
}

TEST(MissionRecord, RefusesADamagedFileWhicheverByteIsHit)
{
  const std::string good = encode(example());
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x04);
    EXPECT_THROW(decode(bad), MissionFileError) << "byte " << i;
    EXPECT_THROW(decode(good.substr(0, i)), MissionFileError) << "cut at " << i;
  }
}

TEST(MissionRecord, IsSavedAndLoaded)
{
  const std::string path = testing::TempDir() + "mission_" + std::to_string(::getpid());
  std::remove(path.c_str());
  EXPECT_FALSE(load_mission(path).has_value());
  save(example(), path);
  EXPECT_EQ(encode(load_mission(path).value()), encode(example()));
  std::ofstream{path, std::ios::app} << "x";
  EXPECT_THROW(load_mission(path), MissionFileError);
  std::remove(path.c_str());
}

TEST(MissionRecord, SaysWhichPathCannotBeWritten)
{
  try {
    save(example(), "/nonexistent/mission");
    FAIL() << "no exception";
  } catch (const MissionFileError & error) {
    EXPECT_NE(std::string(error.what()).find("/nonexistent/mission"), std::string::npos);
  }
}

TEST(Swept, ShareIsTheWidthPassedOverByTheBumpers)
{
  Swept swept;
  EXPECT_EQ(swept.share(2.05, 0.23), 0.0);
  swept.pass(1.025);
  EXPECT_NEAR(swept.share(2.05, 0.23), 0.23 / 2.05, 1e-12);
  swept.pass(0.115);
  swept.pass(1.935);
  EXPECT_NEAR(swept.share(2.05, 0.23), 1.0, 1e-12);
}

TEST(MissionRecord, SavingFlushesTheFolderToo)
{
  const std::string path = testing::TempDir() + "mission_" + std::to_string(::getpid());
  const int before = folders_flushed;
  save(example(), path);
  EXPECT_EQ(folders_flushed, before + 1) << "or a power cut takes the new name back";
  std::remove(path.c_str());
}

}  // namespace stetro_supervisor
