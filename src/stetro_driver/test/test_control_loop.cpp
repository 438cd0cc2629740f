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

#include <atomic>
#include <chrono>
#include <stdexcept>

#include "control_loop.hpp"
#include "fake_robot.hpp"
#include "pilot.hpp"

namespace stetro_driver
{
namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;

using test::FakeRobot;

constexpr Time kPeriod = milliseconds{2};

Time steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

class ControlLoopTest : public ::testing::Test
{
protected:
  /// Waits for frames until something is so. \return whether it came true
  template <class Done>
  bool until(Done && done)
  {
    const Time end = steady_now() + seconds{10};
    while (!done()) {
      if (steady_now() > end) {
        return false;
      }
      loop_.wait(milliseconds{20});
    }
    return true;
  }

  void roll_for(Time valid_for, std::uint64_t number = 1)
  {
    loop_.command({true, test::Pilot::twist(0.1, 0.0, 0.0), steady_now() + valid_for, number});
  }

  FakeRobot robot_;
  ControlLoop loop_{robot_, steady_now, kPeriod};
};

TEST_F(ControlLoopTest, ReadsAtItsRateAndHandsFramesOverInOrder)
{
  const Time begin = steady_now();
  loop_.start();
  Time last{0};
  int frames = 0;
  int cycles_of_ranges = 0;
  ASSERT_TRUE(until([&] {
    SensorFrame frame;
    while (loop_.take(frame)) {
      EXPECT_GT(frame.time, last);
      last = frame.time;
      ++frames;
      cycles_of_ranges += frame.ranges_complete ? 1 : 0;
    }
    return frames >= 30;
  }));
  EXPECT_GE(steady_now() - begin, 28 * kPeriod) << "no faster than its period";
  EXPECT_GE(cycles_of_ranges, 9);
  EXPECT_EQ(robot_.writes, 0) << "nobody has powered the motors";
}

TEST_F(ControlLoopTest, WritesACommandAndHoldsWhenItsTimeIsOver)
{
  loop_.start();
  roll_for(milliseconds{100});
  ASSERT_TRUE(until([&] { return robot_.vx_m_s == 0.1; }));
  const int written = robot_.writes;
  ASSERT_TRUE(until([&] { return robot_.vx_m_s == 0.0; })) << "nobody renewed it";
  EXPECT_GT(robot_.writes, written) << "hold is written, too";
}

TEST_F(ControlLoopTest, SaysWhichCommandAFaultBelongsTo)
{
  robot_.fault = IoFault{IoFaultKind::kSilent, "wheel: does not answer"};
  loop_.start();
  roll_for(seconds{10}, 7);
  ASSERT_TRUE(until([&] { return loop_.fault().has_value(); }));
  EXPECT_EQ(loop_.fault()->command, 7u);
  EXPECT_EQ(loop_.fault()->fault.kind, IoFaultKind::kSilent);
}

TEST_F(ControlLoopTest, MakesSafeWhenItStops)
{
  loop_.start();
  ASSERT_TRUE(until([&] { return robot_.reads > 0; }));
  loop_.stop();
  EXPECT_EQ(robot_.safes, 1);
  EXPECT_FALSE(loop_.alive());
  EXPECT_TRUE(loop_.death().empty());
}

TEST_F(ControlLoopTest, MakesSafeWhenItsThreadThrows)
{
  robot_.on_read = [] { throw std::runtime_error("a driver with a flaw"); };
  loop_.start();
  ASSERT_TRUE(until([&] { return !loop_.alive(); }));
  EXPECT_EQ(robot_.safes, 1);
  EXPECT_EQ(loop_.death(), "a driver with a flaw");
}

TEST_F(ControlLoopTest, CountsThePeriodsItMissedAndDoesNotCatchUp)
{
  bool stalled = false;
  robot_.on_read = [&] {
    if (robot_.reads == 5 && !stalled) {
      stalled = true;
      const Time end = steady_now() + milliseconds{50};
      while (steady_now() < end) {
      }
    }
  };
  loop_.start();
  ASSERT_TRUE(until([&] { return robot_.reads > 10; }));
  EXPECT_GE(loop_.missed(), 23u) << "50 ms are 25 periods";
}

TEST_F(ControlLoopTest, LetsOthersAtTheHardwareBetweenCycles)
{
  std::atomic<bool> inside{false};
  std::atomic<int> together{0};
  robot_.on_read = [&] { together += inside ? 1 : 0; };
  loop_.start();
  for (int i = 0; i < 20; ++i) {
    loop_.alone([&] {
      inside = true;
      loop_.wait(milliseconds{1});
      inside = false;
    });
  }
  EXPECT_EQ(together, 0);
  EXPECT_THROW(loop_.alone([] { throw HardwareError("no power"); }), HardwareError);
}

TEST(ControlLoop, RefusesAPeriodThatIsNone)
{
  FakeRobot robot;
  EXPECT_THROW((ControlLoop{robot, steady_now, Time::zero()}), std::invalid_argument);
}

TEST(FrameQueue, OwesTheCyclesOfFramesThatFoundNoRoom)
{
  FrameQueue queue;
  SensorFrame frame;
  for (int i = 0; i < 40; ++i) {
    frame.time = Time{i};
    frame.ranges_complete = i == 35;
    queue.put(frame);
  }
  EXPECT_EQ(queue.dropped(), 8u);  // of 40, with room for 32
  ASSERT_TRUE(queue.take(frame));
  EXPECT_EQ(frame.time, Time{0});
  frame.ranges_complete = false;
  queue.put(frame);
  bool complete = false;
  while (queue.take(frame)) {
    complete = frame.ranges_complete;
  }
  EXPECT_TRUE(complete) << "the last one says what number 35 would have said";
}

TEST(LatestValue, IsEmptyThenTheNewestAndStays)
{
  LatestValue<int> box;
  EXPECT_FALSE(box.latest());
  box.put(1);
  box.put(2);
  EXPECT_EQ(box.latest(), 2);
  EXPECT_EQ(box.latest(), 2);
  box.put(3);
  EXPECT_EQ(box.latest(), 3);
}

}  // namespace
}  // namespace stetro_driver
