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

#include "stetro_supervisor/profile/determination.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn = 6.283185307179586;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A wall tells of a direction from this sine on between it and the direction (20 degrees).
constexpr double kAcross = 0.34;
/// A beam that meets its wall flatter than this tells nothing of it (80 degrees off the normal).
constexpr double kGrazing = 0.17;
/// Ends of neighbouring beams farther apart than this, in lengths of a piece, are two walls.
constexpr double kJump = 0.75;
/// A piece shorter than this, of the length asked for, has no direction.
constexpr double kShortest = 0.6;

/// A direction that no wall tells has this standard deviation [m].
constexpr double kFreeSigma = 10.0;

/// What one beam tells: the normal of its wall, the lever of the heading, and the weight of both.
struct Word
{
  Eigen::Vector3d h;
  double weight;
};

/// The ends of a profile and the straight pieces of wall they lie on.
class Pieces
{
public:
  Pieces(const std::vector<double> & ranges_m, double step_rad, const DeterminationParams & params)
  : params_(params)
  {
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
      const double angle = static_cast<double>(i) * step_rad;
      ends_.emplace_back(ranges_m[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    const double jump_m = kJump * params.piece_m;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      // false for no echo, too
      joined_.push_back((ends_[after(i)] - ends_[i]).squaredNorm() < jump_m * jump_m ? 1 : 0);
    }
  }

  /// The unit normal of the piece about an end; nothing where the ends do not lie on a line.
  [[nodiscard]] std::optional<Eigen::Vector2d> normal(std::size_t i) const
  {
    Eigen::Vector2d sum = ends_[i];
    Eigen::Matrix2d squares = ends_[i] * ends_[i].transpose();
    double count = 1.0;
    const double reach = reach_along(i, true, sum, squares, count);
    const double length = reach + reach_along(i, false, sum, squares, count);
    if (count < 3.0 || length < kShortest * params_.piece_m) {
      return std::nullopt;
    }
    const Eigen::Vector2d mean = sum / count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(squares / count - mean * mean.transpose());
    if (axes.eigenvalues()(0) > params_.bent_m * params_.bent_m) {
      return std::nullopt;
    }
    return axes.eigenvectors().col(0);
  }

  [[nodiscard]] const Eigen::Vector2d & end(std::size_t i) const { return ends_[i]; }

private:
  /// Adds the ends of one side up to half a piece away. \return how far the last one is [m]
  double reach_along(
    std::size_t i, bool forward, Eigen::Vector2d & sum, Eigen::Matrix2d & squares,
    double & count) const
  {
    const double half_m2 = 0.25 * params_.piece_m * params_.piece_m;
    double reach_m2 = 0.0;
    std::size_t at = i;
    for (std::size_t k = 1; k < ends_.size() / 2; ++k) {
      const std::size_t next = forward ? after(at) : before(at);
      const double distance_m2 = (ends_[next] - ends_[i]).squaredNorm();
      const bool joined = joined_[forward ? at : next] != 0;
      if (!joined || (distance_m2 > half_m2 && k > 1)) {
        break;
      }
      sum += ends_[next];
      squares += ends_[next] * ends_[next].transpose();
      count += 1.0;
      reach_m2 = distance_m2;
      at = next;
    }
    return std::sqrt(reach_m2);
  }

  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < ends_.size() ? i + 1 : 0; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return (i > 0 ? i : ends_.size()) - 1; }

  const DeterminationParams & params_;
  std::vector<Eigen::Vector2d> ends_;
  std::vector<char> joined_;  ///< on one piece with the next
};

