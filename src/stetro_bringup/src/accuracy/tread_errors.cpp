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

#include "accuracy/tread_errors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <type_traits>

#include "stetro_site/frame_transform.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_driver::GroundTruth;

using stetro_localizer::kUnknown;

double or_else(double told, double otherwise) { return std::isnan(told) ? otherwise : told; }

/// From base_link to the riser ahead by the estimate's own word, if it gives one.
template <class Estimate, class = void>
struct RiserAheadOf
{
  static double read(const Estimate &) { return stetro_localizer::kUnknown; }
};

template <class Estimate>
struct RiserAheadOf<Estimate, std::void_t<decltype(Estimate::riser_ahead_m)>>
{
  static double read(const Estimate & estimate) { return estimate.riser_ahead_m; }
};

}  // namespace

TreadErrors errors_of(
  const stetro_localizer::StairEstimate & estimate, const GroundTruth & truth,
  const stetro_site::Flight & flight)
{
  const int step = truth.step;
  const bool own_tread = estimate.step == step;
  const double told_ahead_m =
    own_tread ? RiserAheadOf<stetro_localizer::StairEstimate>::read(estimate) : kUnknown;
  const double told_behind_m = own_tread ? estimate.tread_x_m : kUnknown;

  TreadErrors errors{};
  const double tread_start_m = step > 0 ? flight.tread_start_m(step) : kUnknown;
  errors.x_behind_m = or_else(told_behind_m, estimate.pose.x_m - tread_start_m) - truth.tread_x_m;
  errors.x_m = errors.x_behind_m;
  if (step < flight.steps()) {
    const double tread_end_m = step > 0 ? flight.tread_end_m(step) : 0.0;
    errors.x_m = truth.riser_ahead_m - or_else(told_ahead_m, tread_end_m - estimate.pose.x_m);
  }
  errors.y_m = estimate.pose.y_m - truth.y_m;
  const double told_block2_m = or_else(estimate.block_heights_m[1], estimate.pose.z_m);
  errors.z_m = told_block2_m - flight.tread_z_m(step) - (truth.block_heights_m[1] - truth.z_m);
  errors.heading_rad = stetro_site::wrap_angle(estimate.pose.yaw_rad - truth.yaw_rad);
  errors.heading_to_riser_rad = stetro_site::wrap_angle(estimate.pose.yaw_rad - truth.heading_rad);
  errors.flight_x_m = estimate.pose.x_m - truth.x_m;
  errors.flight_z_m = estimate.pose.z_m - truth.z_m;
  return errors;
}

double nees_of(const TreadErrors & errors, const stetro_site::Covariance & covariance)
{
  const Eigen::Matrix3d p = stetro_site::planar(covariance);
  const Eigen::Vector3d e{errors.x_m, errors.y_m, errors.heading_rad};
  const Eigen::LLT<Eigen::Matrix3d> factor(p);
  if (!e.allFinite() || !p.allFinite() || factor.info() != Eigen::Success) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return e.dot(factor.solve(e));
}

}  // namespace stetro_bringup
