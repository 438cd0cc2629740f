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

#include <algorithm>
#include <random>
#include <vector>

#include "stetro_localizer/fused/history.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr Nanoseconds kStart = std::chrono::seconds(1000);

RangeReading reading(Nanoseconds stamp, double range_m)
{
  RangeReading one;
  one.stamp = stamp;
  one.range_m = range_m;
  one.status = RangeStatus::kValid;
  return one;
}

// Four seconds of a robot that sweeps to the left and turns a little, touching a bumper once.
std::vector<Sample> a_sweep()
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  std::vector<Sample> samples;
  for (int k = 1; k <= 400; ++k) {
    const Nanoseconds stamp = kStart + k * milliseconds(10);
    samples.push_back(OdometrySample{stamp, 0.0, 0.15, 0.0});
    samples.push_back(GyroSample{stamp, 0.01 + 0.002 * noise(random)});
    if (k % 3 == 0) {
      BlockSample blocks;
      blocks.stamp = stamp;
      for (std::size_t i = 0; i < 3; ++i) {
        blocks.blocks[i].height_m = i == 0 ? 0.14 : 0.0;
        blocks.blocks[i].load = 1.0 / 3.0;
        blocks.blocks[i].load_known = true;
      }
      samples.push_back(blocks);
      RangeSample ranges;
      ranges.stamp = stamp - milliseconds(4);
      const double y_m = 0.5 + 0.0015 * k;
      ranges[Place::kSideRight] =
        reading(ranges.stamp, 1.0117 * (y_m - 0.05) + 0.004 * noise(random));
      ranges[Place::kFrontLeft] = reading(ranges.stamp, 0.217 + 0.003 * noise(random));
      ranges[Place::kFrontRight] = reading(ranges.stamp, 0.217 + 0.003 * noise(random));
      samples.push_back(ranges);
    }
    if (k % 10 == 0) {
      ContactSample contacts;
      contacts.stamp = stamp;
      for (Switch & bumper : contacts.left) {
        bumper = {true, k == 390};
      }
      samples.push_back(contacts);
    }
  }
  return samples;
}

class HistoryTest : public ::testing::Test
{
protected:
  HistoryTest() : model_(LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight()) {}

  History history(Nanoseconds window = milliseconds(400))
  {
    FusedCore core = model_.begin();
    core.steps.tell(3);
    return {model_, core, window, 256};
  }

  FusedModel model_;
};

TEST_F(HistoryTest, TheOrderOfArrivalLeavesNoTrace)
{
  const std::vector<Sample> samples = a_sweep();
  std::vector<Sample> ordered = samples;
  std::stable_sort(ordered.begin(), ordered.end(), [](const Sample & a, const Sample & b) {
    return std::make_pair(stamp_of(a), a.index()) < std::make_pair(stamp_of(b), b.index());
  });
  History in_order = history();
  for (const Sample & sample : ordered) {
    ASSERT_EQ(in_order.take(sample), History::Taken::kYes);
  }
  ASSERT_TRUE(in_order.core().located_on);
  EXPECT_GT(in_order.core().reports[Source::kSideRight].fused, 100u);

  // Every sample arrives up to 0.15 s late, each by another time.
  std::mt19937 random(6);
  std::uniform_int_distribution<int> delay(0, 150);
  std::vector<std::pair<Nanoseconds, Sample>> arrivals;
  for (const Sample & sample : samples) {
    arrivals.emplace_back(stamp_of(sample) + milliseconds(delay(random)), sample);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto & a, const auto & b) {
    return a.first < b.first;
  });
  History late = history();
  for (const auto & arrival : arrivals) {
    ASSERT_EQ(late.take(arrival.second), History::Taken::kYes);
  }
  EXPECT_EQ(late.core().time, in_order.core().time);
  EXPECT_EQ(late.core().filter.state(), in_order.core().filter.state());
  EXPECT_EQ(late.core().filter.covariance(), in_order.core().filter.covariance());
  EXPECT_EQ(
    late.core().reports[Source::kSideRight].fused,
    in_order.core().reports[Source::kSideRight].fused);
}

