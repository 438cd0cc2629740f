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
#include <limits>
#include <optional>
#include <random>

#include "stetro_localizer/fused/slip_watch.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kSlip = 0.012;        // [m]
constexpr double kFalseAlarm = 3e-4;   // alarms when the sum passes -log of it, 8.11
constexpr unsigned kRobots = 4000;     // of a property
constexpr double kVariance = 0.25e-4;  // of a sensor of 5 mm [m^2]

/// Feeds one and the same innovation until the watch alarms; how often is left in `count`.
std::optional<Slip> repeat(double innovation_m, double variance_m2, int most, int & count)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  for (count = 1; count <= most; ++count) {
    if (const auto slip = watch.add(innovation_m, variance_m2, 1.0)) {
      return slip;
    }
  }
  return std::nullopt;
}

// In mm: each innovation of 12 adds (12 * 12 - 12^2 / 2) / 25 = 2.88; the third passes 8.11.
// var(d) = 1 / (3 / 25 + 1 / 144) = 3600 / 457 and d = 3 * 12 / 25 * var(d) = 5184 / 457.
TEST(SlipWatch, FindsAUsualSlipInThree)
{
  int count = 0;
  const auto slip = repeat(0.012, kVariance, 100, count);
  ASSERT_TRUE(slip);
  EXPECT_EQ(count, 3);
  EXPECT_NEAR(slip->shift_m, 1e-3 * 5184.0 / 457.0, 1e-12);
  EXPECT_NEAR(slip->variance_m2, 1e-6 * 3600.0 / 457.0, 1e-15);
}

// One innovation of 12 adds 2.88, less than 0.4 * 8.11 = 3.24, two are more. In mm, of two:
// var(d) = 1 / (2 / 25 + 1 / 144) = 3600 / 313, d = 2 * 12 / 25 * var(d) = 3456 / 313.
TEST(SlipWatch, SuspectsASlipBeforeItAlarms)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  EXPECT_FALSE(watch.suspected());
  EXPECT_FALSE(watch.add(0.012, kVariance, 1.0));
  EXPECT_FALSE(watch.suspected());
  EXPECT_FALSE(watch.add(0.012, kVariance, 1.0));
  const auto slip = watch.suspected();
  ASSERT_TRUE(slip);
  EXPECT_NEAR(slip->shift_m, 1e-3 * 3456.0 / 313.0, 1e-12);
  EXPECT_NEAR(slip->variance_m2, 1e-6 * 3600.0 / 313.0, 1e-15);
  EXPECT_TRUE(watch.add(0.012, kVariance, 1.0)) << "asking has changed nothing";
}

// One innovation of 12 adds 2.88, one of 10 only 1.92, with 2.0 between. In mm, of the former:
// var(d) = 1 / (1 / 25 + 1 / 144) = 3600 / 169, d = 12 / 25 * var(d) = 1728 / 169.
TEST(SlipWatch, AllowsForASlipThatIsLikelierThanNone)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  EXPECT_EQ(watch.suspected_m(), 0.0);
  EXPECT_FALSE(watch.add(0.010, kVariance, 1.0));
  EXPECT_EQ(watch.suspected_m(), 0.0);
  for (const double innovation_m : {0.012, -0.012}) {
    watch.clear();
    EXPECT_FALSE(watch.add(innovation_m, kVariance, 1.0));
    EXPECT_NEAR(watch.suspected_m(), 1e-3 * (1728.0 / 169.0 + 2.0 * 60.0 / 13.0), 1e-12);
  }
}

// A sensor of 12 mm adds 72 / 144 = 0.5 each time: 8.11 is passed by the seventeenth.
TEST(SlipWatch, AFarRangeCountsForLess)
{
  int count = 0;
  const auto slip = repeat(0.012, 1.44e-4, 100, count);
  ASSERT_TRUE(slip);
  EXPECT_EQ(count, 17);
  EXPECT_NEAR(slip->shift_m, 0.012 * 17.0 / 18.0, 1e-12);  // 17 readings and one by the prior
  EXPECT_NEAR(slip->variance_m2, 1.44e-4 / 18.0, 1e-15);
}

// Half a usual slip is as likely with as without one.
TEST(SlipWatch, LessThanHalfAUsualSlipIsNone)
{
  int count = 0;
  EXPECT_FALSE(repeat(0.0059, kVariance, 10000, count));
}

