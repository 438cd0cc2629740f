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

#include <cmath>

#include "pilot.hpp"
#include "sim/sim_tof.hpp"

namespace stetro_driver::sim
{
namespace
{

using test::paper_stairs;

/// A cone of 12.5 degrees reads a flat wall that much too far: worked by hand,
/// mean of p / cos over the cone weighted by cos^3, (1 - c^3) / 3 over (1 - c^4) / 4.
constexpr double kConeFactor = 1.01190;

struct Scene
{
  explicit Scene(const BodyPose & pose) : world(paper_stairs()), body(shape, world, 0.5, {})
  {
    body.place(pose);
  }

  [[nodiscard]] SimTof sensor(RangePlace place, const SimErrors & errors, std::uint64_t seed = 1)
  {
    const auto i = static_cast<std::size_t>(place);
    return SimTof{shape.tof[i], errors, seed, kRangeNames[i]};
  }
  [[nodiscard]] double echo_m(RangePlace place)
  {
    return sensor(place, no_errors()).echo(body).distance_m;
  }

  BodyShape shape;
  StairWorld world;
  SimBody body;
};

TEST(SimTof, ReadsAFlatWallOnePercentTooFar)
{
  Scene scene{{-0.55, 0.55, 0.0}};
  // The floor is 0.33 m below: at 0.5 m nothing of it is inside the cone.
  EXPECT_NEAR(scene.echo_m(RangePlace::kSideRight), 0.5 * kConeFactor, 0.0002);
}

TEST(SimTof, ReadsItsRecessAtContact)
{
  Scene wall{{0.235, 0.115, 0.0}};
  EXPECT_NEAR(wall.echo_m(RangePlace::kSideRight), 0.065 * kConeFactor, 0.0002);
  Scene standing{{0.235, 1.0, 0.0}};
  EXPECT_NEAR(standing.echo_m(RangePlace::kBlock1Down), 0.035 * kConeFactor, 0.0002);
  EXPECT_NEAR(standing.echo_m(RangePlace::kBlock2Down), 0.035 * kConeFactor, 0.0002);
  EXPECT_NEAR(standing.echo_m(RangePlace::kBlock3Front), 0.035 * kConeFactor, 0.0002)
    << "block 2's back";
}

TEST(SimTof, ReadsTheNextRiserWhileSweeping)
{
  Scene scene{{0.235, 1.0, 0.0}};
  // Riser 3 at 0.64, the sensors at 0.235 + 0.19: 0.215 m.
  EXPECT_NEAR(scene.echo_m(RangePlace::kFrontLeft), 0.215 * kConeFactor, 0.0005);
  EXPECT_NEAR(scene.echo_m(RangePlace::kStairFront), 0.215 * kConeFactor, 0.0005);
}

TEST(SimTof, BlockThreeSeesTheRiserUnderALiftedBlockTwo)
{
  Scene scene{{0.235, 1.0, 0.0}};
  scene.body.lift(2, 1.0);
  // Riser 2 at 0.32, the sensor at 0.235 - 0.11.
  EXPECT_NEAR(scene.echo_m(RangePlace::kBlock3Front), 0.195 * kConeFactor, 0.001);
}

TEST(SimTof, AnObliqueWallReadsShort)
{
  Scene scene{{-0.55, 0.6, 0.7}};
  const double y_m = 0.6 - 0.05 * std::cos(0.7);
  const double on_axis_m = y_m / std::cos(0.7);
  const double nearest_m = y_m / std::cos(0.7 - 0.218);
  EXPECT_LT(scene.echo_m(RangePlace::kSideRight), on_axis_m);
  EXPECT_GT(scene.echo_m(RangePlace::kSideRight), nearest_m);
}

TEST(SimTof, RoundsToMillimetres)
{
  Scene scene{{-0.55, 0.55, 0.0}};
  SimTof sensor = scene.sensor(RangePlace::kSideRight, SimErrors{});
  for (int i = 0; i < 50; ++i) {
    const RangeReading reading = sensor.measure(scene.body, Time{i + 1}, 0.033);
    ASSERT_EQ(reading.status, RangeStatus::kValid);
    EXPECT_NEAR(std::remainder(reading.range_m, 0.001), 0.0, 1e-9);
    EXPECT_EQ(reading.stamp, Time{i + 1});
  }
}

TEST(SimTof, HasTheNoiseOfTheDataSheet)
{
  Scene scene{{-0.55, 0.55, 0.0}};
  SimErrors errors = no_errors();
  errors.tof_white_std_m = 0.0021;
  errors.tof_white_std_per_m = 0.015;
  SimTof sensor = scene.sensor(RangePlace::kSideRight, errors);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kReadings = 5000;
  for (int i = 0; i < kReadings; ++i) {
    const double error_m =
      sensor.measure(scene.body, Time{i + 1}, 0.033).range_m - 0.5 * kConeFactor;
    sum += error_m;
    squares += error_m * error_m;
  }
  const double expected_m = std::hypot(0.0021, 0.015 * 0.506);  // 7.9 mm
  EXPECT_NEAR(sum / kReadings, 0.0, 0.0005);
  EXPECT_NEAR(std::sqrt(squares / kReadings), expected_m, 0.0003);
}

// Property: the flicker has numbers of its own. Without it the other errors stay what they are.
TEST(SimTof, FlickersBesideItsOtherErrors)
{
  Scene scene{{-0.55, 0.55, 0.0}};
  SimErrors calm;
  calm.tof_flicker_std_m = 0.0;
  SimTof with = scene.sensor(RangePlace::kSideRight, SimErrors{});
  SimTof without = scene.sensor(RangePlace::kSideRight, calm);
  EXPECT_EQ(with.offset_m(), without.offset_m());
  EXPECT_EQ(with.gain(), without.gain());
  double squares_m2 = 0.0;
  constexpr int kReadings = 20000;  // 110 of its time constants
  for (int i = 0; i < kReadings; ++i) {
    const double apart_m = with.measure(scene.body, Time{i + 1}, 0.033).range_m -
                           without.measure(scene.body, Time{i + 1}, 0.033).range_m;
    ASSERT_LT(std::abs(apart_m), 0.003) << "five standard deviations, rounded twice";
    squares_m2 += apart_m * apart_m;
  }
  // Each rounding adds 1 mm^2 / 12; both together 0.41 mm.
  EXPECT_NEAR(std::sqrt(squares_m2 / kReadings), std::hypot(0.0003, 0.00041), 0.00006);
}

TEST(SimTof, DrawsOffsetsAsItsCalibrationSays)
{
  Scene scene{{-0.55, 0.55, 0.0}};
  const auto spread_m = [&](const char * calibration) {
    SimErrors errors;
    errors.calibration = calibration;
    double squares = 0.0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      const double offset_m = scene.sensor(RangePlace::kSideLeft, errors, seed).offset_m();
      squares += offset_m * offset_m;
    }
    return std::sqrt(squares / 400.0);
  };
  EXPECT_NEAR(spread_m("factory"), 0.003, 0.0004);
  EXPECT_NEAR(spread_m("none"), 0.010, 0.0013);
  SimErrors wrong;
  wrong.calibration = "maybe";
  EXPECT_THROW(scene.sensor(RangePlace::kSideLeft, wrong), std::invalid_argument);
}

TEST(SimTof, LosesItsTargetBeyondTheLimit)
{
  const auto valid_share = [](double y_m) {
    Scene scene{{-0.55, y_m, 0.0}};
    SimTof sensor = scene.sensor(RangePlace::kSideRight, no_errors());
    int valid = 0;
    for (int i = 0; i < 1000; ++i) {
      valid += std::isfinite(sensor.measure(scene.body, Time{i + 1}, 0.033).range_m) ? 1 : 0;
    }
    return valid / 1000.0;
  };
  EXPECT_EQ(valid_share(0.9), 1.0);
  EXPECT_GT(valid_share(1.2), 0.85);
  EXPECT_LT(valid_share(1.75), 0.05) << "1.3 times the limit, the floor adds a little";
}

TEST(SimTof, SaysNoTargetOnTheLanding)
{
  Scene scene{{0.32 * 16 - 0.085, 1.0, 0.0}};
  SimTof sensor = scene.sensor(RangePlace::kStairFront, no_errors());
  const RangeReading reading = sensor.measure(scene.body, Time{1}, 0.033);
  EXPECT_EQ(reading.status, RangeStatus::kNoTarget);
  EXPECT_TRUE(std::isinf(reading.range_m) && reading.range_m > 0.0) << "REP 117";
}

}  // namespace
}  // namespace stetro_driver::sim
