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

#include "stetro_localizer/floor/floor_filter.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "stetro_site/frame_transform.hpp"

namespace stetro_localizer
{
namespace
{

// What rounding leaves of asymmetry would grow.
void symmetrise(FloorMatrix & matrix) { matrix = (0.5 * (matrix + matrix.transpose())).eval(); }

}  // namespace

FloorMatrix turned(const FloorMatrix & covariance, double angle_rad)
{
  FloorMatrix jacobian = FloorMatrix::Identity();
  jacobian(kFloorX, kFloorX) = jacobian(kFloorY, kFloorY) = std::cos(angle_rad);
  jacobian(kFloorX, kFloorY) = -std::sin(angle_rad);
  jacobian(kFloorY, kFloorX) = std::sin(angle_rad);
  return jacobian * covariance * jacobian.transpose();
}

double chi_square_3_quantile(double probability)
{
  double low = 0.0;
  double high = 200.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2.0;
    const double beyond =
      std::erfc(std::sqrt(middle / 2.0)) + std::sqrt(2.0 * middle / M_PI) * std::exp(-middle / 2.0);
    (beyond > probability ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

double FixInnovation::nis() const { return value.dot(covariance.ldlt().solve(value)); }

void FloorFilter::set(const FloorVector & state, const FloorMatrix & covariance)
{
  x_ = state;
  x_[kFloorYaw] = stetro_site::wrap_angle(x_[kFloorYaw]);
  P_ = covariance;
}

void FloorFilter::set_pose(const PoseFix & fix)
{
  x_.head<3>() = fix.pose;
  P_.topRows<3>().setZero();
  P_.leftCols<3>().setZero();
  P_.topLeftCorner<3, 3>() = fix.covariance;
}

void FloorFilter::roll(double dt_s, double ux_mps, double uy_mps, double along, double across)
{
  const double c = std::cos(x_[kFloorYaw]);
  const double s = std::sin(x_[kFloorYaw]);
  const double share = 1.0 / (1.0 + x_[kFloorOdomScale]);
  const double dx_m = (ux_mps * c - uy_mps * s) * share * dt_s;
  const double dy_m = (ux_mps * s + uy_mps * c) * share * dt_s;
  x_[kFloorX] += dx_m;
  x_[kFloorY] += dy_m;

  FloorMatrix F = FloorMatrix::Identity();
  F(kFloorX, kFloorYaw) = -dy_m;
  F(kFloorY, kFloorYaw) = dx_m;
  F(kFloorX, kFloorOdomScale) = -dx_m * share;
  F(kFloorY, kFloorOdomScale) = -dy_m * share;
  P_ = (F * P_ * F.transpose()).eval();

  const double way_m = std::hypot(dx_m, dy_m);
  if (way_m > 0.0) {
    const Eigen::Vector2d ahead(dx_m / way_m, dy_m / way_m);
    const Eigen::Vector2d aside(-ahead.y(), ahead.x());
    P_.topLeftCorner<2, 2>() += dt_s * along * along * ahead * ahead.transpose() +
                                dt_s * across * across * aside * aside.transpose();
  }
  symmetrise(P_);
}

void FloorFilter::turn(double dt_s, double rate_radps, double density)
{
  x_[kFloorYaw] = stetro_site::wrap_angle(x_[kFloorYaw] + (rate_radps - x_[kFloorGyroBias]) * dt_s);
  P_.col(kFloorYaw) -= dt_s * P_.col(kFloorGyroBias);
  P_.row(kFloorYaw) -= dt_s * P_.row(kFloorGyroBias);
  P_(kFloorYaw, kFloorYaw) += dt_s * density * density;
}

void FloorFilter::wander(double dt_s, const FloorNoise & noise)
{
  P_(kFloorGyroBias, kFloorGyroBias) += dt_s * noise.gyro_bias * noise.gyro_bias;
  P_(kFloorOdomScale, kFloorOdomScale) += dt_s * noise.odom_scale * noise.odom_scale;
}

bool FloorFilter::stand(double rate_radps, double variance, double gate)
{
  const double innovation = rate_radps - x_[kFloorGyroBias];
  const double innovation_variance = P_(kFloorGyroBias, kFloorGyroBias) + variance;
  if (innovation * innovation > gate * innovation_variance) {
    return false;
  }
  const FloorVector h = P_.col(kFloorGyroBias);
  x_ += h * (innovation / innovation_variance);
  x_[kFloorYaw] = stetro_site::wrap_angle(x_[kFloorYaw]);
  P_ -= h * h.transpose() / innovation_variance;
  return true;
}

FixInnovation FloorFilter::innovation(const PoseFix & fix) const
{
  FixInnovation innovation;
  innovation.value = fix.pose - x_.head<3>();
  innovation.value.z() = stetro_site::wrap_angle(innovation.value.z());
  innovation.covariance = P_.topLeftCorner<3, 3>() + fix.covariance;
  return innovation;
}

void FloorFilter::correct(const PoseFix & fix)
{
  const FixInnovation nu = innovation(fix);
  // K S = P H^T, S symmetric: solved as S K^T = H P.
  const Eigen::Matrix<double, 3, kFloorCount> HP = P_.topRows<3>();
  const Eigen::Matrix<double, kFloorCount, 3> K = nu.covariance.ldlt().solve(HP).transpose();
  x_ += K * nu.value;
  x_[kFloorYaw] = stetro_site::wrap_angle(x_[kFloorYaw]);
  FloorMatrix A = FloorMatrix::Identity();
  A.leftCols<3>() -= K;
  P_ = (A * P_ * A.transpose() + K * fix.covariance * K.transpose()).eval();
  symmetrise(P_);
}

}  // namespace stetro_localizer
