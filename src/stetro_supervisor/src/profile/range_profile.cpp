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

#include "stetro_supervisor/profile/range_profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stetro_supervisor
{
namespace
{

constexpr double kTurn = 6.283185307179586;

}  // namespace

Beams::Beams(const RangeProfile & profile) : fan_(profile.fan), ranges_m_(profile.ranges_m)
{
  if (ranges_m_.empty() || ranges_m_.size() != fan_.count) {
    throw std::invalid_argument(
      "profile: " + std::to_string(ranges_m_.size()) + " ranges for " + std::to_string(fan_.count) +
      " beams, expected one for each");
  }
  if (!(std::abs(fan_.step_rad) > 0.0) || !std::isfinite(fan_.first_rad)) {
    throw std::invalid_argument("profile: the beams' directions are not finite or all the same");
  }
  directions_.reserve(fan_.count);
  for (std::size_t i = 0; i < fan_.count; ++i) {
    const double angle = fan_.first_rad + static_cast<double>(i) * fan_.step_rad;
    directions_.emplace_back(std::cos(angle), std::sin(angle));
  }
  // A lidar may leave out the beam that would repeat the first, or not; both are a full turn.
  closed_ = static_cast<double>(fan_.count) * step_rad() > kTurn - 1.5 * step_rad();
}

bool Beams::renew(const RangeProfile & profile)
{
  const auto & fan = profile.fan;
  if (
    fan.first_rad != fan_.first_rad || fan.step_rad != fan_.step_rad || fan.count != fan_.count ||
    profile.ranges_m.size() != fan_.count) {
    return false;
  }
  ranges_m_ = profile.ranges_m;
  return true;
}

double Beams::step_rad() const noexcept { return std::abs(fan_.step_rad); }

Beams Beams::thinned(std::size_t count) const
{
  const std::size_t stride = std::max<std::size_t>(1, size() / std::max<std::size_t>(1, count));
  Beams thin;
  thin.fan_ = fan_;
  thin.fan_.step_rad *= static_cast<double>(stride);
  thin.ranges_m_.reserve(size() / stride + 1);
  thin.directions_.reserve(size() / stride + 1);
  for (std::size_t i = 0; i < size(); i += stride) {
    thin.ranges_m_.push_back(ranges_m_[i]);
    thin.directions_.push_back(directions_[i]);
  }
  thin.fan_.count = thin.size();
  thin.closed_ = closed_;
  return thin;
}

stetro_site::BeamFan Beams::fan_at(double yaw_rad) const noexcept
{
  return {fan_.first_rad + yaw_rad, fan_.step_rad, fan_.count};
}

Eigen::Matrix2d rotation(double yaw_rad)
{
  const double c = std::cos(yaw_rad);
  const double s = std::sin(yaw_rad);
  return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

}  // namespace stetro_supervisor
