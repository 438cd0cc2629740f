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

// What the body touches: the part of SimBody that knows surfaces.

#include <algorithm>
#include <cmath>

#include "sim/sim_body.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kLevel = 1e-6;   // heights nearer than this are the same tread [m]
constexpr double kNoWall = 10.0;  // a gap without anything at its end [m]

}  // namespace

SimBody::Contact SimBody::deepest_contact() const
{
  Contact deepest{};
  for (int block = 1; block <= 3; ++block) {
    offer_riser(block, deepest);
    offer_walls(block, deepest);
  }
  return deepest;
}

int SimBody::riser_ahead(int block) const
{
  int k = 1;
  while (k <= world_->steps() && world_->height_m(k) <= underside_m(block) + kLevel) {
    ++k;
  }
  return k;
}

void SimBody::offer_riser(int block, Contact & deepest) const
{
  const int k = riser_ahead(block);
  if (k > world_->steps()) {
    return;
  }
  // Block 2's front edge is its two switches: the block itself is behind them by their travel.
  const double yields_m = block == 2 ? shape_->switch_travel_m : 0.0;
  const double centre_m = shape_->block_x_m(block);
  const double cosine = 1.0 / std::hypot(1.0, world_->riser_slope(k));
  for (const double along :
       {shape_->block_length_m / 2.0 - yields_m, -shape_->block_length_m / 2.0}) {
    for (const double side : {-1.0, 1.0}) {
      const Vector3 corner = to_flight(centre_m + along, side * shape_->body_width_m / 2.0, 0.0);
      const double depth_m = (corner.x - world_->riser_x_m(k, corner.y)) * cosine;
      if (depth_m > deepest.depth_m) {
        deepest = {
          depth_m, -cosine, cosine * world_->riser_slope(k), corner.x - pose_.x_m,
          corner.y - pose_.y_m};
      }
    }
  }
}

void SimBody::offer_walls(int block, Contact & deepest) const
{
  const double centre_m = shape_->block_x_m(block);
  const double half_width_m = shape_->contact_width_m / 2.0 - shape_->bumper_travel_m;
  const double slope = world_->left_wall_slope();
  const double cosine = 1.0 / std::hypot(1.0, slope);
  for (const double along : {-shape_->block_length_m / 2.0, shape_->block_length_m / 2.0}) {
    const Vector3 right = to_flight(centre_m + along, -half_width_m, 0.0);
    if (world_->right_walled(right.x) && -right.y > deepest.depth_m) {
      deepest = {-right.y, 0.0, 1.0, right.x - pose_.x_m, right.y - pose_.y_m};
    }
    const Vector3 left = to_flight(centre_m + along, half_width_m, 0.0);
    const double depth_m = (left.y - world_->width_m(left.x)) * cosine;
    if (world_->left_walled(left.x) && depth_m > deepest.depth_m) {
      deepest = {depth_m, cosine * slope, -cosine, left.x - pose_.x_m, left.y - pose_.y_m};
    }
  }
}

double SimBody::bumper_gap_m(int block, bool left) const
{
  const double half_width_m = shape_->contact_width_m / 2.0;
  const double cosine = 1.0 / std::hypot(1.0, world_->left_wall_slope());
  double gap_m = kNoWall;
  for (const double along : {-shape_->block_length_m / 2.0, shape_->block_length_m / 2.0}) {
    const Vector3 end =
      to_flight(shape_->block_x_m(block) + along, left ? half_width_m : -half_width_m, 0.0);
    if (left ? world_->left_walled(end.x) : world_->right_walled(end.x)) {
      gap_m = std::min(gap_m, left ? (world_->width_m(end.x) - end.y) * cosine : end.y);
    }
  }
  return gap_m;
}

double SimBody::switch_gap_m(double y_m) const
{
  const int k = riser_ahead(2);
  if (k > world_->steps()) {
    return kNoWall;
  }
  const Vector3 tip = to_flight(shape_->block_length_m / 2.0, y_m, 0.0);
  return (world_->riser_x_m(k, tip.y) - tip.x) / std::hypot(1.0, world_->riser_slope(k));
}

}  // namespace stetro_driver::sim
