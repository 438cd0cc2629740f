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

#include "stetro_site/frame_transform.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace stetro_site
{
namespace
{

constexpr double kTurn = 6.283185307179586;  // [rad]
constexpr int kPlanar[] = {0, 1, 5};         // x, y and yaw among the six

Eigen::Vector3d position(const Pose & pose) { return {pose.x_m, pose.y_m, pose.z_m}; }

Pose pose_at(const Eigen::Vector3d & position_m, double yaw_rad)
{
  return {position_m.x(), position_m.y(), position_m.z(), wrap_angle(yaw_rad)};
}

Covariance rotated(const Covariance & covariance, const Eigen::Matrix3d & rotation)
{
  Covariance jacobian = Covariance::Zero();
  jacobian.topLeftCorner<3, 3>() = rotation;
  jacobian.bottomRightCorner<3, 3>() = rotation;
  return jacobian * covariance * jacobian.transpose();
}

}  // namespace

double wrap_angle(double angle_rad) { return std::remainder(angle_rad, kTurn); }

Eigen::Matrix3d planar(const Covariance & covariance)
{
  Eigen::Matrix3d part;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      part(row, column) = covariance(kPlanar[row], kPlanar[column]);
    }
  }
  return part;
}

void set_planar(Covariance & covariance, const Eigen::Matrix3d & planar)
{
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      covariance(kPlanar[row], kPlanar[column]) = planar(row, column);
    }
  }
}

FrameTransform::FrameTransform(const Pose & frame_in_map)
: origin_m_(position(frame_in_map)),
  yaw_rad_(frame_in_map.yaw_rad),
  rotation_(Eigen::AngleAxisd(frame_in_map.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix())
{
  if (!origin_m_.allFinite() || !std::isfinite(yaw_rad_)) {
    throw std::invalid_argument("pose of a frame in map: accepted: finite numbers");
  }
}

Pose FrameTransform::to_map(const Pose & in_frame) const
{
  return pose_at(to_map(position(in_frame)), yaw_rad_ + in_frame.yaw_rad);
}

Pose FrameTransform::to_frame(const Pose & in_map) const
{
  return pose_at(to_frame(position(in_map)), in_map.yaw_rad - yaw_rad_);
}

Eigen::Vector3d FrameTransform::to_map(const Eigen::Vector3d & point_in_frame) const
{
  return origin_m_ + rotation_ * point_in_frame;
}

Eigen::Vector3d FrameTransform::to_frame(const Eigen::Vector3d & point_in_map) const
{
  return rotation_.transpose() * (point_in_map - origin_m_);
}

Covariance FrameTransform::to_map(const Covariance & in_frame) const
{
  return rotated(in_frame, rotation_);
}

Covariance FrameTransform::to_frame(const Covariance & in_map) const
{
  return rotated(in_map, rotation_.transpose());
}

}  // namespace stetro_site
