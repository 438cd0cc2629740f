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

#include <string>

#include "../../src/node/request_guard.hpp"

namespace stetro_supervisor
{
namespace
{

using std::chrono::seconds;
using stetro_dds::Guid;
using stetro_dds::Time;
using stetro_dds::TimeSource;

constexpr Time kNow{seconds(1'700'000'000)};
const RequestGuard::Now kWall{kNow, TimeSource::kSystem};
const RequestGuard::Now kSimulated{seconds(1000), TimeSource::kClockTopic};
const Guid kWriter{1};
const Guid kOther{2};

std::string reason(const std::optional<Refusal> & refusal)
{
  return refusal ? refusal->reason : "";
}

}  // namespace

TEST(RequestGuard, RefusesZeroOldAndFutureStampsOnTheComputersClock)
{
  RequestGuard guard{seconds(5)};
  EXPECT_EQ(reason(guard.judge(Time{0}, kWall, "rviz", kWriter)), "zero_stamp");
  EXPECT_EQ(reason(guard.judge(kNow + seconds(6), kWall, "rviz", kWriter)), "future_stamp");
  EXPECT_EQ(reason(guard.judge(kNow - seconds(6), kWall, "rviz", kWriter)), "too_old");
  EXPECT_EQ(reason(guard.judge(kNow - seconds(4), kWall, "rviz", kWriter)), "");
}

TEST(RequestGuard, ServesAnOperatorOnWallTimeWhileTheRobotsIsSimulated)
{
  RequestGuard guard{seconds(5)};
  EXPECT_EQ(reason(guard.judge(kNow, kSimulated, "rviz", kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow, kSimulated, "rviz", kWriter)), "") << "in the same second";
  EXPECT_EQ(reason(guard.judge(kNow - Time{1}, kSimulated, "rviz", kWriter)), "out_of_order");
  EXPECT_EQ(reason(guard.judge(Time{-1}, kSimulated, "rviz", kWriter)), "zero_stamp");
}

TEST(RequestGuard, EveryIssuerAndWriterHasAnOrderOfItsOwn)
{
  RequestGuard guard{seconds(5)};
  EXPECT_EQ(reason(guard.judge(kNow, kWall, "rviz", kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow - seconds(1), kWall, "fleet", kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow - seconds(1), kWall, "rviz", kOther)), "") << "restarted";
  EXPECT_EQ(reason(guard.judge(kNow - seconds(1), kWall, "rviz", kWriter)), "out_of_order");
}

}  // namespace stetro_supervisor
