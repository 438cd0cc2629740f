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

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "stetro_localizer/floor/floor_filter.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_tests/counted_allocations.hpp"

namespace stetro_localizer
{
namespace
{

FloorVector some_state(std::mt19937 & random)
{
  const auto within = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  FloorVector state;
  state << within(-5.0, 5.0), within(-5.0, 5.0), within(-3.0, 3.0), within(-0.01, 0.01),
    within(-0.05, 0.05);
  return state;
}

// A covariance in which everything depends on everything.
FloorMatrix some_covariance(std::mt19937 & random)
{
  std::normal_distribution<double> normal;
  FloorMatrix root;
  for (int i = 0; i < kFloorCount; ++i) {
    for (int j = 0; j < kFloorCount; ++j) {
      root(i, j) = normal(random);
    }
  }
  const FloorVector scale = (FloorVector() << 0.05, 0.05, 0.02, 0.003, 0.02).finished();
  return scale.asDiagonal() * (root * root.transpose()) * scale.asDiagonal();
}

FloorFilter filter_at(const FloorVector & state, const FloorMatrix & covariance)
{
  FloorFilter filter;
  filter.set(state, covariance);
  return filter;
}

double least_eigenvalue(const FloorMatrix & P)
{
  return Eigen::SelfAdjointEigenSolver<FloorMatrix>(P, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

// F by central differences of a prediction; then P' must be F P F^T.
template <class Predict>
void expect_jacobian_holds(const Predict & predict)
{
  constexpr double kStep = 1e-6;
  std::mt19937 random(3);
  for (int sample = 0; sample < 30; ++sample) {
    const FloorVector at = some_state(random);
    const FloorMatrix P = some_covariance(random);
    FloorMatrix F;
    for (int i = 0; i < kFloorCount; ++i) {
      FloorFilter more = filter_at(at + kStep * FloorVector::Unit(i), P);
      FloorFilter less = filter_at(at - kStep * FloorVector::Unit(i), P);
      predict(more);
      predict(less);
      F.col(i) = (more.state() - less.state()) / (2.0 * kStep);
    }
    FloorFilter filter = filter_at(at, P);
    predict(filter);
    const double off = (filter.covariance() - F * P * F.transpose()).cwiseAbs().maxCoeff();
    EXPECT_LT(off, 1e-9 * P.cwiseAbs().maxCoeff() + 1e-11) << "sample " << sample;
  }
}

TEST(FloorFilter, JacobianOfAMoveMatchesCentralDifferences)
{
  expect_jacobian_holds([](FloorFilter & filter) { filter.roll(0.7, 0.3, -0.2, 0.0, 0.0); });
}

TEST(FloorFilter, JacobianOfATurnMatchesCentralDifferences)
{
  expect_jacobian_holds([](FloorFilter & filter) { filter.turn(0.7, 0.05, 0.0); });
}

// Facing +y, one second at 0.11 m/s counted by wheels that count a tenth too much: 0.1 m.
TEST(FloorFilter, MovesWhereTheBodyFaces)
{
  FloorVector state = FloorVector::Zero();
  state[kFloorYaw] = M_PI / 2.0;
  state[kFloorOdomScale] = 0.1;
  FloorFilter filter = filter_at(state, FloorMatrix::Zero());
  filter.roll(1.0, 0.11, 0.0, 0.003, 0.001);
  EXPECT_NEAR(filter[kFloorX], 0.0, 1e-12);
  EXPECT_NEAR(filter[kFloorY], 0.1, 1e-12);
  EXPECT_NEAR(filter.variance(kFloorY), 9e-6, 1e-15) << "along";
  EXPECT_NEAR(filter.variance(kFloorX), 1e-6, 1e-15) << "across";
}

TEST(FloorFilter, TurnsByWhatTheGyroscopeReadsLessItsBias)
{
  FloorVector state = FloorVector::Zero();
  state[kFloorYaw] = 3.0;
  state[kFloorGyroBias] = 0.01;
  FloorFilter filter = filter_at(state, FloorMatrix::Zero());
  filter.turn(2.0, 0.21, 0.001);
  EXPECT_NEAR(filter[kFloorYaw], 3.4 - 2.0 * M_PI, 1e-12) << "wrapped";
  EXPECT_NEAR(filter.variance(kFloorYaw), 2e-6, 1e-15);
}

// Position of sigma 0.3 m, fix of sigma 0.4 m: gain 0.36, by hand.
TEST(FloorFilter, WeighsAFixAgainstWhatItKnows)
{
  FloorMatrix P = FloorMatrix::Identity();
  P(kFloorX, kFloorX) = 0.09;
  FloorFilter filter = filter_at(FloorVector::Zero(), P);
  PoseFix fix;
  fix.pose << 1.0, 0.0, 0.0;
  fix.covariance = Eigen::Vector3d(0.16, 1.0, 1.0).asDiagonal();
  EXPECT_NEAR(filter.innovation(fix).nis(), 1.0 / 0.25, 1e-12);
  filter.correct(fix);
  EXPECT_NEAR(filter[kFloorX], 0.36, 1e-12);
  EXPECT_NEAR(filter.variance(kFloorX), 0.09 * 0.64, 1e-12);
}

TEST(FloorFilter, TakesTheShortWayRoundForAHeading)
{
  FloorVector state = FloorVector::Zero();
  state[kFloorYaw] = 3.1;
  FloorFilter filter = filter_at(state, FloorMatrix::Identity());
  PoseFix fix;
  fix.pose << 0.0, 0.0, -3.1;
  EXPECT_NEAR(filter.innovation(fix).value.z(), 2.0 * M_PI - 6.2, 1e-12);
  filter.correct(fix);
  EXPECT_NEAR(std::abs(filter[kFloorYaw]), M_PI, 1e-12);
}

// The gyroscope of a standing robot tells its bias, and so how far the heading has drifted.
TEST(FloorFilter, LearnsTheBiasWhileStanding)
{
  FloorVector state = FloorVector::Zero();
  FloorMatrix P = 1e-6 * FloorMatrix::Identity();
  P(kFloorGyroBias, kFloorGyroBias) = 0.0052 * 0.0052;
  FloorFilter filter = filter_at(state, P);
  filter.turn(1.0, 0.004, 2e-4);  // a second of nothing but bias
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(filter.stand(0.004, 0.00175 * 0.00175, 16.0));
  }
  EXPECT_NEAR(filter[kFloorGyroBias], 0.004, 1e-5);
  EXPECT_NEAR(filter[kFloorYaw], 0.0, 2e-5);
  EXPECT_FALSE(filter.stand(0.1, 0.00175 * 0.00175, 16.0)) << "somebody turns it";
}

// Property: whatever it takes, in any order, the covariance stays symmetric and positive.
TEST(FloorFilter, CovarianceStaysSymmetricAndPositive)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  FloorFilter filter = filter_at(some_state(random), some_covariance(random));
  for (int i = 0; i < 5000; ++i) {
    filter.turn(0.01, 0.2 * within(random), 2e-4);
    filter.roll(0.01, 0.3 * within(random), 0.2 * within(random), 3e-3, 5e-4);
    if (i % 7 == 0) {
      filter.stand(filter[kFloorGyroBias], 3e-6, 16.0);
    }
    if (i % 50 == 0) {
      PoseFix fix;
      fix.pose = filter.state().head<3>();
      const double sigma = i % 100 == 0 ? 1e-5 : 3.0;  // hardly anything, or everything
      fix.covariance = Eigen::Vector3d(sigma * sigma, 1e-4, sigma * sigma).asDiagonal();
      filter.correct(fix);
    }
    const FloorMatrix & P = filter.covariance();
    ASSERT_LT((P - P.transpose()).cwiseAbs().maxCoeff(), 1e-15) << "after " << i;
    ASSERT_GE(least_eigenvalue(P), -1e-15) << "after " << i;
  }
}

TEST(FloorFilter, TurnedCovarianceIsThatOfTheTurnedState)
{
  FloorMatrix P = FloorMatrix::Identity();
  P(kFloorX, kFloorX) = 4.0;
  P(kFloorX, kFloorGyroBias) = P(kFloorGyroBias, kFloorX) = 0.5;
  const FloorMatrix quarter = turned(P, M_PI / 2.0);  // x becomes y
  EXPECT_NEAR(quarter(kFloorY, kFloorY), 4.0, 1e-12);
  EXPECT_NEAR(quarter(kFloorX, kFloorX), 1.0, 1e-12);
  EXPECT_NEAR(quarter(kFloorY, kFloorGyroBias), 0.5, 1e-12);
  EXPECT_NEAR(quarter(kFloorX, kFloorGyroBias), 0.0, 1e-12);
}

// Of tables: 5 % beyond 7.815, 0.1 % beyond 16.266.
TEST(FloorFilter, KnowsChiSquareOfThreeDegreesOfFreedom)
{
  EXPECT_NEAR(chi_square_3_quantile(0.05), 7.815, 1e-3);
  EXPECT_NEAR(chi_square_3_quantile(0.001), 16.266, 1e-3);
}

// A drive that is drawn from the filter's own model: the normalised error squared of the pose
// averages to three, within what its chi-square law allows 200 independent runs.
TEST(FloorFilter, IsConsistentOverSimulatedDrives)
{
  constexpr int kRuns = 200;
  constexpr double kDt = 0.05;
  const FloorNoise noise;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    FloorMatrix P = FloorMatrix::Zero();
    P.diagonal() << 1e-4, 1e-4, 4e-4, 0.0052 * 0.0052, 4e-4;
    FloorVector truth = FloorVector::Zero();
    for (int i = 0; i < kFloorCount; ++i) {
      truth[i] = std::sqrt(P(i, i)) * normal(random);
    }
    FloorFilter filter = filter_at(FloorVector::Zero(), P);
    for (int k = 0; k < 400; ++k) {
      const double v = 0.15 * (k % 100 < 80 ? 1.0 : 0.0);
      const double w = k % 100 < 80 ? 0.0 : 0.3;
      const double slip = noise.slip * std::sqrt(kDt) * normal(random) * (v > 0.0);
      const double aside = noise.across * std::sqrt(kDt) * normal(random) * (v > 0.0);
      const double c = std::cos(truth[kFloorYaw]);
      const double s = std::sin(truth[kFloorYaw]);
      truth[kFloorX] += c * (v * kDt + slip) - s * aside;
      truth[kFloorY] += s * (v * kDt + slip) + c * aside;
      truth[kFloorYaw] += w * kDt;
      const double read = w + truth[kFloorGyroBias] + noise.turn / std::sqrt(kDt) * normal(random);
      filter.roll(kDt, (1.0 + truth[kFloorOdomScale]) * v, 0.0, noise.slip, noise.across);
      filter.turn(kDt, read, noise.turn);
      if (k % 40 == 39) {
        PoseFix fix;
        fix.covariance = Eigen::Vector3d(4e-4, 9e-4, 1e-4).asDiagonal();
        fix.pose =
          truth.head<3>() +
          Eigen::Vector3d(0.02 * normal(random), 0.03 * normal(random), 0.01 * normal(random));
        filter.correct(fix);
      }
    }
    Eigen::Vector3d error = (truth - filter.state()).head<3>();
    error.z() = stetro_site::wrap_angle(error.z());
    sum += error.dot(filter.covariance().topLeftCorner<3, 3>().inverse() * error);
  }
  const double mean = sum / kRuns;
  const double sigma = std::sqrt(6.0 / kRuns);  // the variance of chi-square is 2 * 3
  EXPECT_NEAR(mean, 3.0, 3.5 * sigma);
}

TEST(FloorFilter, PredictsAndCorrectsWithoutAllocating)
{
  std::mt19937 random(5);
  FloorFilter filter = filter_at(some_state(random), some_covariance(random));
  const PoseFix fix;
  const std::size_t before = allocations;
  filter.roll(0.01, 0.1, 0.0, 3e-3, 5e-4);
  filter.turn(0.01, 0.1, 2e-4);
  filter.stand(0.0, 3e-6, 16.0);
  filter.correct(fix);
  const double nis = filter.innovation(fix).nis();
  EXPECT_EQ(allocations, before) << nis;
}

}  // namespace
}  // namespace stetro_localizer
