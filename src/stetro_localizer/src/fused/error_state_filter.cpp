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

#include "stetro_localizer/fused/error_state_filter.hpp"

#include <array>
#include <cmath>

namespace stetro_localizer
{
namespace
{

double squared(double value) { return value * value; }

// What is kept for the next time, in the order of `FusedCalibration`.
constexpr std::array<int, FusedCalibration::kSize> kKept{
  offset_index(Ranger::kSideLeft),
  gain_index(Ranger::kSideLeft),
  offset_index(Ranger::kSideRight),
  gain_index(Ranger::kSideRight),
  offset_index(Ranger::kFrontLeft),
  gain_index(Ranger::kFrontLeft),
  offset_index(Ranger::kFrontRight),
  gain_index(Ranger::kFrontRight),
  offset_index(Ranger::kBlock3Front),
  gain_index(Ranger::kBlock3Front),
  int{kStateOdomScale}};

}  // namespace

void ErrorStateFilter::set(int index, double value, double variance)
{
  x_[index] = value;
  P_.row(index).setZero();
  P_.col(index).setZero();
  P_(index, index) = variance;
  edge_covariance_[index] = 0.0;
}

void ErrorStateFilter::begin_edge(double variance, double of_tread_here)
{
  edge_variance_ = variance;
  edge_covariance_.setZero();
  edge_covariance_[kStateTreadHere] = of_tread_here;
}

void ErrorStateFilter::predict(
  double dt_s, double rate_radps, const ProcessNoise & noise, bool slipping)
{
  const double c = std::cos(x_[kStateYaw]);
  const double s = std::sin(x_[kStateYaw]);
  const double forward_m = (x_[kStateVx] * c - x_[kStateVy] * s) * dt_s;
  const double leftward_m = (x_[kStateVx] * s + x_[kStateVy] * c) * dt_s;
  x_[kStateX] += forward_m;
  x_[kStateY] += leftward_m;
  x_[kStateYaw] += (rate_radps - x_[kStateGyroBias]) * dt_s;

  // F is the identity but for three rows; F P F^T touches three columns, then three rows.
  P_.col(kStateX) +=
    -leftward_m * P_.col(kStateYaw) + dt_s * (c * P_.col(kStateVx) - s * P_.col(kStateVy));
  P_.col(kStateY) +=
    forward_m * P_.col(kStateYaw) + dt_s * (s * P_.col(kStateVx) + c * P_.col(kStateVy));
  P_.col(kStateYaw) -= dt_s * P_.col(kStateGyroBias);
  P_.row(kStateX) +=
    -leftward_m * P_.row(kStateYaw) + dt_s * (c * P_.row(kStateVx) - s * P_.row(kStateVy));
  P_.row(kStateY) +=
    forward_m * P_.row(kStateYaw) + dt_s * (s * P_.row(kStateVx) + c * P_.row(kStateVy));
  P_.row(kStateYaw) -= dt_s * P_.row(kStateGyroBias);
  for (const int i : {kStateX, kStateY, kStateYaw}) {
    P_.row(i) = P_.col(i).transpose();  // rounding differs by the order: symmetric by decree
  }
  StateVector & edge = edge_covariance_;  // a column more, of a state that does not move
  edge[kStateX] += -leftward_m * edge[kStateYaw] + dt_s * (c * edge[kStateVx] - s * edge[kStateVy]);
  edge[kStateY] += forward_m * edge[kStateYaw] + dt_s * (s * edge[kStateVx] + c * edge[kStateVy]);
  edge[kStateYaw] -= dt_s * edge[kStateGyroBias];
  add_noise(dt_s, noise, slipping);
}

void ErrorStateFilter::add_noise(double dt_s, const ProcessNoise & noise, bool slipping)
{
  const double c = std::cos(x_[kStateYaw]);
  const double s = std::sin(x_[kStateYaw]);
  P_(kStateYaw, kStateYaw) += squared(noise.turn) * dt_s;
  P_(kStateGyroBias, kStateGyroBias) += squared(noise.gyro_bias) * dt_s;
  P_(kStateX, kStateX) += squared(noise.creep) * dt_s;
  P_(kStateY, kStateY) += squared(noise.creep) * dt_s;
  if (slipping) {
    const double speed = std::hypot(x_[kStateVx], x_[kStateVy]);
    const double along_x = speed > 0.0 ? (x_[kStateVx] * c - x_[kStateVy] * s) / speed : 0.0;
    const double along_y = speed > 0.0 ? (x_[kStateVx] * s + x_[kStateVy] * c) / speed : 0.0;
    const double variance = squared(noise.slip) * dt_s;
    P_(kStateX, kStateX) += variance * along_x * along_x;
    P_(kStateY, kStateY) += variance * along_y * along_y;
    P_(kStateX, kStateY) += variance * along_x * along_y;
    P_(kStateY, kStateX) += variance * along_x * along_y;
    P_(kStateOdomScale, kStateOdomScale) += squared(noise.odom_scale) * dt_s;
  }
  for (int i = kStateFirstCalibration; i < kStateCount; i += 2) {
    P_(i, i) += squared(noise.range_offset) * dt_s;
    P_(i + 1, i + 1) += squared(noise.range_gain) * dt_s;
  }
}

Innovation ErrorStateFilter::innovation(
  const Expectation & expectation, double measured, double variance) const
{
  double spread = 0.0;
  for (const auto & a : expectation) {
    for (const auto & b : expectation) {
      spread += a.slope * b.slope * P_(a.index, b.index);
    }
  }
  return {measured - expectation.value(), spread + variance};
}

// Joseph's form for one scalar and the optimal gain, written out: with h = P H^T it is
// P - h h^T / S, symmetric to the last bit. Rows of considered states have gain zero, and what
// stands between two of them keeps its value.
void ErrorStateFilter::correct(
  const Expectation & expectation, const Innovation & innovation, const Corrects & corrects)
{
  StateVector h = StateVector::Zero();
  double of_edge = 0.0;
  for (const auto & entry : expectation) {
    h += entry.slope * P_.col(entry.index);
    of_edge += entry.slope * edge_covariance_[entry.index];
  }
  h /= std::sqrt(innovation.variance);
  const StateVector k = corrects.of(h);
  edge_covariance_ -= k * (of_edge / std::sqrt(innovation.variance));
  x_ += k * (innovation.value / std::sqrt(innovation.variance));
  P_.noalias() -= k * h.transpose();
  P_.noalias() -= (h - k) * k.transpose();
}

void ErrorStateFilter::copy_row(int to, int from)
{
  x_[to] = x_[from];
  P_.col(to) = P_.col(from);
  P_.row(to) = P_.row(from);
  P_(to, to) = P_(from, from);
  edge_covariance_[to] = edge_covariance_[from];
}

FusedCalibration ErrorStateFilter::calibration() const
{
  FusedCalibration kept;
  for (std::size_t i = 0; i < kKept.size(); ++i) {
    kept.value[i] = x_[kKept[i]];
    for (std::size_t j = 0; j < kKept.size(); ++j) {
      kept.covariance[i][j] = P_(kKept[i], kKept[j]);
    }
  }
  return kept;
}

void ErrorStateFilter::set_calibration(const FusedCalibration & calibration)
{
  for (std::size_t i = 0; i < kKept.size(); ++i) {
    set(kKept[i], calibration.value[i], 0.0);
  }
  for (std::size_t i = 0; i < kKept.size(); ++i) {
    for (std::size_t j = 0; j < kKept.size(); ++j) {
      P_(kKept[i], kKept[j]) = calibration.covariance[i][j];
    }
  }
}

void ErrorStateFilter::climb(double tread_m, double tread_variance, double riser_variance)
{
  edge_variance_ +=
    P_(kStateTreadAhead, kStateTreadAhead) + 2.0 * edge_covariance_[kStateTreadAhead];
  edge_covariance_ += P_.col(kStateTreadAhead);
  edge_covariance_[kStateX] -= edge_covariance_[kStateTreadAhead];
  x_[kStateX] -= x_[kStateTreadAhead];
  P_.col(kStateX) -= P_.col(kStateTreadAhead);
  P_.row(kStateX) -= P_.row(kStateTreadAhead);
  copy_row(kStateTreadHere, kStateTreadAhead);
  copy_row(kStateRiserAhead, kStateRiserNext);
  set(kStateTreadAhead, tread_m, tread_variance);
  set(kStateRiserNext, 0.0, riser_variance);
}

void ErrorStateFilter::descend(double tread_m, double tread_variance, double riser_variance)
{
  edge_variance_ += P_(kStateTreadHere, kStateTreadHere) - 2.0 * edge_covariance_[kStateTreadHere];
  edge_covariance_ -= P_.col(kStateTreadHere);
  edge_covariance_[kStateX] += edge_covariance_[kStateTreadHere];
  x_[kStateX] += x_[kStateTreadHere];
  P_.col(kStateX) += P_.col(kStateTreadHere);
  P_.row(kStateX) += P_.row(kStateTreadHere);
  copy_row(kStateTreadAhead, kStateTreadHere);
  copy_row(kStateRiserNext, kStateRiserAhead);
  set(kStateTreadHere, tread_m, tread_variance);
  set(kStateRiserAhead, 0.0, riser_variance);
}

}  // namespace stetro_localizer
