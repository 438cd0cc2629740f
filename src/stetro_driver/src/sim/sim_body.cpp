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

#include "sim/sim_body.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_driver::sim
{
namespace
{

constexpr double kLevel = 1e-6;          // heights nearer than this are the same tread [m]
constexpr double kTouch = 1e-7;          // a contact this deep is only a touch [m]
constexpr double kEdgeInset = 0.0025;    // edges of a block are rounded off by this [m]
constexpr double kLockMargin = 0.01;     // how far a lift reaches below where its block stood [m]
constexpr double kLongestMove = 0.002;   // longer moves are taken in parts [m]
constexpr double kShortestLever = 0.01;  // a push with less does not turn the body [m]

const Surroundings kNothingElse{};

}  // namespace

std::string_view to_string(Fall fall)
{
  switch (fall) {
    case Fall::kNone:
      return "none";
    case Fall::kLiftedWithoutSupport:
      return "lifted without support";
    case Fall::kLoweredOnNothing:
      return "lowered on nothing";
    case Fall::kTippedOffNosing:
      return "tipped off a nosing";
    case Fall::kRolledOverNosing:
      return "rolled over a nosing";
  }
  return "unknown";
}

SimBody::SimBody(
  const BodyShape & shape, const StairWorld & world, double squaring,
  const std::array<double, kBlocks> & lock_error_m)
: shape_(&shape),
  world_(&world),
  squaring_(squaring),
  lock_error_m_(lock_error_m),
  around_(&kNothingElse)
{
}

void SimBody::surround(const StairWorld & world, const Surroundings & around)
{
  world_ = &world;
  around_ = &around;
}

void SimBody::hand_over(const BodyPose & pose, int step, bool open)
{
  pose_ = pose;
  step_ = step;
  open_ = open;
  // Its floor is as high as the flights around it were built: nobody is lifted by the paperwork.
  underside_m_.fill(world_->height_m(step));
  datum_m_.fill(world_->height_m(step));
  standing_.fill(true);
}

bool SimBody::level() const
{
  return standing(1) && standing(2) && standing(3) &&
         std::abs(underside_m(1) - underside_m(2)) < kLevel &&
         std::abs(underside_m(3) - underside_m(2)) < kLevel;
}

bool SimBody::fits() const { return deepest_contact().depth_m <= kTouch; }

void SimBody::place(const BodyPose & pose)
{
  pose_ = pose;
  fall_ = Fall::kNone;
  for (int block = 1; block <= 3; ++block) {
    const double ground_m = ground_under_centre_m(block);
    underside_m_[index(block)] = ground_m;
    datum_m_[index(block)] = ground_m;
    standing_[index(block)] = true;
  }
  const Vector3 centre = to_flight(0.0, 0.0, 0.0);
  step_ = step_under(centre.x, centre.y);
  const Contact contact = deepest_contact();
  if (contact.depth_m > kTouch) {
    const bool sideways = std::abs(contact.normal_y) > std::abs(contact.normal_x);
    throw std::invalid_argument(
      "the robot does not fit at x " + std::to_string(pose.x_m) + " m, y " +
      std::to_string(pose.y_m) + " m: " + std::to_string(contact.depth_m) + " m inside a " +
      (!walls().empty() ? "wall or riser"
       : sideways       ? "side wall"
                        : "riser"));
  }
}

void SimBody::carry(const BodyPose & pose)
{
  const BodyPose before = pose_;
  pose_ = pose;
  if (!fits()) {
    pose_ = before;
  }
}

void SimBody::move(const Displacement & displacement)
{
  const double length_m =
    std::hypot(displacement.x_m, displacement.y_m) + 0.225 * std::abs(displacement.yaw_rad);
  const int parts = std::max(1, static_cast<int>(std::ceil(length_m / kLongestMove)));
  for (int i = 0; i < parts && fall_ == Fall::kNone; ++i) {
    turn(displacement.yaw_rad / parts);
    slide(displacement.x_m / parts, displacement.y_m / parts);
    check_support();
  }
}

void SimBody::turn(double yaw_rad)
{
  const double before_m = deepest_contact().depth_m;
  const double old_yaw_rad = pose_.yaw_rad;
  pose_.yaw_rad += yaw_rad;
  if (deepest_contact().depth_m > std::max(before_m, kTouch)) {
    pose_.yaw_rad = old_yaw_rad;  // the wheels turn under it
  }
}

void SimBody::slide(double x_m, double y_m)
{
  const BodyPose before = pose_;
  const double c = std::cos(pose_.yaw_rad);
  const double s = std::sin(pose_.yaw_rad);
  pose_.x_m += c * x_m - s * y_m;
  pose_.y_m += s * x_m + c * y_m;
  Contact first{};
  double pushed_m = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Contact contact = deepest_contact();
    if (contact.depth_m <= 0.0) {
      break;
    }
    if (first.depth_m == 0.0) {
      first = contact;
    }
    pose_.x_m += contact.normal_x * contact.depth_m;
    pose_.y_m += contact.normal_y * contact.depth_m;
    pushed_m += contact.depth_m;
  }
  if (deepest_contact().depth_m > kTouch) {
    pose_ = before;  // wedged between two surfaces
  } else if (pushed_m > 0.0) {
    square_up(first, std::min(pushed_m, std::hypot(x_m, y_m)));
  }
}

