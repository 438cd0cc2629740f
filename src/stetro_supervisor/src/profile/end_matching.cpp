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

#include "stetro_supervisor/profile/end_matching.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

/// A distance beyond this is not asked for: the end lies on nothing that is known [m].
constexpr double kFar = 1.0;
/// Scales s of a refinement, of `on_wall_m`, from the first step to the last.
constexpr double kFirstScale = 3.0;
constexpr double kLastScale = 0.7;

std::vector<Eigen::Vector2d> ends_of(const Beams & scan, double reach_m)
{
  std::vector<Eigen::Vector2d> ends;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const double range = scan.ranges_m()[i];
    if (range > 0.0 && range < reach_m) {
      ends.push_back(range * scan.directions()[i]);
    }
  }
  return ends;
}

}  // namespace

EndMatching::EndMatching(
  std::shared_ptr<const stetro_site::DistanceField> walls, const EndMatchingParams & params)
: walls_(std::move(walls)), params_(params)
{
  if (!walls_) {
    throw std::invalid_argument("end matching: there is no field of distances");
  }
}

Eigen::Vector3d EndMatching::field_at(const Eigen::Vector2d & point_m) const
{
  const auto & grid = walls_->grid();
  const Eigen::Vector2d at = grid.to_cells(point_m) - Eigen::Vector2d(0.5, 0.5);
  const Eigen::Vector2d low(std::floor(at.x()), std::floor(at.y()));
  if (
    !(low.minCoeff() >= 0.0) || !(low.x() + 2.0 <= grid.columns()) ||
    !(low.y() + 2.0 <= grid.rows())) {
    return {kFar, 0.0, 0.0};
  }
  const int column = static_cast<int>(low.x());
  const int row = static_cast<int>(low.y());
  const double d00 = walls_->distance_m({column, row});
  const double d10 = walls_->distance_m({column + 1, row});
  const double d01 = walls_->distance_m({column, row + 1});
  const double d11 = walls_->distance_m({column + 1, row + 1});
  const double u = at.x() - low.x();
  const double v = at.y() - low.y();
  const double distance = (1.0 - v) * ((1.0 - u) * d00 + u * d10) + v * ((1.0 - u) * d01 + u * d11);
  const Eigen::Vector2d slope(
    (1.0 - v) * (d10 - d00) + v * (d11 - d01), (1.0 - u) * (d01 - d00) + u * (d11 - d10));
  const Eigen::Vector2d gradient = rotation(grid.frame().yaw_rad) * slope / grid.resolution_m();
  return {std::min(distance, kFar), gradient.x(), gradient.y()};
}

double EndMatching::quick_likelihood(
  const std::vector<Eigen::Vector2d> & ends, const ScannerPose & pose) const
{
  const auto & grid = walls_->grid();
  const Eigen::Matrix2d turn = rotation(pose.yaw_rad);
  const double inverse_square = 1.0 / (params_.on_wall_m * params_.on_wall_m);
  double sum = 0.0;
  for (const auto & end : ends) {
    const auto cell = grid.cell_at(pose.position_m + turn * end);
    if (grid.contains(cell)) {
      const double distance = walls_->distance_m(cell);
      sum += 1.0 / (1.0 + distance * distance * inverse_square);
    }
  }
  return sum / static_cast<double>(ends.size());
}

EndMatch EndMatching::rated(
  const std::vector<Eigen::Vector2d> & ends, const ScannerPose & pose, double step_rad) const
{
  EndMatch match;
  match.pose = pose;
  const Eigen::Matrix2d turn = rotation(pose.yaw_rad);
  const double scale = kLastScale * params_.on_wall_m;
  const double range_variance = params_.noise.range_sigma_m * params_.noise.range_sigma_m;
  const double map_variance = params_.noise.map_sigma_m * params_.noise.map_sigma_m;
  for (const auto & end : ends) {
    const Eigen::Vector2d arm = turn * end;
    const Eigen::Vector3d field = field_at(pose.position_m + arm);
    const double ratio = field.x() / params_.on_wall_m;
    match.likelihood += 1.0 / (1.0 + ratio * ratio);
    match.on_wall_share += ratio <= 1.0 ? 1.0 : 0.0;
    const double damping = 1.0 + field.x() * field.x() / (scale * scale);
    const Eigen::Vector3d h(field.y(), field.z(), field.z() * arm.x() - field.y() * arm.y());
    // Ends within the length over which the map errs alike share one error of it.
    const double apart = arm.norm() * step_rad;
    const double sharing = std::max(1.0, params_.noise.wall_correlation_m / apart);
    const double variance = range_variance + sharing * map_variance;
    match.information += h * h.transpose() / (damping * damping * variance);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, ends.size()));
  match.likelihood /= count;
  match.on_wall_share /= count;
  return match;
}

