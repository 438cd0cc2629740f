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

#include "stetro_supervisor/profile/profile_finding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{
namespace
{

/// Poses nearer to each other than this many standard deviations are one.
constexpr double kSame = 6.0;

}  // namespace

const char * name_of(Verdict verdict)
{
  switch (verdict) {
    case Verdict::kAgrees:
      return "agrees";
    case Verdict::kCorrected:
      return "corrected";
    case Verdict::kAmbiguous:
      return "ambiguous";
    case Verdict::kNoVerdict:
      return "no verdict";
  }
  return "unknown";
}

const char * name_of(NoVerdictReason reason)
{
  switch (reason) {
    case NoVerdictReason::kNone:
      return "none";
    case NoVerdictReason::kFewBeams:
      return "few beams";
    case NoVerdictReason::kNotExplained:
      return "not explained";
    case NoVerdictReason::kBeyondTheWalls:
      return "beyond the walls";
    case NoVerdictReason::kOneDirection:
      return "one direction";
    case NoVerdictReason::kNearMisses:
      return "near misses";
    case NoVerdictReason::kNoise:
      return "noise";
    case NoVerdictReason::kRival:
      return "rival";
    case NoVerdictReason::kDirectionFree:
      return "direction free";
    case NoVerdictReason::kOutOfSearch:
      return "out of search";
  }
  return "unknown";
}

Eigen::Matrix3d turned(const Eigen::Matrix3d & covariance, double yaw_rad)
{
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = rotation(yaw_rad);
  return turn * covariance * turn.transpose();
}

double largest_sigma_m(const Eigen::Matrix3d & covariance)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
    covariance.topLeftCorner<2, 2>(), Eigen::EigenvaluesOnly);
  return std::sqrt(axes.eigenvalues().maxCoeff());
}

bool are_one(const ExplainedPlace & a, const ExplainedPlace & b)
{
  const double sigma = largest_sigma_m(a.covariance) + largest_sigma_m(b.covariance);
  const double turn = stetro_site::wrap_angle(a.pose.yaw_rad - b.pose.yaw_rad);
  return (a.pose.position_m - b.pose.position_m).norm() <= kSame * sigma &&
         std::abs(turn) <= kSame * std::sqrt(a.covariance(2, 2) + b.covariance(2, 2));
}

}  // namespace stetro_supervisor
