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

#include <stdexcept>

#include "stetro_driver/pacer.hpp"

namespace stetro_driver
{
namespace
{

using std::chrono::milliseconds;

constexpr Time kTick = milliseconds{10};
constexpr Time kOrigin = std::chrono::seconds{1000};

Time sim(int ms) { return kOrigin + milliseconds{ms}; }

Pacer at_speed(double speed)
{
  PacerLimits limits;
  limits.speed = speed;
  return Pacer{limits, kTick};
}

TEST(Pacer, KeepsTheSpeed)
{
  Pacer pacer = at_speed(4.0);
  EXPECT_EQ(pacer.wait(sim(0), milliseconds{100}), Time::zero());
  for (int tick = 0; tick < 6; ++tick) {
    pacer.ticked(milliseconds{100});
  }
  EXPECT_EQ(pacer.wait(sim(60), milliseconds{101}), std::chrono::microseconds{1500});
}

TEST(Pacer, WaitsForNobodyItNeverHeard)
{
  Pacer pacer = at_speed(20.0);
  pacer.ticked(milliseconds{1});
  EXPECT_EQ(pacer.wait(sim(100000), milliseconds{2}), Time::zero());
  EXPECT_EQ(pacer.waits(), 0u);
}

TEST(Pacer, WaitsForAPeerThatFallsBehind)
{
  Pacer pacer = at_speed(20.0);
  pacer.hear(Peer::kLocalizer, sim(0), sim(0));
  EXPECT_EQ(pacer.wait(sim(80), milliseconds{10}), Time::zero());
  EXPECT_EQ(pacer.wait(sim(90), milliseconds{10}), milliseconds{200});
  EXPECT_EQ(pacer.wait(sim(90), milliseconds{60}), milliseconds{150});
  pacer.hear(Peer::kLocalizer, sim(60), sim(90));
  EXPECT_EQ(pacer.wait(sim(90), milliseconds{60}), Time::zero());
  EXPECT_EQ(pacer.waits(), 1u);
}

TEST(Pacer, GivesUpAndGoesOnAtRealTime)
{
  Pacer pacer = at_speed(20.0);
  pacer.hear(Peer::kSupervisor, sim(0), sim(0));
  EXPECT_GT(pacer.wait(sim(90), milliseconds{10}), Time::zero());
  EXPECT_EQ(pacer.wait(sim(90), milliseconds{210}), Time::zero());
  EXPECT_TRUE(pacer.lost(Peer::kSupervisor));
  EXPECT_EQ(pacer.losses(), 1u);
  pacer.ticked(milliseconds{210});
  EXPECT_EQ(pacer.wait(sim(100), milliseconds{210}), milliseconds{10}) << "10 ms for 10 ms";
  pacer.hear(Peer::kSupervisor, sim(100), sim(100));
  EXPECT_FALSE(pacer.lost(Peer::kSupervisor));
  EXPECT_EQ(pacer.wait(sim(100), milliseconds{211}), Time::zero());
}

TEST(Pacer, AStampOfTheFutureIsNoProgress)
{
  Pacer pacer = at_speed(20.0);
  pacer.hear(Peer::kLocalizer, sim(0), sim(0));
  pacer.hear(Peer::kLocalizer, sim(5000), sim(10));
  EXPECT_GT(pacer.wait(sim(100), milliseconds{10}), Time::zero());
}

TEST(Pacer, CatchesUpAFewTicksButNotWhatAWaitCost)
{
  Pacer pacer = at_speed(1.0);
  pacer.ticked(milliseconds{0});
  for (int tick = 0; tick < 5; ++tick) {
    EXPECT_EQ(pacer.wait(sim(10), milliseconds{500}), Time::zero()) << tick;
    pacer.ticked(milliseconds{500});
  }
  EXPECT_EQ(pacer.wait(sim(60), milliseconds{500}), milliseconds{0});
  pacer.ticked(milliseconds{500});
  EXPECT_EQ(pacer.wait(sim(70), milliseconds{500}), milliseconds{10});
}

TEST(Pacer, CanBeToldNotToWait)
{
  PacerLimits limits;
  limits.throttle = false;
  Pacer pacer{limits, kTick};
  pacer.hear(Peer::kLocalizer, sim(0), sim(0));
  EXPECT_EQ(pacer.wait(sim(900), milliseconds{10}), Time::zero());
}

TEST(Pacer, RefusesASpeedThatIsNone) { EXPECT_THROW(at_speed(0.0), std::invalid_argument); }

}  // namespace
}  // namespace stetro_driver