EndMatch EndMatching::refined(
  const std::vector<Eigen::Vector2d> & ends, const ScannerPose & from, double step_rad) const
{
  ScannerPose at = from;
  for (int i = 0; i < params_.steps; ++i) {
    const double part = static_cast<double>(i) / std::max(1, params_.steps - 1);
    const double scale =
      params_.on_wall_m * (kFirstScale + (kLastScale - kFirstScale) * std::min(1.0, 1.5 * part));
    const Eigen::Matrix2d turn = rotation(at.yaw_rad);
    // A little stiffness: what no wall tells stays where it is.
    Eigen::Matrix3d information = Eigen::Vector3d(1e-2, 1e-2, 1e-2).asDiagonal();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const auto & end : ends) {
      const Eigen::Vector2d arm = turn * end;
      const Eigen::Vector3d field = field_at(at.position_m + arm);
      const double damping = 1.0 + field.x() * field.x() / (scale * scale);
      const double weight = 1.0 / (damping * damping);
      const Eigen::Vector3d h(field.y(), field.z(), field.z() * arm.x() - field.y() * arm.y());
      information += weight * h * h.transpose();
      pull -= weight * field.x() * h;
    }
    const Eigen::Vector3d step = information.ldlt().solve(pull);
    at.position_m += step.head<2>();
    at.yaw_rad = stetro_site::wrap_angle(at.yaw_rad + step.z());
  }
  return rated(ends, at, step_rad);
}

std::vector<EndMatch> EndMatching::matches(
  const Beams & scan, const SearchArea & area, double reach_m) const
{
  const auto few = ends_of(scan.thinned(params_.beams), reach_m);
  const auto all = ends_of(scan, reach_m);
  if (few.empty()) {
    return {};
  }
  const int half = static_cast<int>(area.radius_m / params_.spacing_m);
  const int turns = static_cast<int>(std::ceil(area.yaw_half_width_rad / params_.turn_rad));
  std::vector<std::pair<double, ScannerPose>> places;
  for (int k = -turns; k <= turns; ++k) {
    for (int row = -half; row <= half; ++row) {
      for (int column = -half; column <= half; ++column) {
        const Eigen::Vector2d offset = params_.spacing_m * Eigen::Vector2d(column, row);
        if (offset.norm() <= area.radius_m) {
          const ScannerPose pose{
            area.around.position_m + offset, area.around.yaw_rad + k * params_.turn_rad};
          places.emplace_back(quick_likelihood(few, pose), pose);
        }
      }
    }
  }
  std::sort(
    places.begin(), places.end(), [](const auto & a, const auto & b) { return a.first > b.first; });
  const auto is_near = [this](const ScannerPose & a, const ScannerPose & b) {
    return (a.position_m - b.position_m).norm() < params_.apart_m;
  };
  std::vector<ScannerPose> starts;
  for (const auto & [likelihood, pose] : places) {
    const auto near = std::count_if(
      starts.begin(), starts.end(), [&, here = pose](const auto & p) { return is_near(p, here); });
    if (near < 2) {
      starts.push_back(pose);
    }
    if (starts.size() == params_.kept) {
      break;
    }
  }
  std::vector<EndMatch> found;
  for (const auto & start : starts) {
    found.push_back(refined(all, start, scan.step_rad()));
  }
  std::sort(found.begin(), found.end(), [](const auto & a, const auto & b) {
    return a.likelihood > b.likelihood;
  });
  std::vector<EndMatch> best;
  for (const auto & match : found) {
    const bool known = std::any_of(best.begin(), best.end(), [&](const EndMatch & other) {
      return is_near(match.pose, other.pose);
    });
    if (!known) {
      best.push_back(match);
    }
  }
  return best;
}

}  // namespace stetro_supervisor
