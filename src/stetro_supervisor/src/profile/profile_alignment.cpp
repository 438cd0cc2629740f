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

#include "stetro_supervisor/profile/profile_alignment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

/// A wall contradicts the others if the place moves without it by more than this many of the
/// standard deviations that the others leave.
constexpr double kContradiction = 2.0;
constexpr double kSmallPart = 0.25;

/// The covariance. A known heading has none, and its row and column count for nothing.
std::optional<Eigen::Matrix3d> inverse(Eigen::Matrix3d information, const HeadingPrior & prior)
{
  if (!(prior.sigma_rad > 0.0)) {
    const Eigen::Matrix2d position = information.topLeftCorner<2, 2>();
    if (!(position.determinant() > 1e-9 * position.squaredNorm())) {
      return std::nullopt;
    }
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
    inverse.topLeftCorner<2, 2>() = position.inverse();
    return inverse;
  }
  information(2, 2) += 1.0 / (prior.sigma_rad * prior.sigma_rad);
  const Eigen::LDLT<Eigen::Matrix3d> factors(information);
  if (factors.info() != Eigen::Success || !(factors.vectorD().minCoeff() > 0.0)) {
    return std::nullopt;
  }
  const Eigen::Matrix3d inverse = factors.solve(Eigen::Matrix3d::Identity());
  return inverse.allFinite() ? std::optional(inverse) : std::nullopt;
}

Eigen::Vector3d prior_pull(const HeadingPrior & prior, double yaw_rad)
{
  if (!(prior.sigma_rad > 0.0)) {
    return Eigen::Vector3d::Zero();
  }
  const double variance = prior.sigma_rad * prior.sigma_rad;
  return {0.0, 0.0, stetro_site::wrap_angle(prior.yaw_rad - yaw_rad) / variance};
}

/// The covariance that walls which contradict the others ask for, each left out in its turn.
Eigen::Matrix3d doubt_of_walls(
  const BeamComparison & comparison, const HeadingPrior & prior, const SettledStep & settled)
{
  Eigen::Matrix3d doubt = Eigen::Matrix3d::Zero();
  for (const WallEvidence & wall : comparison.walls) {
    // What is left of the wall's pull at the place that all walls agreed upon.
    const Eigen::Vector3d left = wall.pull - wall.information * settled.step;
    // A wall with the part p of what is known, at most, leaves others no worse than C / (1 - p).
    const double part = settled.covariance.cwiseProduct(wall.information).sum();
    const double moves = left.dot(settled.covariance * left);
    if (part < kSmallPart && moves < (1.0 - kSmallPart) * kContradiction * kContradiction) {
      continue;
    }
    const auto others = inverse(comparison.information - wall.information, prior);
    if (!others) {
      continue;  // nothing else tells of that direction, and nothing contradicts
    }
    const Eigen::Vector3d shift = *others * left;
    // With A the others' information, shift' A shift.
    if (left.dot(shift) > kContradiction * kContradiction) {
      doubt += shift * shift.transpose();
    }
  }
  return doubt;
}

}  // namespace

ScannerPose moved(const ScannerPose & pose, const Eigen::Vector3d & step)
{
  return {
    pose.position_m + rotation(pose.yaw_rad) * step.head<2>(),
    stetro_site::wrap_angle(pose.yaw_rad + step.z())};
}

std::optional<Eigen::Vector3d> ProfileAlignment::step(
  const Beams & scan, const WallView & view, const HeadingPrior & prior, double yaw_rad)
{
  const std::size_t n = scan.size();
  distances_.assign(n, 0.0);
  sorted_.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const double measured = scan.ranges_m()[i];
    if (view.incidence(i) > 0.0 && std::isfinite(measured)) {
      distances_[i] = (view.ranges_m()[i] - measured) * view.incidence(i);
      sorted_.push_back(std::abs(distances_[i]));
    }
  }
  if (sorted_.size() < 8) {
    return std::nullopt;
  }
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  fits_ = 2.0 * *middle <= finest_m_;
  scale_m_ = std::max({2.0 * *middle, kSlowest * scale_m_, finest_m_});
  const double scale = scale_m_;
  const double inverse_square = 1.0 / (scale * scale);

  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = prior_pull(prior, yaw_rad);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(view.incidence(i) > 0.0) || !std::isfinite(scan.ranges_m()[i])) {
      continue;
    }
    const double rho = distances_[i];
    const double damping = 1.0 + rho * rho * inverse_square;
    const double factor = factors_.empty() ? 1.0 : factors_[i];
    const double weight = factor * inverse_square / (damping * damping);
    const Eigen::Vector2d & normal = view.normal(i);
    const Eigen::Vector2d & d = scan.directions()[i];
    const Eigen::Vector3d h(
      normal.x(), normal.y(), scan.ranges_m()[i] * (normal.y() * d.x() - normal.x() * d.y()));
    information += weight * h * h.transpose();
    pull -= weight * rho * h;
  }
  const auto covariance = inverse(information, prior);
  return covariance ? std::optional<Eigen::Vector3d>(*covariance * pull) : std::nullopt;
}

std::optional<SettledStep> settled_step(
  const BeamComparison & comparison, const HeadingPrior & prior, double yaw_rad)
{
  const auto covariance = inverse(comparison.information, prior);
  if (!covariance) {
    return std::nullopt;
  }
  SettledStep settled;
  settled.step = *covariance * (comparison.pull + prior_pull(prior, yaw_rad));
  settled.covariance = *covariance;
  settled.doubt = doubt_of_walls(comparison, prior, settled);
  return settled;
}

}  // namespace stetro_supervisor