// The filter takes a tenth of what is left with each: a = 1, 0.9, 0.81, 0.729, the innovations are
// 12 a and add 2.88 a^2: 2.88, 5.21, 7.10, 8.63. Sum a^2 = 2.997541, so in mm var(d) = 25 /
// (2.997541 + 25 / 144), d = 12 * 2.997541 / (2.997541 + 25 / 144); 0.9^4 of it is missing still.
TEST(SlipWatch, GivesOnlyWhatTheFilterHasLeft)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  std::optional<Slip> slip;
  double left = 1.0;
  int count = 0;
  while (!slip && count < 100) {
    slip = watch.add(0.012 * left, kVariance, 0.9);
    left *= 0.9;
    ++count;
  }
  ASSERT_TRUE(slip);
  EXPECT_EQ(count, 4);
  EXPECT_NEAR(slip->shift_m, 0.6561 * 0.01134304, 1e-8);
  EXPECT_NEAR(slip->variance_m2, 0.6561 * 0.6561 * 0.25e-4 / 3.1711521, 1e-12);
}

TEST(SlipWatch, IsTheSameInBothDirections)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  SlipWatch mirrored(kSlip, kFalseAlarm);
  std::mt19937 random{11};
  std::normal_distribution<double> normal;
  int slips = 0;
  for (int i = 0; i < 20000; ++i) {
    const double e_m = 0.005 * normal(random) + (i % 100 < 10 ? 0.010 : 0.0);
    const double kept = 1.0 - 0.03 * (i % 3);
    const auto slip = watch.add(e_m, kVariance, kept);
    const auto other = mirrored.add(-e_m, kVariance, kept);
    ASSERT_EQ(slip.has_value(), other.has_value());
    if (slip) {
      EXPECT_EQ(slip->shift_m, -other->shift_m);
      EXPECT_EQ(slip->variance_m2, other->variance_m2);
      ++slips;
    }
  }
  EXPECT_GT(slips, 50);
}

TEST(SlipWatch, BeginsAnewAfterAnAlarm)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  for (int alarm = 0; alarm < 3; ++alarm) {
    EXPECT_FALSE(watch.add(0.012, kVariance, 1.0));
    EXPECT_FALSE(watch.add(0.012, kVariance, 1.0));
    EXPECT_TRUE(watch.add(0.012, kVariance, 1.0));
  }
}

TEST(SlipWatch, OneWildReadingAloneIsNoSlip)
{
  for (const double wild_m : {0.05, 1.0, 1e6, -1e6, std::numeric_limits<double>::infinity()}) {
    SlipWatch watch(kSlip, kFalseAlarm);
    EXPECT_FALSE(watch.add(wild_m, kVariance, 1.0));
    for (int i = 0; i < 100; ++i) {
      EXPECT_FALSE(watch.add(0.0, kVariance, 1.0)) << wild_m << " m, then " << i;
    }
  }
}

// In mm: 200 counts as 24, twice the usual slip, and adds 8.11 / 2.5 = 3.24 at most; 12 and 12 add
// 2.88 each: 9.01 passes. 1 / var(d) = 3 / 25 + 1 / 144 and d = (24 + 12 + 12) / 25 * var(d).
TEST(SlipWatch, AWildReadingSizesASlipByWhatItCountsFor)
{
  SlipWatch watch(kSlip, kFalseAlarm);
  EXPECT_FALSE(watch.add(0.200, kVariance, 1.0));
  EXPECT_FALSE(watch.add(0.012, kVariance, 1.0));
  const auto slip = watch.add(0.012, kVariance, 1.0);
  ASSERT_TRUE(slip);
  EXPECT_NEAR(slip->shift_m, 1e-3 * 48.0 / 25.0 * 3600.0 / 457.0, 1e-12);
}

// Lorden 1971 bounds the rate of either sum.
TEST(SlipWatch, AlarmsNoOftenerThanAsked)
{
  constexpr int kInnovations = 200000;
  for (const double sigma_m : {0.003, 0.005, 0.012, 0.02}) {
    for (const double kept : {1.0, 0.97, 0.9, 0.6}) {
      SlipWatch watch(kSlip, kFalseAlarm);
      std::mt19937 random{20260301};
      std::normal_distribution<double> normal(0.0, sigma_m);
      int alarms = 0;
      for (int i = 0; i < kInnovations; ++i) {
        alarms += watch.add(normal(random), sigma_m * sigma_m, kept) ? 1 : 0;
      }
      EXPECT_LE(alarms, kFalseAlarm * kInnovations) << sigma_m << " m, kept " << kept;
    }
  }
}

