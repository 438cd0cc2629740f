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

#ifndef STETRO_SITE__FRAME_TRANSFORM_HPP_
#define STETRO_SITE__FRAME_TRANSFORM_HPP_

#include <Eigen/Core>

#include "stetro_site/pose.hpp"

namespace stetro_site
{

/// 6x6 covariance of (x, y, z, roll, pitch, yaw) in the order and axes of ROS: rotations about the
/// fixed axes of the frame the pose is given in [m, rad].
using Covariance = Eigen::Matrix<double, 6, 6>;

/// The part of (x, y, yaw), in that order.
[[nodiscard]] Eigen::Matrix3d planar(const Covariance & covariance);

/// Puts the part of (x, y, yaw) in its place, and leaves the rest as it is.
void set_planar(Covariance & covariance, const Eigen::Matrix3d & planar);

/// The same angle in [-pi, pi].
[[nodiscard]] double wrap_angle(double angle_rad);

/// Takes poses between a frame of the building (a flight, a floor) and `map`, `T_map_frame`.
/**
 * Both frames have z up, so with the frame's pose (o, alpha) in `map`
 *
 *   p_map = o + Rz(alpha) p_frame,   yaw_map = alpha + yaw_frame                           (1)
 *   C_map = J C_frame J^T,           J = diag(Rz(alpha), Rz(alpha))                        (2)
 *
 * and the way back is the inverse of each. The frame's own pose is taken as exact.
 *
 * Immutable after construction: one instance may be shared between threads.
 */
class FrameTransform
{
public:
  /// \throws std::invalid_argument if a number of the pose is not finite
  explicit FrameTransform(const Pose & frame_in_map);

  [[nodiscard]] Pose to_map(const Pose & in_frame) const;
  [[nodiscard]] Pose to_frame(const Pose & in_map) const;

  [[nodiscard]] Eigen::Vector3d to_map(const Eigen::Vector3d & point_in_frame) const;
  [[nodiscard]] Eigen::Vector3d to_frame(const Eigen::Vector3d & point_in_map) const;

  [[nodiscard]] Covariance to_map(const Covariance & in_frame) const;
  [[nodiscard]] Covariance to_frame(const Covariance & in_map) const;

private:
  Eigen::Vector3d origin_m_;
  double yaw_rad_;
  Eigen::Matrix3d rotation_;  ///< Rz(alpha), frame to map
};

}  // namespace stetro_site

#endif  // STETRO_SITE__FRAME_TRANSFORM_HPP_