std::vector<Word> words_of(
  const std::vector<double> & ranges_m, double step_rad, const DeterminationParams & params)
{
  const Pieces pieces(ranges_m, step_rad, params);
  std::vector<Word> words;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    if (!std::isfinite(ranges_m[i]) || !(ranges_m[i] > 0.0)) {
      continue;
    }
    const auto n = pieces.normal(i);
    const Eigen::Vector2d d = pieces.end(i) / ranges_m[i];
    const double c = n ? std::abs(n->dot(d)) : 0.0;
    if (c < kGrazing) {
      continue;
    }
    const BeamNoise & noise = params.noise;
    const double apart = ranges_m[i] * step_rad / c;
    const double sharing = std::max(1.0, noise.wall_correlation_m / apart);
    const double sigma = c * noise.range_sigma_m;
    const double variance = sigma * sigma + sharing * noise.map_sigma_m * noise.map_sigma_m;
    const double lever = ranges_m[i] * (n->y() * d.x() - n->x() * d.y());
    words.push_back({{n->x(), n->y(), lever}, 1.0 / variance});
  }
  return words;
}

/// Information along a direction by the walls that stand across it.
double told_across(const std::vector<Word> & words, const Eigen::Vector2d & direction)
{
  double sum = 0.0;
  for (const Word & word : words) {
    const double across = word.h.head<2>().dot(direction);
    sum += std::abs(across) > kAcross ? word.weight * across * across : 0.0;
  }
  return sum;
}

}  // namespace

Determination determination(
  const stetro_site::ProfileCaster & map, const Eigen::Vector2d & position_m,
  const DeterminationParams & params)
{
  const double step = kTurn / static_cast<double>(params.beams);
  std::vector<double> ranges_m;
  map.cast(position_m, {0.0, step, params.beams}, params.reach_m, ranges_m);
  const auto words = words_of(ranges_m, step, params);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  information(2, 2) = 1.0 / (params.yaw_sigma_rad * params.yaw_sigma_rad);
  for (const Word & word : words) {
    information += word.weight * word.h * word.h.transpose();
  }
  // The heading is not asked for: what is left of the position's information (Schur).
  const Eigen::Vector2d shared = information.topRightCorner<2, 1>();
  const Eigen::Matrix2d position =
    information.topLeftCorner<2, 2>() - shared * shared.transpose() / information(2, 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position);
  Determination found;
  found.worst_direction = axes.eigenvectors().col(0);
  const double least = std::min(axes.eigenvalues()(0), told_across(words, found.worst_direction));
  found.worst_sigma_m = least > 0.0 ? 1.0 / std::sqrt(least) : kInfinity;
  const Eigen::Vector2d best = axes.eigenvectors().col(1);
  found.covariance = found.worst_sigma_m * found.worst_sigma_m * found.worst_direction *
                       found.worst_direction.transpose() +
                     best * best.transpose() / std::max(axes.eigenvalues()(1), 1e-12);
  return found;
}

Eigen::Matrix3d widened(
  Eigen::Matrix3d covariance, const Determination & told, double determined_sigma_m)
{
  if (told.worst_sigma_m > determined_sigma_m) {
    const Eigen::Vector2d & u = told.worst_direction;
    auto position = covariance.topLeftCorner<2, 2>();
    const double sigma = std::min(told.worst_sigma_m, kFreeSigma);
    const double missing = sigma * sigma - u.dot(position * u);
    position += std::max(0.0, missing) * u * u.transpose();
  }
  return covariance;
}

Eigen::Matrix3d stretched(Eigen::Matrix3d covariance, const Determination & told)
{
  const Eigen::Vector2d & u = told.worst_direction;
  const Eigen::Vector2d v(-u.y(), u.x());
  const Eigen::Matrix2d position = covariance.topLeftCorner<2, 2>();
  const double worse = told.worst_sigma_m * told.worst_sigma_m / v.dot(told.covariance * v);
  const double variance = std::min(worse * v.dot(position * v), kFreeSigma * kFreeSigma);
  const double missing = std::max(0.0, variance - u.dot(position * u));
  covariance.topLeftCorner<2, 2>() += missing * u * u.transpose();
  return covariance;
}

}  // namespace stetro_supervisor