/// A place that wanders by the noise a filter knows of, and one slip that it does not.
class WanderingPlace
{
public:
  WanderingPlace(double sigma_m, unsigned seed) : R_(sigma_m * sigma_m), random_(seed)
  {
    P_ = std::sqrt(kQ * R_);  // where prediction and correction balance, nearly
    truth_m_ = std::sqrt(P_) * normal_(random_);
  }

  void slip(double by_m) { truth_m_ += by_m; }

  /// One measurement, its correction and what the watch makes of it.
  std::optional<Slip> measure()
  {
    P_ += kQ;
    truth_m_ += std::sqrt(kQ) * normal_(random_);
    const double S = P_ + R_;
    const double e_m = truth_m_ + std::sqrt(R_) * normal_(random_) - x_m_;
    const double before = P_;
    x_m_ += P_ / S * e_m;
    P_ *= 1.0 - P_ / S;
    const auto slip = watch_.add(e_m, S, P_ / before);
    if (slip) {
      x_m_ += slip->shift_m;
      P_ += slip->variance_m2;
    }
    return slip;
  }

  /// Measures until a slip is found, at most so often.
  std::optional<Slip> measure_until_found(int most)
  {
    for (int i = 0; i < most; ++i) {
      if (const auto slip = measure()) {
        return slip;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] double error_in_sigmas() const { return (truth_m_ - x_m_) / std::sqrt(P_); }

private:
  static constexpr double kQ = 2.7e-7;  // 3 mm/sqrt(s) at 33 Hz [m^2]

  double R_;
  double P_;
  double x_m_ = 0.0;
  double truth_m_;
  SlipWatch watch_{kSlip, kFalseAlarm};
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

/// Mean and root mean square of the errors after the shift, in the filter's standard deviations.
struct Errors
{
  int found = 0;
  double sum = 0.0;  // in the direction of the shift: what it left undone
  double squares = 0.0;

  void add(double z, double shift_m)
  {
    ++found;
    sum += shift_m > 0.0 ? z : -z;
    squares += z * z;
  }
  [[nodiscard]] double mean() const { return sum / found; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / found); }
};

// Without the shift the estimate were 3 sigma short on average; with one that gives again what the
// filter took by itself, 1.4 sigma too far.
TEST(SlipWatch, LeavesTheEstimateUnbiased)
{
  Errors errors;
  for (unsigned seed = 1; seed <= kRobots; ++seed) {
    WanderingPlace place(0.005, seed);
    if (place.measure_until_found(20)) {
      continue;  // a false alarm
    }
    place.slip(kSlip);
    if (const auto slip = place.measure_until_found(15)) {
      errors.add(place.error_in_sigmas(), slip->shift_m);
    }
  }
  EXPECT_GT(errors.found, 0.8 * kRobots);
  EXPECT_NEAR(errors.mean(), 0.0, 0.3);
  EXPECT_NEAR(errors.rms(), 1.0, 0.2);
}

// Property: if slips are as long as the prior says, the shift is off as far as its variance says,
// whenever the watch stopped to look. A bound on wild readings must not make long slips short.
TEST(SlipWatch, KnowsHowWellItKnowsTheSlip)
{
  for (const double sigma_m : {0.003, 0.005, 0.010}) {
    Errors errors;
    std::mt19937 random{20260303};
    std::normal_distribution<double> slips(0.0, kSlip);
    for (unsigned seed = 1; seed <= kRobots; ++seed) {
      WanderingPlace place(sigma_m, seed);
      place.slip(slips(random));
      if (const auto slip = place.measure_until_found(15)) {
        errors.add(place.error_in_sigmas(), slip->shift_m);
      }
    }
    EXPECT_GT(errors.found, 0.2 * kRobots) << sigma_m << " m";
    EXPECT_NEAR(errors.mean(), 0.0, 0.2) << sigma_m << " m";
    EXPECT_NEAR(errors.rms(), 1.0, 0.25) << sigma_m << " m";
  }
}

// What was left of a slip that there never was must not keep the watch from the next one.
TEST(SlipWatch, IsNotDeafAfterALongTime)
{
  int found = 0;
  for (unsigned seed = 1; seed <= kRobots; ++seed) {
    WanderingPlace place(0.010, seed);
    for (int i = 0; i < 300; ++i) {
      place.measure();
    }
    place.slip(0.03);
    found += place.measure_until_found(15) ? 1 : 0;
  }
  EXPECT_GT(found, 0.95 * kRobots);
}

}  // namespace
}  // namespace stetro_localizer
