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
#include <cmath>
#include <random>
#include <vector>

#include "stetro_localizer/floor/floor_model.hpp"
#include "stetro_localizer/sample_history.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;
using FloorHistory = SampleHistory<FloorModel>;

constexpr Nanoseconds kStart = std::chrono::seconds(1000);

FloorFix fix_at(Nanoseconds stamp, double x_m, double yaw_rad = 0.0)
{
  FloorFix fix;
  fix.stamp = stamp;
  fix.floor = 0;
  fix.fix.pose << x_m, 0.0, yaw_rad;
  fix.fix.covariance = Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal();
  return fix;
}

FloorCore standing_at_the_origin(const FloorModel & model)
{
  FloorCore core = model.begin();
  FloorMatrix P = core.filter.covariance();
  P.topLeftCorner<3, 3>() = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  core.filter.set(FloorVector::Zero(), P);
  core.gate.trust(0);
  core.time = core.turned_to = core.moved_to = kStart;
  return core;
}

// Ten seconds along x with a turn, and corrections once a second; it is carried off after four: a
// streak of refused ones loses the pose, and two others find it again.
std::vector<FloorSample> a_drive()
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  std::vector<FloorSample> samples;
  for (int k = 1; k <= 1000; ++k) {
    const Nanoseconds stamp = kStart + k * milliseconds(10);
    const bool turning = k > 200 && k <= 300;
    samples.push_back(GyroSample{stamp, (turning ? 0.05 : 0.0) + 0.002 * noise(random)});
    samples.push_back(OdometrySample{stamp, turning ? 0.0 : 0.15, 0.0, turning ? 0.05 : 0.0});
    if (k % 100 == 37) {
      const double way_m = 0.0015 * (k > 300 ? k - 100 : std::min(k, 200));
      const double carried_m = k > 400 ? 3.0 : 0.0;
      samples.push_back(fix_at(stamp - milliseconds(4), way_m + carried_m, k > 300 ? 0.05 : 0.0));
    }
  }
  return samples;
}

TEST(FloorModel, ALateCorrectionIsOneInTime)
{
  const FloorModel model{LocalizerParams{}};
  const std::vector<FloorSample> samples = a_drive();
  std::vector<FloorSample> ordered = samples;
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto & a, const auto & b) {
    return std::make_pair(stamp_of(a), a.index()) < std::make_pair(stamp_of(b), b.index());
  });
  FloorHistory in_order(model, standing_at_the_origin(model), milliseconds(2000), 1024);
  for (const FloorSample & sample : ordered) {
    ASSERT_EQ(in_order.take(sample), FloorHistory::Taken::kYes);
  }
  EXPECT_EQ(in_order.core().resets, 1u);
  EXPECT_GT(in_order.core().reports[1].fused, 3u);

  // Corrections arrive half a second late, the others up to 30 ms.
  std::mt19937 random(6);
  std::uniform_int_distribution<int> delay(0, 30);
  std::vector<std::pair<Nanoseconds, FloorSample>> arrivals;
  for (const FloorSample & sample : samples) {
    const bool fix = std::holds_alternative<FloorFix>(sample);
    arrivals.emplace_back(stamp_of(sample) + milliseconds(fix ? 500 : delay(random)), sample);
  }
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto & a, const auto & b) {
    return a.first < b.first;
  });
  FloorHistory late(model, standing_at_the_origin(model), milliseconds(2000), 1024);
  for (const auto & arrival : arrivals) {
    ASSERT_EQ(late.take(arrival.second), FloorHistory::Taken::kYes);
  }
  EXPECT_EQ(late.core().filter.state(), in_order.core().filter.state());
  EXPECT_EQ(late.core().filter.covariance(), in_order.core().filter.covariance());
  EXPECT_EQ(late.core().resets, in_order.core().resets);
}

TEST(FloorModel, RefusesACorrectionOlderThanItKeeps)
{
  const FloorModel model{LocalizerParams{}};
  FloorHistory history(model, standing_at_the_origin(model), milliseconds(500), 1024);
  for (int k = 1; k <= 100; ++k) {
    history.take(OdometrySample{kStart + k * milliseconds(10), 0.1, 0.0, 0.0});
  }
  EXPECT_EQ(history.take(fix_at(kStart + milliseconds(300), 0.0)), FloorHistory::Taken::kStale);
}

TEST(FloorModel, AGyroscopeThatRepeatsItselfInMotionIsStuck)
{
  const FloorModel model{LocalizerParams{}};
  FloorCore core = standing_at_the_origin(model);
  const double sure = core.filter.variance(kFloorYaw);
  for (int k = 1; k <= 100; ++k) {
    const Nanoseconds stamp = kStart + k * milliseconds(10);
    model.take(core, GyroSample{stamp, 0.001});
    model.take(core, OdometrySample{stamp, 0.1, 0.0, 0.05});
  }
  EXPECT_TRUE(model.gyro_stuck(core));
  EXPECT_GT(core.filter.variance(kFloorYaw), sure + 0.4 * 0.1 * 0.1) << "it turns unseen";
}

TEST(FloorModel, WheelsThatTurnWithoutTheGyroscopeContradictIt)
{
  const FloorModel model{LocalizerParams{}};
  FloorCore core = standing_at_the_origin(model);
  for (int k = 1; k <= 150; ++k) {
    const Nanoseconds stamp = kStart + k * milliseconds(10);
    model.take(core, GyroSample{stamp, k % 2 ? 0.001 : -0.001});
    model.take(core, OdometrySample{stamp, 0.0, 0.0, 0.2});
  }
  EXPECT_TRUE(model.turns_conflict(core));
}

// Pushing a wall the wheels spin: how far it went is doubtful.
TEST(FloorModel, DoubtsTheWayOfARobotThatPushes)
{
  const FloorModel model{LocalizerParams{}};
  const auto doubt = [&](bool touching) {
    FloorCore core = standing_at_the_origin(model);
    ContactSample contacts;
    contacts.stamp = kStart + milliseconds(1);
    contacts.left.fill({true, touching});
    model.take(core, contacts);
    model.take(core, OdometrySample{kStart + milliseconds(100), 0.0, 0.1, 0.0});
    return core.filter.variance(kFloorY);
  };
  EXPECT_GT(doubt(true), doubt(false) + 0.09 * 0.02 * 0.02);
}

}  // namespace
}  // namespace stetro_localizer
