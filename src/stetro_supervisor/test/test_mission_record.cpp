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

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "stetro_supervisor/mission_record.hpp"

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

/// A path of this test's own, and what stands there.
class MissionFile : public testing::Test
{
protected:
  MissionFile() { std::remove(path_.c_str()); }
  ~MissionFile() override { std::remove(path_.c_str()); }

  void write(const std::string & text) const { std::ofstream(path_, std::ios::binary) << text; }
  [[nodiscard]] std::string content() const
  {
    std::ostringstream text;
    text << std::ifstream(path_, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::string path_ = testing::TempDir() + "mission_" + std::to_string(::getpid());
};

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

// As it stood on robots before the file became a KeptFile.
TEST_F(MissionFile, ReadsWhatEarlierReleasesWrote)
{
  const std::string text =
    "stetro_mission 1\nactive 1\nsegment \"flight one\"\nrequest \"a \\\"quoted\\\" id\"\n"
    "issuer \"dashboard\"\nstate sweep_right\nstep 7\nleg second\n"
    "rolled_m 0.12345678901230001\ntreads 2\nswept 1 0.115 1.9350000000000001\nswept 0 0 0\n"
    "crc32 e7e33afe\n";
  write(text);
  EXPECT_EQ(encode(load_mission(path_).value()), encode(example()));
  save(example(), path_);
  EXPECT_EQ(content(), text) << "and they can read what we write";
}

TEST_F(MissionFile, IsSavedAndLoaded)
{
  EXPECT_FALSE(load_mission(path_).has_value());
  save(example(), path_);
  EXPECT_EQ(encode(load_mission(path_).value()), encode(example()));
}

TEST_F(MissionFile, IsRefusedWhicheverByteIsHit)
{
  save(example(), path_);
  const std::string good = content();
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x04);
    write(bad);
    EXPECT_THROW(load_mission(path_), MissionFileError) << "byte " << i;
    write(good.substr(0, i));
    EXPECT_THROW(load_mission(path_), MissionFileError) << "cut at " << i;
  }
  write(good + "x");
  EXPECT_THROW(load_mission(path_), MissionFileError);
}

TEST(MissionRecord, NamesTheLineItDoesNotUnderstand)
{
  std::string text = encode(example());
  text.replace(text.find("step 7"), 6, "stop 7");
  try {
    decode(text);
    FAIL() << "no exception";
  } catch (const MissionFileError & error) {
    EXPECT_NE(std::string(error.what()).find("'step' expected, 'stop' found"), std::string::npos)
      << error.what();
  }
  EXPECT_THROW(decode(""), MissionFileError);
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

TEST(MissionRecord, KeepsTheGoalOfAJourneyAndWritesNoneWithoutOne)
{
  MissionRecord record;
  record.active = true;
  record.segment_id = "ground";
  EXPECT_EQ(encode(record).find("goal"), std::string::npos) << "as before there were journeys";
  EXPECT_TRUE(decode(encode(record)).goal.empty());
  record.goal = "first floor";
  EXPECT_EQ(decode(encode(record)).goal, "first floor");
}

}  // namespace stetro_supervisor
