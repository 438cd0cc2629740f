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

#include "stetro_localizer/fused/error_state_filter.hpp"
#include "support/jacobian.hpp"

namespace stetro_localizer
{
namespace
{

ProcessNoise quiet() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }

// A filter whose states are all correlated, by measuring random mixtures of them.
ErrorStateFilter entangled(unsigned seed)
{
  ErrorStateFilter filter;
  const StateVector state = some_state(seed);
  for (int i = 0; i < kStateCount; ++i) {
    filter.set(i, state[i], 0.01 + 0.001 * i);
  }
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 30; ++k) {
    Expectation mixture(0.0);
    for (int i = 0; i < 6; ++i) {
      mixture.depends_on((k * 5 + i * 3) % kStateCount, normal(random));
    }
    filter.correct(mixture, {0.0, filter.innovation(mixture, 0.0, 0.02).variance});
  }
  return filter;
}

StateVector moved(const StateVector & state, double dt_s, double rate_radps)
{
  ErrorStateFilter filter;
  for (int i = 0; i < kStateCount; ++i) {
    filter.set(i, state[i], 0.0);
  }
  filter.predict(dt_s, rate_radps, quiet(), false);
  return filter.state();
}

TEST(ErrorStateFilter, PropagatesByTheJacobianOfTheMotion)
{
  ErrorStateFilter filter = entangled(3);
  const StateVector before = filter.state();
  const StateMatrix P = filter.covariance();
  StateMatrix F;
  constexpr double kStep = 1e-6;
  for (int i = 0; i < kStateCount; ++i) {
    StateVector more = before;
    StateVector less = before;
    more[i] += kStep;
    less[i] -= kStep;
    F.col(i) = (moved(more, 0.05, 0.2) - moved(less, 0.05, 0.2)) / (2.0 * kStep);
  }
  filter.predict(0.05, 0.2, quiet(), false);
  EXPECT_LT((filter.covariance() - F * P * F.transpose()).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(filter.covariance(), filter.covariance().transpose());
}

// 0.15 m/s to the left for 2 s at a heading of 30 deg: 0.3 m, half of it against x.
TEST(ErrorStateFilter, MovesAlongItsHeading)
{
  StateVector state = StateVector::Zero();
  state[kStateVy] = 0.15;
  state[kStateYaw] = std::acos(-1.0) / 6.0;
  const StateVector after = moved(state, 2.0, 0.0);
  EXPECT_NEAR(after[kStateX], -0.15, 1e-12);
  EXPECT_NEAR(after[kStateY], 0.3 * std::sqrt(0.75), 1e-12);
}

TEST(ErrorStateFilter, CorrectsAsJosephsFormDoes)
{
  ErrorStateFilter filter = entangled(4);
  const StateVector before = filter.state();
  const StateMatrix P = filter.covariance();
  Expectation expectation(1.0);
  StateVector H = StateVector::Zero();
  for (const int i : {0, 1, 2, 7, 12, 13}) {
    H[i] = 0.3 * (i + 1);
    expectation.depends_on(i, H[i]);
  }
  const double R = 0.04;
  const Innovation innovation = filter.innovation(expectation, 1.5, R);
  EXPECT_NEAR(innovation.variance, H.dot(P * H) + R, 1e-12);
  filter.correct(expectation, innovation);
  const StateVector K = P * H / (H.dot(P * H) + R);
  const StateMatrix L = StateMatrix::Identity() - K * H.transpose();
  const StateMatrix joseph = L * P * L.transpose() + R * K * K.transpose();
  EXPECT_LT((filter.covariance() - joseph).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((filter.state() - before - K * 0.5).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ErrorStateFilter, ConsideredStatesAreNotCorrected)
{
  ErrorStateFilter filter = entangled(5);
  const StateVector before = filter.state();
  const StateMatrix P = filter.covariance();
  Expectation expectation(0.0);
  StateVector H = StateVector::Zero();
  for (const int i : {0, 2, 12, 13}) {
    H[i] = 1.0;
    expectation.depends_on(i, 1.0);
  }
  const Innovation innovation = filter.innovation(expectation, 0.1, 0.01);
  filter.correct(expectation, innovation, Corrects::only(kStateX));
  StateVector K = P * H / innovation.variance;
  K.tail<kStateCount - 1>().setZero();
  const StateMatrix L = StateMatrix::Identity() - K * H.transpose();
  const StateMatrix joseph = L * P * L.transpose() + 0.01 * K * K.transpose();
  EXPECT_LT((filter.covariance() - joseph).cwiseAbs().maxCoeff(), 1e-12);
  for (int i = kStateX + 1; i < kStateCount; ++i) {
    EXPECT_EQ(filter[i], before[i]);
  }
}

// Schmidt's filter in Joseph's form, the gain of every held state zero.
TEST(ErrorStateFilter, CorrectsAllButTheHeldOnes)
{
  for (unsigned seed = 11; seed < 31; ++seed) {
    ErrorStateFilter filter = entangled(seed);
    const StateVector before = filter.state();
    const StateMatrix P = filter.covariance();
    Expectation expectation(0.2);
    StateVector H = StateVector::Zero();
    for (const int i : {0, 1, 2, 7, 12, 13}) {
      H[i] = 0.2 * (i + 1) - 1.0;
      expectation.depends_on(i, H[i]);
    }
    const double R = 0.01;
    const Innovation innovation = filter.innovation(expectation, 0.3, R);
    filter.correct(
      expectation, innovation,
      Corrects::all().but(kStateYaw).but(kStateFirstCalibration).but(kStateCount - 1));
    StateVector K = P * H / innovation.variance;
    for (const int held : {+kStateYaw, +kStateFirstCalibration, kStateCount - 1}) {
      K[held] = 0.0;
      EXPECT_EQ(filter[held], before[held]);
      EXPECT_EQ(filter.variance(held), P(held, held));
    }
    const StateMatrix L = StateMatrix::Identity() - K * H.transpose();
    const StateMatrix joseph = L * P * L.transpose() + R * K * K.transpose();
    EXPECT_LT((filter.covariance() - joseph).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((filter.state() - before - K * 0.1).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(filter.covariance(), filter.covariance().transpose());
    EXPECT_EQ(filter.covariance()(kStateYaw, kStateCount - 1), P(kStateYaw, kStateCount - 1));
  }
}

TEST(ErrorStateFilter, HoldingAllButOneIsCorrectingOne)
{
  ErrorStateFilter one = entangled(31);
  ErrorStateFilter other = one;
  Expectation expectation(0.0);
  expectation.depends_on(kStateY, 1.0);
  expectation.depends_on(kStateYaw, -0.4);
  const Innovation innovation = one.innovation(expectation, 0.1, 0.01);
  Corrects corrects = Corrects::all();
  for (int i = 0; i < kStateCount; ++i) {
    corrects = i == kStateY ? corrects : corrects.but(i);
  }
  one.correct(expectation, innovation, Corrects::only(kStateY));
  other.correct(expectation, innovation, corrects);
  EXPECT_EQ(one.state(), other.state());
  EXPECT_EQ(one.covariance(), other.covariance());
}

TEST(ErrorStateFilter, ShiftsOneStateWithItsOwnDoubt)
{
  ErrorStateFilter filter = entangled(32);
  const StateVector before = filter.state();
  StateMatrix P = filter.covariance();
  filter.shift(kStateY, 0.005, 1.6e-5);
  P(kStateY, kStateY) += 1.6e-5;
  EXPECT_EQ(filter.covariance(), P);
  EXPECT_LT((filter.state() - before - 0.005 * StateVector::Unit(kStateY)).norm(), 1e-15);
}

/// What the 20000 corrections below may change: all, x alone, all but one or all but several.
Corrects some_states(int i)
{
  switch (i % 5) {
    case 0:
      return Corrects::only(kStateX);
    case 1:
      return Corrects::all().but(kStateYaw);
    case 2:
      return Corrects::all().but(i % kStateCount).but((i / 5) % kStateCount);
    default:
      return Corrects::all();
  }
}

// y is wrong by e, and an offset by -e / 2 with it: their sum with twice the offset is as before.
TEST(ErrorStateFilter, InflatesStatesTogether)
{
  ErrorStateFilter filter;
  filter.set(kStateY, 1.0, 1e-6);
  const int offset = offset_index(Ranger::kSideRight);
  filter.set(offset, 0.0, 4e-6);
  StateVector together = StateVector::Unit(kStateY);
  together[offset] = -0.5;
  filter.inflate(together, 4e-4);
  EXPECT_NEAR(filter.variance(kStateY), 4.01e-4, 1e-15);
  EXPECT_NEAR(filter.variance(offset), 1.04e-4, 1e-15);
  EXPECT_NEAR(filter.covariance()(kStateY, offset), -2e-4, 1e-15);
  Expectation sum(1.0);
  sum.depends_on(kStateY, 1.0);
  sum.depends_on(offset, 2.0);
  EXPECT_NEAR(filter.innovation(sum, 1.0, 0.0).variance, 1e-6 + 4.0 * 4e-6, 1e-15);
}

TEST(ErrorStateFilter, StaysSymmetricAndPositive)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  ErrorStateFilter filter = entangled(6);
  for (int i = 0; i < 20000; ++i) {
    filter.predict(0.01, 0.1 * normal(random), ProcessNoise{}, i % 2 == 0);
    Expectation expectation(0.0);
    for (int k = 0; k < 6; ++k) {
      expectation.depends_on((i * 7 + k * 3) % kStateCount, normal(random));
    }
    const double variance = std::pow(10.0, -4.0 - 6.0 * (i % 3));
    filter.correct(
      expectation, filter.innovation(expectation, 1e-3 * normal(random), variance), some_states(i));
    if (i % 500 == 0) {
      const StateMatrix & P = filter.covariance();
      ASSERT_EQ(P, P.transpose());
      ASSERT_GT(Eigen::SelfAdjointEigenSolver<StateMatrix>(P).eigenvalues().minCoeff(), -1e-12);
    }
  }
}

TEST(ErrorStateFilter, ClimbingMovesTheReferenceOneTreadOn)
{
  ErrorStateFilter filter = entangled(8);
  const StateVector before = filter.state();
  const StateMatrix P = filter.covariance();
  filter.climb(0.31, 6e-6, 3e-6);
  EXPECT_NEAR(filter[kStateX], before[kStateX] - before[kStateTreadAhead], 1e-15);
  EXPECT_EQ(filter[kStateTreadHere], before[kStateTreadAhead]);
  EXPECT_EQ(filter[kStateRiserAhead], before[kStateRiserNext]);
  EXPECT_EQ(filter[kStateTreadAhead], 0.31);
  EXPECT_NEAR(
    filter.variance(kStateX),
    P(kStateX, kStateX) + P(kStateTreadAhead, kStateTreadAhead) - 2 * P(kStateX, kStateTreadAhead),
    1e-12);
  // From the tread's own riser the robot is where it was: x + tread here is the old x.
  const StateMatrix & Q = filter.covariance();
  EXPECT_NEAR(
    Q(kStateX, kStateX) + Q(kStateTreadHere, kStateTreadHere) + 2 * Q(kStateX, kStateTreadHere),
    P(kStateX, kStateX), 1e-12);
}

TEST(ErrorStateFilter, DescendingUndoesClimbing)
{
  ErrorStateFilter filter = entangled(9);
  const double x_m = filter[kStateX];
  const double variance = filter.variance(kStateX);
  filter.climb(0.31, 6e-6, 3e-6);
  filter.descend(0.32, 6e-6, 3e-6);
  EXPECT_NEAR(filter[kStateX], x_m, 1e-15);
  EXPECT_NEAR(filter.variance(kStateX), variance, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
