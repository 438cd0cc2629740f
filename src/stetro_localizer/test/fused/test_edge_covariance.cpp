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

// The doubt of the edge against a filter that has it as a state more, which nothing corrects.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stetro_localizer/fused/error_state_filter.hpp"
#include "support/jacobian.hpp"

namespace stetro_localizer
{
namespace
{

constexpr int kEdge = kStateCount;
constexpr double kTreadVariance = 6e-6;
constexpr double kRiserVariance = 3e-6;
using Wide = Eigen::Matrix<double, kStateCount + 1, kStateCount + 1>;
using WideVector = Eigen::Matrix<double, kStateCount + 1, 1>;

ProcessNoise quiet() { return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}; }

ErrorStateFilter some_filter(unsigned seed)
{
  ErrorStateFilter filter;
  const StateVector state = some_state(seed);
  for (int i = 0; i < kStateCount; ++i) {
    filter.set(i, state[i], 0.01 + 0.001 * i);
  }
  filter.begin_edge(2e-5, kTreadVariance);
  return filter;
}

Wide wide(const ErrorStateFilter & filter)
{
  Wide P;
  P.topLeftCorner<kStateCount, kStateCount>() = filter.covariance();
  P.topRightCorner<kStateCount, 1>() = filter.edge_covariance();
  P.bottomLeftCorner<1, kStateCount>() = filter.edge_covariance().transpose();
  P(kEdge, kEdge) = filter.edge_variance();
  return P;
}

void expect_equal(const ErrorStateFilter & filter, const Wide & P)
{
  EXPECT_LT((wide(filter) - P).cwiseAbs().maxCoeff(), 1e-9);
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

Wide motion(const StateVector & at, double dt_s, double rate_radps)
{
  constexpr double kStep = 1e-6;
  Wide F = Wide::Identity();
  for (int i = 0; i < kStateCount; ++i) {
    const StateVector by = kStep * StateVector::Unit(i);
    F.col(i).head<kStateCount>() =
      (moved(at + by, dt_s, rate_radps) - moved(at - by, dt_s, rate_radps)) / (2.0 * kStep);
  }
  return F;
}

// x -= T1, T0 = T1, the riser's direction likewise, edge += T1; T1 and the next riser anew.
Wide climbed(const Wide & P)
{
  Wide M = Wide::Identity();
  M(kStateX, kStateTreadAhead) = -1.0;
  M.row(kStateTreadHere) = WideVector::Unit(kStateTreadAhead).transpose();
  M.row(kStateRiserAhead) = WideVector::Unit(kStateRiserNext).transpose();
  M.row(kStateTreadAhead).setZero();
  M.row(kStateRiserNext).setZero();
  M(kEdge, kStateTreadAhead) = 1.0;
  Wide after = M * P * M.transpose();
  after(kStateTreadAhead, kStateTreadAhead) += kTreadVariance;
  after(kStateRiserNext, kStateRiserNext) += kRiserVariance;
  return after;
}

struct Mixture
{
  Expectation expectation{0.0};
  WideVector H = WideVector::Zero();
};

Mixture some_mixture(int k, std::mt19937 & random)
{
  std::normal_distribution<double> normal;
  Mixture mixture;
  for (int i = 0; i < 6; ++i) {
    const int index = (k * 7 + i * 3) % kStateCount;
    const double slope = normal(random);
    mixture.expectation.depends_on(index, slope);
    mixture.H[index] += slope;
  }
  return mixture;
}

// K is zero for the edge and for what is held.
Wide corrected(const Wide & P, const WideVector & H, double R, const Corrects & corrects)
{
  const WideVector h = P * H;
  const double S = H.dot(h) + R;
  WideVector K = WideVector::Zero();
  K.head<kStateCount>() = corrects.of(h.head<kStateCount>() / S);
  const Wide L = Wide::Identity() - K * H.transpose();
  return L * P * L.transpose() + R * K * K.transpose();
}

TEST(EdgeCovariance, IsThatOfAStateThatNothingCorrects)
{
  std::mt19937 random(11);
  ErrorStateFilter filter = some_filter(11);
  Wide P = wide(filter);
  for (int k = 0; k < 200; ++k) {
    const Mixture mixture = some_mixture(k, random);
    const Corrects corrects = k % 3 == 0 ? Corrects::all().but(kStateYaw) : Corrects::all();
    const Innovation innovation = filter.innovation(mixture.expectation, 0.01, 0.02);
    P = corrected(P, mixture.H, 0.02, corrects);
    filter.correct(mixture.expectation, innovation, corrects);
    const Wide F = motion(filter.state(), 0.01, 0.1);
    P = F * P * F.transpose();
    filter.predict(0.01, 0.1, quiet(), false);
    if (k % 20 == 19) {
      P = climbed(P);
      filter.climb(0.32, kTreadVariance, kRiserVariance);
    }
  }
  expect_equal(filter, P);
}

// Without a measurement each tread adds its own variance, and edge + x keeps what it had.
TEST(EdgeCovariance, GrowsByTheTreadsWhilePlaceInTheFlightKeepsItsDoubt)
{
  ErrorStateFilter filter = some_filter(12);
  filter.begin_edge(0.0, 0.0);
  filter.set(kStateTreadHere, 0.32, kTreadVariance);
  filter.set(kStateTreadAhead, 0.32, kTreadVariance);
  const double x_variance = filter.variance(kStateX);
  for (int step = 1; step <= 16; ++step) {
    filter.climb(0.32, kTreadVariance, kRiserVariance);
    EXPECT_NEAR(filter.edge_variance(), step * kTreadVariance, 1e-12);
    EXPECT_NEAR(
      filter.edge_variance() + 2.0 * filter.edge_covariance()[kStateX] + filter.variance(kStateX),
      x_variance, 1e-12);
  }
}

TEST(EdgeCovariance, DescendingUndoesClimbing)
{
  std::mt19937 random(13);
  ErrorStateFilter filter = some_filter(13);
  const Mixture mixture = some_mixture(3, random);
  filter.correct(mixture.expectation, filter.innovation(mixture.expectation, 0.0, 0.02));
  const double before = filter.edge_variance();
  const double with_x = filter.edge_covariance()[kStateX];
  filter.climb(0.32, kTreadVariance, kRiserVariance);
  filter.descend(0.32, kTreadVariance, kRiserVariance);
  EXPECT_NEAR(filter.edge_variance(), before, 1e-12);
  EXPECT_NEAR(filter.edge_covariance()[kStateX], with_x, 1e-12);
}

}  // namespace
}  // namespace stetro_localizer