void SimBody::square_up(const Contact & contact, double pushed_m)
{
  const double lever_m =
    contact.corner_x_m * contact.normal_y - contact.corner_y_m * contact.normal_x;
  if (std::abs(lever_m) < kShortestLever) {
    return;
  }
  const double old_yaw_rad = pose_.yaw_rad;
  double turn_rad = squaring_ * pushed_m / lever_m;
  for (int halvings = 0; halvings < 8; ++halvings, turn_rad /= 2.0) {
    pose_.yaw_rad = old_yaw_rad + turn_rad;
    if (deepest_contact().depth_m <= kTouch) {
      return;
    }
  }
  pose_.yaw_rad = old_yaw_rad;
}

void SimBody::check_support()
{
  for (int block = 1; block <= 3; ++block) {
    if (standing(block) && ground_under_centre_m(block) < underside_m(block) - kLevel) {
      fall_ = Fall::kRolledOverNosing;
    }
  }
}

void SimBody::lift(int block, double distance_m)
{
  if (fall_ != Fall::kNone) {
    return;
  }
  const bool carried = block == 2 ? standing(1) && standing(3) : standing(2);
  if (!carried) {
    fall_ = Fall::kLiftedWithoutSupport;
    return;
  }
  double & underside = underside_m_[index(block)];
  underside = std::min(underside + distance_m, upper_lock_m(block));
  standing_[index(block)] = underside <= ground_under_centre_m(block) + kLevel;
}

void SimBody::lower(int block, double distance_m)
{
  if (fall_ != Fall::kNone || standing(block)) {
    return;
  }
  double & underside = underside_m_[index(block)];
  const double lowered_m = underside - distance_m;
  const double ground_m = ground_under_edges_m(block);
  const double lowest_m = datum_m_[index(block)] - kLockMargin;
  if (std::max(lowered_m, ground_m) < lowest_m) {
    underside = lowest_m;
    fall_ = Fall::kLoweredOnNothing;
    return;
  }
  if (lowered_m > ground_m) {
    underside = lowered_m;
    return;
  }
  underside = ground_m;
  if (ground_under_centre_m(block) < ground_m - kLevel) {
    fall_ = Fall::kTippedOffNosing;
    return;
  }
  standing_[index(block)] = true;
  datum_m_[index(block)] = ground_m;
  if (block == 2) {
    step_ = step_under(pose_.x_m, pose_.y_m);
  }
}

double SimBody::upper_lock_m(int block) const
{
  return datum_m_[index(block)] + shape_->stroke_m + lock_error_m_[index(block)];
}

bool SimBody::at_upper_lock(int block) const
{
  return underside_m(block) >= upper_lock_m(block) - kLevel;
}

double SimBody::load(int block) const
{
  const auto feet = std::count(standing_.begin(), standing_.end(), true);
  return standing(block) ? 1.0 / static_cast<double>(feet) : 0.0;
}

Vector3 SimBody::to_flight(double x_m, double y_m, double z_m) const
{
  const double c = std::cos(pose_.yaw_rad);
  const double s = std::sin(pose_.yaw_rad);
  return {pose_.x_m + c * x_m - s * y_m, pose_.y_m + s * x_m + c * y_m, z_m};
}

int SimBody::step_under(double x_m, double y_m) const
{
  return open_ ? step_ : world_->step_at(x_m, y_m);
}

double SimBody::ground_under_centre_m(int block) const
{
  const Vector3 centre = to_flight(shape_->block_x_m(block), 0.0, 0.0);
  return world_->height_m(step_under(centre.x, centre.y));
}

double SimBody::ground_under_edges_m(int block) const
{
  double highest_m = ground_under_centre_m(block);
  const double half_length_m = shape_->block_length_m / 2.0 - kEdgeInset;
  const double half_width_m = shape_->body_width_m / 2.0 - kEdgeInset;
  for (const double along : {-half_length_m, half_length_m}) {
    for (const double across : {-half_width_m, half_width_m}) {
      const Vector3 corner = to_flight(shape_->block_x_m(block) + along, across, 0.0);
      highest_m = std::max(highest_m, world_->height_m(step_under(corner.x, corner.y)));
    }
  }
  return highest_m;
}

}  // namespace stetro_driver::sim
