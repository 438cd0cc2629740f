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

#include "stetro_localizer/stamp_guard.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr Nanoseconds kNow = std::chrono::seconds(1000);

TEST(StampGuard, AcceptsStampsInOrder)
{
  StampGuard guard;
  EXPECT_EQ(guard.accept(kNow, kNow), Refusal::kNone);
  EXPECT_EQ(guard.accept(kNow + milliseconds(10), kNow), Refusal::kNone) << "within 20 ms";
  EXPECT_EQ(guard.last(), kNow + milliseconds(10));
}

TEST(StampGuard, NamesTheReasonAndKeepsTheLastStamp)
{
  StampGuard guard;
  ASSERT_EQ(guard.accept(kNow, kNow), Refusal::kNone);
  EXPECT_EQ(guard.accept(Nanoseconds{0}, kNow), Refusal::kZeroStamp);
  EXPECT_EQ(guard.accept(Nanoseconds{-5}, kNow), Refusal::kZeroStamp);
  EXPECT_EQ(guard.accept(kNow + milliseconds(21), kNow), Refusal::kFuture);
  EXPECT_EQ(guard.accept(kNow, kNow), Refusal::kOutOfOrder) << "the same stamp again";
  EXPECT_EQ(guard.accept(kNow - milliseconds(1), kNow), Refusal::kOutOfOrder);
  EXPECT_EQ(guard.accept(kNow + milliseconds(100), kNow + milliseconds(500)), Refusal::kTooOld);
  EXPECT_EQ(guard.last(), kNow);
}

// A single stamp far in the future must not lock out what follows.
TEST(StampGuard, IsNotDeafAfterAStampFromTheFuture)
{
  StampGuard guard;
  EXPECT_EQ(guard.accept(kNow + std::chrono::hours(1), kNow), Refusal::kFuture);
  EXPECT_EQ(guard.accept(kNow, kNow), Refusal::kNone);
}

}  // namespace
}  // namespace stetro_localizer
