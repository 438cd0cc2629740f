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

#include "stetro_supervisor/profile/beam_comparison.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stetro_supervisor
{
namespace
{

/// The least cosine a wall's error is divided by: a beam along a wall has no sharp end.
constexpr double kFlattest = 0.1;

/// A beam through a wall speaks against a place like this many beams that end before one:
/// something unknown may stand anywhere, but a wall of the map is rarely gone.
constexpr double kThroughAWall = 4.0;
/// A beam off by less than this many gates missed its wall narrowly.
constexpr double kNearGates = 5.0;
/// Ranges below this many gates agree with any wall as near, and noise that ends at zero is skew.
/// The map's range is asked, not the measured one: beams chosen by their noise would all be long.
constexpr double kTooNear = 2.0;
/// Neighbouring beams end on one wall of the map if its normals differ by less than this cosine
/// (6 degrees) and the line between the ends lies in it as well, by its sine.
constexpr double kOneDirection = 0.995;
constexpr double kOnePlane = 0.1;
/// What a beam that ends before a wall takes from the evidence of that wall's direction.
constexpr double kBeforeAWall = 0.25;

double perpendicular_dot(const Eigen::Vector2d & n, const Eigen::Vector2d & d)
{
  return n.y() * d.x() - n.x() * d.y();  // n (z x d)
}

class Comparer
{
public:
  Comparer(
    const Beams & scan, const WallView & view, const BeamNoise & noise, double gate,
    BeamComparison & comparison)
  : scan_(scan), view_(view), noise_(noise), gate_(gate), to_(comparison)
  {
  }

  void run()
  {
    to_.mismatch = 0.0;
    for (std::size_t i = 0; i < scan_.size(); ++i) {
      to_.outcomes[i] = outcome(i);
    }
    if (to_.walls.size() > 1 && scan_.closed() && is_one_wall(scan_.size() - 1, 0)) {
      to_.walls.front().information += to_.walls.back().information;
      to_.walls.front().pull += to_.walls.back().pull;
      to_.walls.pop_back();
    }
    if (to_.agreeing > 0) {
      to_.chi_square /= static_cast<double>(to_.agreeing);
    }
    to_.least_direction_share = least_share();
  }

private:
  BeamOutcome outcome(std::size_t i)
  {
    const double measured = scan_.ranges_m()[i];
    const double model = view_.ranges_m()[i];
    if (!std::isfinite(measured)) {
      ++to_.silent;
      return BeamOutcome::kSilent;
    }
    const double c = std::max(view_.incidence(i), kFlattest);
    const double map_sigma = noise_.map_sigma_m / c;
    const double variance = noise_.range_sigma_m * noise_.range_sigma_m + map_sigma * map_sigma;
    const double error = measured - model;  // -inf where the map shows nothing: shorter
    const double worth = 1.0 / sharing(i, c, variance);
    const double squares = error * error / variance;
    if (squares <= gate_ * gate_) {
      if (model * model < kTooNear * kTooNear * gate_ * gate_ * variance) {
        ++to_.silent;
        return BeamOutcome::kSilent;
      }
      add_evidence(i, error, worth);
      to_.mismatch += squares * worth;
      to_.chi_square += squares;
      ++to_.agreeing;
      return BeamOutcome::kAgrees;
    }
    if (at_edge(i, measured, gate_ * std::sqrt(variance))) {
      ++to_.edges;
      return BeamOutcome::kEdge;
    }
    const bool through = error > 0.0;
    to_.mismatch += (through ? kThroughAWall : 1.0) * gate_ * gate_ * worth;
    to_.near_misses += squares <= kNearGates * kNearGates * gate_ * gate_ ? 1 : 0;
    to_.contradiction += through ? worth : 0.0;
    add_doubt(i, (through ? 1.0 : kBeforeAWall) * worth);
    ++(through ? to_.longer : to_.shorter);
    return through ? BeamOutcome::kLonger : BeamOutcome::kShorter;
  }

  /// Beams to one independent error: 1 without error of the map.
  double sharing(std::size_t i, double c, double variance) const
  {
    if (!(noise_.map_sigma_m > 0.0) || !std::isfinite(view_.ranges_m()[i])) {
      return 1.0;
    }
    const double apart = view_.ranges_m()[i] * scan_.step_rad() / c;
    const double beams = std::max(1.0, noise_.wall_correlation_m / apart);
    const double map_sigma = noise_.map_sigma_m / c;
    const double map_part = map_sigma * map_sigma / variance;
    return 1.0 + (beams - 1.0) * map_part;
  }

  bool at_edge(std::size_t i, double measured, double margin) const
  {
    const auto & model = view_.ranges_m();
    const std::size_t n = model.size();
    const double before = model[i > 0 ? i - 1 : (scan_.closed() ? n - 1 : i)];
    const double after = model[i + 1 < n ? i + 1 : (scan_.closed() ? 0 : i)];
    const auto [low, high] = std::minmax({before, model[i], after});
    return measured > low - margin && measured < high + margin;
  }

  void add_evidence(std::size_t i, double error, double worth)
  {
    const double c = view_.incidence(i);
    if (!(c > 0.0)) {
      return;
    }
    const Eigen::Vector2d & n = view_.normal(i);
    const double map_sigma = noise_.map_sigma_m;
    const double sigma = noise_.range_sigma_m * std::max(c, kFlattest);
    const double weight = worth / (sigma * sigma + map_sigma * map_sigma);
    const Eigen::Vector3d h(
      n.x(), n.y(), scan_.ranges_m()[i] * perpendicular_dot(n, scan_.directions()[i]));
    if (to_.walls.empty() || last_ + 1 != i || !is_one_wall(last_, i)) {
      to_.walls.emplace_back();
    }
    last_ = i;
    const Eigen::Matrix3d information = weight * h * h.transpose();
    const Eigen::Vector3d pull = weight * error * c * h;  // -H' w rho, as n d = -c
    to_.walls.back().information += information;
    to_.walls.back().pull += pull;
    to_.information += information;
    to_.pull += pull;
  }

  /// Two beams end on one straight wall of the map.
  bool is_one_wall(std::size_t i, std::size_t j) const
  {
    const Eigen::Vector2d & n = view_.normal(i);
    const Eigen::Vector2d apart =
      view_.ranges_m()[j] * scan_.directions()[j] - view_.ranges_m()[i] * scan_.directions()[i];
    return n.dot(view_.normal(j)) > kOneDirection &&
           std::abs(n.dot(apart)) <= kOnePlane * apart.norm();
  }

  void add_doubt(std::size_t i, double worth)
  {
    const double c = view_.incidence(i);
    if (!(c > 0.0)) {
      return;
    }
    const Eigen::Vector2d & n = view_.normal(i);
    const double sigma = noise_.range_sigma_m * std::max(c, kFlattest);
    doubting_ +=
      worth / (sigma * sigma + noise_.map_sigma_m * noise_.map_sigma_m) * n * n.transpose();
  }

  /// Least generalised eigenvalue of the agreeing evidence in all of it.
  double least_share() const
  {
    const Eigen::Matrix2d agreeing = to_.information.topLeftCorner<2, 2>();
    const Eigen::Matrix2d all = agreeing + doubting_;
    if (!(all.determinant() > 1e-9 * all.squaredNorm())) {
      return to_.agreeing_share();  // one direction of wall only: nothing to tell apart
    }
    const Eigen::Matrix2d ratio = all.inverse() * agreeing;
    const double half_trace = 0.5 * ratio.trace();
    const double root = half_trace * half_trace - ratio.determinant();
    return half_trace - std::sqrt(std::max(0.0, root));
  }

  const Beams & scan_;
  const WallView & view_;
  const BeamNoise & noise_;
  double gate_;
  BeamComparison & to_;
  std::size_t last_ = 0;  ///< beam that was evidence
  Eigen::Matrix2d doubting_ = Eigen::Matrix2d::Zero();
};

}  // namespace

void compare_beams(
  const Beams & scan, const WallView & view, const BeamNoise & noise, double gate,
  BeamComparison & comparison)
{
  std::vector<BeamOutcome> kept = std::move(comparison.outcomes);
  std::vector<WallEvidence> walls = std::move(comparison.walls);
  walls.clear();
  comparison = BeamComparison{};
  comparison.outcomes = std::move(kept);
  comparison.walls = std::move(walls);
  comparison.outcomes.resize(scan.size());
  Comparer(scan, view, noise, gate, comparison).run();
}

}  // namespace stetro_supervisor
