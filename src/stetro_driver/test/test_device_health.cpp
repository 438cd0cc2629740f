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

#include "linux/device_health.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

IoFault silent() { return {IoFaultKind::kSilent, "imu: no answer"}; }

TEST(DeviceHealth, IsFaultyFromTheFirstFailureInARowUntilAnAnswer)
{
  DeviceHealth health{"imu"};
  EXPECT_FALSE(health.faulty());
  health.failed(milliseconds{10}, silent());
  health.failed(milliseconds{20}, {IoFaultKind::kBadAnswer, "imu: checksum"});
  EXPECT_EQ(health.faulty_since(), Time{milliseconds{10}});
  EXPECT_EQ(health.failures_in_a_row(), 2u);
  ASSERT_TRUE(health.last_fault());
  EXPECT_EQ(health.last_fault()->detail, "imu: checksum");

  health.answered();
  EXPECT_FALSE(health.faulty());
  EXPECT_EQ(health.failures_in_a_row(), 0u);
  EXPECT_TRUE(health.last_fault()) << "what it was is remembered";
  EXPECT_EQ(health.counts().good, 1u);
  EXPECT_EQ(health.counts().timeouts, 1u);
  EXPECT_EQ(health.counts().bad_answers, 1u);
}

TEST(DeviceHealth, WaitsTwiceAsLongAfterEachFailureUpToTheLongest)
{
  DeviceHealth health{"imu"};
  Time now{0};
  for (const int wait_ms : {100, 200, 400, 800, 1600, 2000, 2000}) {
    health.failed(now, silent());
    health.closed(now);
    EXPECT_EQ(health.open_at(), now + milliseconds{wait_ms});
    EXPECT_FALSE(health.may_open(now + milliseconds{wait_ms} - Time{1})) << wait_ms;
    EXPECT_TRUE(health.may_open(now + milliseconds{wait_ms})) << wait_ms;
    now = *health.open_at();
  }
}

TEST(DeviceHealth, OpeningAloneNeitherEndsTheFaultNorShortensTheBackOff)
{
  DeviceHealth health{"imu", {milliseconds{10}, milliseconds{40}}};
  health.failed(Time{0}, silent());
  health.closed(Time{0});
  health.opened();
  EXPECT_TRUE(health.faulty());
  EXPECT_FALSE(health.is_closed());
  EXPECT_FALSE(health.may_open(milliseconds{100})) << "it is open";
  health.closed(Time{0});
  EXPECT_EQ(health.open_at(), Time{milliseconds{20}}) << "it never answered";

  health.opened();
  health.answered();
  health.closed(Time{0});
  EXPECT_EQ(health.open_at(), Time{milliseconds{10}}) << "it answered";
  EXPECT_EQ(health.counts().reopens, 2u);
}

TEST(DeviceHealth, TheFirstOpeningIsNoReopening)
{
  DeviceHealth health{"imu"};
  health.opened();
  EXPECT_EQ(health.counts().reopens, 0u);
}

}  // namespace
}  // namespace stetro_driver::linux_io
