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
#include <optional>
#include <vector>

#include "sim/sim_body.hpp"

namespace stetro_driver::sim
{
namespace
{

constexpr double kLevel = 1e-6;   // heights nearer than this are the same tread [m]
constexpr double kNoWall = 10.0;  // a gap without anything at its end [m]
constexpr double kInset = 1e-4;   // a wall met head on is not beside a bumper's end [m]

}  // namespace

SimBody::Contact SimBody::deepest_contact() const
{
  Contact deepest{};
  for (int block = 1; block <= 3; ++block) {
    offer_riser(block, deepest);
    offer_walls(block, deepest);
  }
  offer_surroundings(deepest);
  return deepest;
}

const std::vector<Wall> & SimBody::walls() const
{
  if (!open_) {
    return around_->at_stairs;
  }
  return step_ == 0 ? around_->open_below : around_->open_above;
}

Wall SimBody::in_base(const Wall & wall) const
{
  const double c = std::cos(pose_.yaw_rad);
  const double s = std::sin(pose_.yaw_rad);
  Wall seen = wall;
  const double from_x_m = wall.from_x_m - pose_.x_m;
  const double from_y_m = wall.from_y_m - pose_.y_m;
  const double to_x_m = wall.to_x_m - pose_.x_m;
  const double to_y_m = wall.to_y_m - pose_.y_m;
  seen.from_x_m = c * from_x_m + s * from_y_m;
  seen.from_y_m = c * from_y_m - s * from_x_m;
  seen.to_x_m = c * to_x_m + s * to_y_m;
  seen.to_y_m = c * to_y_m - s * to_x_m;
  return seen;
}

bool SimBody::reaches(int block, const Wall & wall) const
{
  return underside_m(block) < wall.top_m - kLevel &&
         underside_m(block) + shape_->block_height_m > wall.bottom_m + kLevel;
}

// Blocks are in one row: those that a wall is as high as are one rectangle, bumper to bumper.
void SimBody::offer_surroundings(Contact & deepest) const
{
  const double c = std::cos(pose_.yaw_rad);
  const double s = std::sin(pose_.yaw_rad);
  for (const Wall & wall : walls()) {
    int front = 1;
    int rear = 3;
    while (front <= 3 && !reaches(front, wall)) {
      ++front;
    }
    while (rear > front && !reaches(rear, wall)) {
      --rear;
    }
    if (front > 3) {
      continue;
    }
    const Rectangle body{
      shape_->block_x_m(rear) - shape_->block_length_m / 2.0,
      shape_->block_x_m(front) + shape_->block_length_m / 2.0,
      shape_->contact_width_m / 2.0 - shape_->bumper_travel_m};
    const auto out = way_out(body, in_base(wall));
    if (out && out->depth_m > deepest.depth_m) {
      deepest = {
        out->depth_m, c * out->x - s * out->y, s * out->x + c * out->y,
        c * out->at_x_m - s * out->at_y_m, s * out->at_x_m + c * out->at_y_m};
    }
  }
}

std::optional<RayHit> SimBody::cast(
  const Vector3 & origin, const Vector3 & direction, double reach_m) const
{
  std::optional<RayHit> nearest;
  if (!open_) {
    nearest = world_->cast(origin, direction, reach_m);
  } else if (direction.z < 0.0) {
    const double down_m = (world_->height_m(step_) - origin.z) / direction.z;
    if (down_m > 0.0 && down_m < reach_m) {
      nearest = RayHit{down_m, -direction.z};
    }
  }
  for (const Wall & wall : walls()) {
    const auto hit = sim::cast(wall, origin, direction);
    if (hit && hit->distance_m < (nearest ? nearest->distance_m : reach_m)) {
      nearest = hit;
    }
  }
  return nearest;
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
  if (open_) {
    return;
  }
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
      if (depth_m > deepest.depth_m && world_->riser_spans(corner.x, corner.y)) {
        deepest = {
          depth_m, -cosine, cosine * world_->riser_slope(k), corner.x - pose_.x_m,
          corner.y - pose_.y_m};
      }
    }
  }
}

void SimBody::offer_walls(int block, Contact & deepest) const
{
  if (open_) {
    return;
  }
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
  const double rear_m = shape_->block_x_m(block) - shape_->block_length_m / 2.0;
  double gap_m = open_ ? kNoWall : side_wall_gap_m(block, left);
  for (const Wall & wall : walls()) {
    if (!reaches(block, wall)) {
      continue;
    }
    const double beside =
      beside_m(in_base(wall), rear_m + kInset, rear_m + shape_->block_length_m - kInset, left);
    if (beside > 0.0) {
      gap_m = std::min(gap_m, beside - half_width_m);
    }
  }
  return gap_m;
}

double SimBody::side_wall_gap_m(int block, bool left) const
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
  if (open_ || k > world_->steps()) {
    return kNoWall;
  }
  const Vector3 tip = to_flight(shape_->block_length_m / 2.0, y_m, 0.0);
  return (world_->riser_x_m(k, tip.y) - tip.x) / std::hypot(1.0, world_->riser_slope(k));
}

}  // namespace stetro_driver::sim