TEST_F(HistoryTest, ALateSampleCounts)
{
  std::vector<Sample> samples = a_sweep();
  History with = history();
  History without = history();
  for (const Sample & sample : samples) {
    with.take(sample);
    without.take(sample);
  }
  RangeSample late;
  late.stamp = kStart + milliseconds(3805);
  late[Place::kSideRight] = reading(late.stamp, 1.0117 * 1.02);
  EXPECT_EQ(with.take(late), History::Taken::kYes);
  EXPECT_NE(with.core().filter[kStateY], without.core().filter[kStateY]);
  EXPECT_LT(with.core().filter.variance(kStateY), without.core().filter.variance(kStateY));
}

// Readings of one time come in two arrays, the later first and one reading in both.
TEST_F(HistoryTest, AnArrayThatComesInPartsIsWhole)
{
  const std::vector<Sample> samples = a_sweep();
  History whole = history();
  History parted = history();
  RangeSample array;
  array.stamp = kStart + milliseconds(3805);
  array[Place::kSideRight] = reading(array.stamp, 1.0117 * 1.02);
  array[Place::kFrontLeft] = reading(array.stamp, 0.216);
  RangeSample one = array;
  one[Place::kFrontLeft] = {};
  for (const Sample & sample : samples) {
    whole.take(sample);
    parted.take(sample);
  }
  EXPECT_EQ(whole.take(array), History::Taken::kYes);
  EXPECT_EQ(parted.take(one), History::Taken::kYes);
  EXPECT_EQ(parted.take(array), History::Taken::kYes);
  EXPECT_EQ(parted.core().filter.state(), whole.core().filter.state());
  EXPECT_EQ(parted.core().filter.covariance(), whole.core().filter.covariance());
  EXPECT_EQ(parted.take(one), History::Taken::kTwice);
}

TEST_F(HistoryTest, NoLateSampleChangesWhatIsSettled)
{
  History history = this->history();
  EXPECT_EQ(history.settled().time, history.core().time) << "nothing is kept yet";
  for (const Sample & sample : a_sweep()) {
    history.take(sample);
  }
  const Nanoseconds age = history.core().time - history.settled().time;
  EXPECT_GT(age, milliseconds(380));
  EXPECT_LT(age, milliseconds(430));
  const StateVector settled = history.settled().filter.state();
  const StateVector newest = history.core().filter.state();
  RangeSample late;
  late.stamp = history.settled().time + milliseconds(12);
  late[Place::kSideRight] = reading(late.stamp, 1.0117 * 1.02);
  ASSERT_EQ(history.take(late), History::Taken::kYes);
  EXPECT_EQ(history.settled().filter.state(), settled);
  EXPECT_NE(history.core().filter.state(), newest);
}

TEST_F(HistoryTest, WhatIsOlderThanTheWindowIsStale)
{
  History kept = history(milliseconds(100));
  kept.take(GyroSample{kStart + milliseconds(10), 0.0});
  for (int k = 2; k <= 50; ++k) {
    EXPECT_EQ(kept.take(GyroSample{kStart + k * milliseconds(10), 0.0}), History::Taken::kYes);
  }
  EXPECT_EQ(kept.take(OdometrySample{kStart + milliseconds(450)}), History::Taken::kYes);
  EXPECT_EQ(kept.take(OdometrySample{kStart + milliseconds(350)}), History::Taken::kStale);
}

TEST_F(HistoryTest, TheSameSampleIsTakenOnce)
{
  History once = history();
  EXPECT_EQ(once.take(GyroSample{kStart, 0.1}), History::Taken::kYes);
  EXPECT_EQ(once.take(GyroSample{kStart, 0.1}), History::Taken::kTwice);
  EXPECT_EQ(once.take(OdometrySample{kStart, 0.0, 0.1, 0.0}), History::Taken::kYes);
}

TEST_F(HistoryTest, AFullRingForgetsItsOldest)
{
  FusedCore core = model_.begin();
  History small(model_, core, std::chrono::seconds(10), 8);
  for (int k = 1; k <= 20; ++k) {
    EXPECT_EQ(small.take(GyroSample{kStart + k * milliseconds(10), 0.1}), History::Taken::kYes);
  }
  EXPECT_EQ(small.take(OdometrySample{kStart + milliseconds(50)}), History::Taken::kStale);
  EXPECT_EQ(small.take(OdometrySample{kStart + milliseconds(155)}), History::Taken::kYes);
}

}  // namespace
}  // namespace stetro_localizer
