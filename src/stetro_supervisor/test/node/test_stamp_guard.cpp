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

#include "../../src/node/stamp_guard.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_dds::Guid;
using stetro_dds::Time;

constexpr Time kNow{std::chrono::seconds(1000)};
const Guid kWriter{1};
const Guid kOther{2};

std::string reason(const std::optional<Refusal> & refusal)
{
  return refusal ? refusal->reason : "";
}

}  // namespace

TEST(StampGuard, RefusesZeroFutureAndOutOfOrderStamps)
{
  StampGuard guard{std::chrono::milliseconds(20)};
  EXPECT_EQ(reason(guard.judge(Time{0}, kNow, kWriter)), "zero_stamp");
  EXPECT_EQ(reason(guard.judge(Time{-1}, kNow, kWriter)), "zero_stamp");
  EXPECT_EQ(reason(guard.judge(kNow + std::chrono::seconds(1), kNow, kWriter)), "future_stamp");
  EXPECT_EQ(reason(guard.judge(kNow, kNow, kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow - Time{1}, kNow, kWriter)), "out_of_order");
  EXPECT_EQ(reason(guard.judge(kNow, Time{0}, kWriter)), "clock_unknown");
}

TEST(StampGuard, ANewWriterStartsANewOrder)
{
  StampGuard guard{Time{0}};
  EXPECT_EQ(reason(guard.judge(kNow, kNow, kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow - Time{5}, kNow, kOther)), "") << "a driver that resumed";
}

TEST(StampGuard, RefusesWhatWaitedTooLongInAQueue)
{
  StampGuard guard{std::chrono::milliseconds(20), std::chrono::milliseconds(300)};
  EXPECT_EQ(reason(guard.judge(kNow - std::chrono::milliseconds(301), kNow, kWriter)), "too_old");
  EXPECT_EQ(reason(guard.judge(kNow - std::chrono::milliseconds(300), kNow, kWriter)), "");
  EXPECT_EQ(reason(guard.judge(kNow, kNow, kWriter)), "");
}

TEST(StampGuard, RestartsItsOrderWhenTold)
{
  StampGuard guard{Time{0}};
  EXPECT_EQ(reason(guard.judge(kNow, kNow, kWriter)), "");
  guard.restart();
  EXPECT_EQ(reason(guard.judge(kNow - Time{5}, kNow, kWriter)), "");
}

}  // namespace stetro_supervisor
