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

// Where the robot is in its building: the part of the simulated world that knows floors.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "sim/sim_world.hpp"

namespace stetro_driver
{
namespace
{

constexpr double kStartDistance = 0.5;  // base_link before the first riser [m]
constexpr double kStartSpread = 0.05;   // either way [m]
constexpr double kStartTurn = 0.0873;   // either way, 5 deg [rad]
constexpr double kHalfTurn = 3.14159265358979323846;
constexpr int kKidnapTries = 10000;    // then the floor has no other place
constexpr double kKidnapLeast = 1.0;   // from where it was [m]
constexpr double kKidnapTurn = 0.5;    // from how it stood [rad]
constexpr double kKidnapStairs = 1.0;  // from any part of the robot to stairs [m]
constexpr double kKidnapWalls = 0.05;  // from any part of the robot to a wall [m]
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

sim::BodyPose start_of(const StairShape & stairs, const SimOptions & options)
{
  if (options.start) {
    return {options.start->x_m, options.start->y_m, options.start->yaw_rad};
  }
  sim::RandomStream random{options.seed, "start"};
  sim::BodyPose pose;
  pose.x_m = -kStartDistance + random.uniform(-kStartSpread, kStartSpread);
  pose.y_m =
    (stairs.width_foot_m + stairs.width_top_m) / 4.0 + random.uniform(-kStartSpread, kStartSpread);
  pose.yaw_rad = random.uniform(-kStartTurn, kStartTurn);
  return pose;
}

/// A robot at any heading stays inside a circle of this radius about base_link.
double reach_m(const BodyShape & shape)
{
  return std::hypot(1.5 * shape.block_length_m, shape.contact_width_m / 2.0);
}

}  // namespace

void SimRobot::World::surround()
{
  body.surround(building.flight(present).world, building.flight(present).around);
}

void SimRobot::World::put_at_start(const StairShape & stairs)
{
  const sim::BodyPose start = start_of(stairs, options);
  if (!building.has_floors()) {
    body.place(start);
    clutter.emplace(building, 0, 0, options.seed, kNoFloor, Eigen::Vector3d::Zero());
    return;
  }
  surround();
  const sim::Stairs & flight = building.flight(present);
  const double length_m = flight.world.length_m();
  const bool beside = start.y_m < 0.0 || start.y_m > flight.world.width_m(start.x_m);
  const bool above = start.x_m > length_m;
  const double from_stairs_m = std::max(-start.x_m, start.x_m - length_m);
  if (!beside && from_stairs_m <= sim::Building::kAtStairs) {
    body.place(start);
  } else {
    body.hand_over(start, above ? flight.world.steps() : 0, true);
  }
  const std::size_t floor = floor_under();
  const stetro_site::Pose in_map = pose_in_map();
  if (floor != kNoFloor) {
    const sim::Storey & storey = building.floor(floor);
    const stetro_site::Pose at = storey.in_map.to_frame(in_map);
    if (!storey.plan.inside(at.x_m, at.y_m) || !body.fits()) {
      throw std::invalid_argument(
        "the robot does not fit at x " + std::to_string(start.x_m) + " m, y " +
        std::to_string(start.y_m) + " m: in or behind a wall of floor " + storey.id);
    }
  }
  settle();
  clutter.emplace(
    building, options.unmapped_boxes, options.people, options.seed, floor,
    Eigen::Vector3d{in_map.x_m, in_map.y_m, in_map.z_m});
}

/// The floor that base_link is on; kNoFloor between the first riser and the end of the last tread.
std::size_t SimRobot::World::floor_under() const
{
  const sim::Stairs & flight = building.flight(present);
  if (body.open()) {
    return body.step() == 0 ? flight.lower : flight.upper;
  }
  if (body.pose().x_m < 0.0) {
    return flight.lower;
  }
  return body.pose().x_m > flight.world.length_m() ? flight.upper : kNoFloor;
}

std::size_t SimRobot::World::drawn_floor() const
{
  const std::size_t floor = floor_under();
  return floor != kNoFloor && building.floor(floor).plan.drawn() ? floor : kNoFloor;
}

stetro_site::Pose SimRobot::World::pose_in_map() const
{
  const sim::Stairs & flight = building.flight(present);
  const sim::BodyPose & pose = body.pose();
  return flight.in_map.to_map(
    stetro_site::Pose{pose.x_m, pose.y_m, flight.world.height_m(body.step()), pose.yaw_rad});
}

// Only ever between level blocks on a level floor: the two frames then say the same of everything.
void SimRobot::World::settle()
{
  const sim::Stairs & flight = building.flight(present);
  if (!building.has_floors() || !body.level() || body.fall() != sim::Fall::kNone) {
    return;
  }
  const bool below = body.step() == 0;
  if (!below && body.step() != flight.world.steps()) {
    return;
  }
  const std::size_t floor = below ? flight.lower : flight.upper;
  const stetro_site::Pose in_map = pose_in_map();
  const auto at =
    building.stairs_at(floor, Eigen::Vector3d{in_map.x_m, in_map.y_m, in_map.z_m}, present);
  if (at == (body.open() ? std::nullopt : std::optional{present})) {
    return;
  }
  sim::BodyPose pose = body.pose();
  const std::size_t next = at.value_or(present);
  const sim::Stairs & there = building.flight(next);
  if (next != present) {
    const stetro_site::Pose in_next = there.in_map.to_frame(in_map);
    pose = {in_next.x_m, in_next.y_m, in_next.yaw_rad};
    present = next;
    surround();
  }
  body.hand_over(pose, there.lower == floor ? 0 : there.world.steps(), !at);
}

void SimRobot::World::kidnap(double to_the_left_m)
{
  const std::size_t floor = drawn_floor();
  if (floor != kNoFloor && !building.floor(floor).plan.walls().empty()) {
    kidnap_on_floor(floor);
    return;
  }
  sim::BodyPose pose = body.pose();
  const double room_m = shape.contact_width_m / 2.0 + 0.01;
  const double width_m = building.flight(present).world.width_m(pose.x_m);
  pose.y_m = std::clamp(pose.y_m + to_the_left_m, room_m, width_m - room_m);
  body.carry(pose);
}

void SimRobot::World::kidnap_on_floor(std::size_t floor)
{
  const sim::Storey & storey = building.floor(floor);
  const sim::Stairs & flight = building.flight(present);
  const stetro_site::Pose was = storey.in_map.to_frame(pose_in_map());
  const double radius_m = reach_m(shape);
  for (int i = 0; i < kKidnapTries; ++i) {
    stetro_site::Pose to;
    to.x_m = kidnap_random.uniform(storey.plan.min_x_m(), storey.plan.max_x_m());
    to.y_m = kidnap_random.uniform(storey.plan.min_y_m(), storey.plan.max_y_m());
    to.yaw_rad = kidnap_random.uniform(-kHalfTurn, kHalfTurn);
    const stetro_site::Pose in_map = storey.in_map.to_map(to);
    const double stairs_m =
      building.stairs_distance_m(floor, Eigen::Vector3d{in_map.x_m, in_map.y_m, in_map.z_m});
    if (
      std::hypot(to.x_m - was.x_m, to.y_m - was.y_m) >= kKidnapLeast &&
      std::abs(stetro_site::wrap_angle(to.yaw_rad - was.yaw_rad)) >= kKidnapTurn &&
      storey.plan.inside(to.x_m, to.y_m) &&
      storey.plan.wall_distance_m(to.x_m, to.y_m) >= radius_m + kKidnapWalls &&
      stairs_m >= radius_m + kKidnapStairs) {
      const stetro_site::Pose there = flight.in_map.to_frame(in_map);
      body.hand_over(
        {there.x_m, there.y_m, there.yaw_rad}, flight.lower == floor ? 0 : flight.world.steps(),
        true);
      return;
    }
  }
}

GroundTruth SimRobot::World::truth() const
{
  const sim::Stairs & flight = building.flight(present);
  const std::size_t floor = drawn_floor();
  GroundTruth truth;
  truth.time = time;
  truth.in_map = pose_in_map();
  truth.fallen = body.fall() != sim::Fall::kNone;
  for (int block = 1; block <= 3; ++block) {
    truth.block_heights_m[static_cast<std::size_t>(block - 1)] = body.underside_m(block);
  }
  if (floor == kNoFloor) {
    truth.segment = flight.id;
    describe_treads(truth);
    return truth;
  }
  const sim::Storey & storey = building.floor(floor);
  const stetro_site::Pose at = storey.in_map.to_frame(truth.in_map);
  truth.segment = storey.id;
  truth.on_floor = true;
  truth.x_m = at.x_m;
  truth.y_m = at.y_m;
  truth.z_m = at.z_m;
  truth.yaw_rad = at.yaw_rad;
  truth.heading_rad = at.yaw_rad;
  truth.tread_x_m = kUnknown;
  truth.riser_ahead_m = kUnknown;
  truth.tread_width_m = kUnknown;
  for (double & height_m : truth.block_heights_m) {
    height_m += flight.pose_in_map.z_m - storey.pose_in_map.z_m;
  }
  return truth;
}

void SimRobot::World::describe_treads(GroundTruth & truth) const
{
  const sim::StairWorld & stairs = building.flight(present).world;
  const sim::BodyPose & pose = body.pose();
  truth.step = body.step();
  truth.x_m = pose.x_m;
  truth.y_m = pose.y_m;
  truth.z_m = stairs.height_m(truth.step);
  truth.yaw_rad = pose.yaw_rad;
  truth.heading_rad = pose.yaw_rad;
  truth.tread_x_m = truth.step > 0 ? pose.x_m - stairs.riser_x_m(truth.step, pose.y_m) : kUnknown;
  truth.riser_ahead_m = kUnknown;
  if (truth.step < stairs.steps()) {
    truth.riser_ahead_m = stairs.riser_x_m(truth.step + 1, pose.y_m) - pose.x_m;
    truth.heading_rad += std::atan(stairs.riser_slope(truth.step + 1));
  }
  truth.tread_width_m = stairs.width_m(pose.x_m);
}

}  // namespace stetro_driver
