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
#include "support/toy_robot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace stetro_supervisor
{
namespace
{

constexpr double kTouch_m = 0.0005;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 3> kCentre_m{0.15, 0.0, -0.15};
constexpr double kHalfLength_m = 0.075;
constexpr double kLift_mps = 0.06;
constexpr double kSteer_rps = 1.6;

}  // namespace

ClimbGeometry stairs(int steps)
{
  ClimbGeometry geometry;
  geometry.riser_m.assign(static_cast<std::size_t>(steps), 0.14);
  geometry.tread_m.assign(static_cast<std::size_t>(steps), 0.32);
  geometry.width_m = 2.05;
  return geometry;
}

stetro_site::Flight flight_of(const ClimbGeometry & geometry)
{
  stetro_site::FlightSpec spec;
  spec.id = geometry.segment_id;
  for (std::size_t i = 0; i < geometry.riser_m.size(); ++i) {
    spec.steps.push_back({geometry.riser_m[i], geometry.tread_m[i]});
  }
  spec.width_foot_m = geometry.width_m;
  spec.width_top_m = geometry.width_m + geometry.widening_m;
  spec.lower_floor = "ground";
  spec.pose_in_map.x_m = 10.0;
  return stetro_site::Flight(spec);
}

ToyRobot::ToyRobot(ClimbGeometry geometry) : geometry_(std::move(geometry)) {}

double ToyRobot::surface_m(double x) const
{
  double face = 0.0;
  double top = 0.0;
  for (std::size_t i = 0; i < geometry_.riser_m.size() && x >= face; ++i) {
    top += geometry_.riser_m[i];
    face += geometry_.tread_m[i];
  }
  return top;
}

double ToyRobot::support_m(int block) const
{
  const double x = x_m + kCentre_m.at(static_cast<std::size_t>(block));
  return std::max(surface_m(x - kHalfLength_m), surface_m(x + kHalfLength_m));
}

/// Where a level beam at a height meets the next riser.
double ToyRobot::face_ahead_m(double from_x, double height) const
{
  double face = 0.0;
  double top = 0.0;
  for (std::size_t i = 0; i < geometry_.riser_m.size(); ++i) {
    top += geometry_.riser_m[i];
    if (face >= from_x && top > height) {
      return face;
    }
    face += geometry_.tread_m[i];
  }
  return kInfinity;
}

double ToyRobot::sideways_m() const
{
  return 0.115 * std::cos(heading_rad) + 0.225 * std::abs(std::sin(heading_rad));
}

bool ToyRobot::blocked(double dx) const
{
  for (std::size_t b = 0; b < 3; ++b) {
    const double edge = x_m + kCentre_m[b] + std::copysign(kHalfLength_m, dx) + dx;
    if (surface_m(edge) > z_m[b] + 1e-6) {
      return true;
    }
  }
  return false;
}

void ToyRobot::roll(double vx, double dt_s)
{
  const double dx = vx * dt_s * std::cos(heading_rad);
  const double dy = vx * dt_s * std::sin(heading_rad);
  const bool left = switch_gap_m(+1) <= kTouch_m;
  const bool right = switch_gap_m(-1) <= kTouch_m;
  if (vx > 0.0 && (left || right)) {
    const double turn = std::min(std::abs(heading_rad), 0.1 * dt_s);
    heading_rad -= pivots ? std::copysign(turn, heading_rad) : 0.0;
    odometry_.yaw_rad -= pivots ? std::copysign(turn, heading_rad) : 0.0;
    return;
  }
  const bool free = !blocked(dx);
  if (free) {
    x_m += dx;
    y_m += dy;
  }
  if (free || spins) {
    odometry_.x_m += vx * dt_s * std::cos(odometry_.yaw_rad);
    odometry_.y_m += vx * dt_s * std::sin(odometry_.yaw_rad);
  }
}

void ToyRobot::traverse(const MotionCommand & command, double dt_s)
{
  const double step = command.vy_mps * dt_s;
  const double y = y_m + step * std::cos(heading_rad);
  const double room = geometry_.width_m - sideways_m();
  if (y <= room && y >= sideways_m()) {
    y_m = y;
    x_m -= step * std::sin(heading_rad);
    odometry_.x_m -= step * std::sin(odometry_.yaw_rad);
    odometry_.y_m += step * std::cos(odometry_.yaw_rad);
  }
  const double turn = (command.wz_rps + turn_disturbance_rps) * dt_s;
  heading_rad += turn;
  odometry_.yaw_rad += turn;
}

void ToyRobot::move_block(int block, double dz, double limit)
{
  const auto b = static_cast<std::size_t>(block);
  const double to = dz > 0.0 ? std::min(z_m[b] + dz, limit) : std::max(z_m[b] + dz, limit);
  moving_[b] = std::abs(to - z_m[b]) > 1e-9;
  z_m[b] = to;
}

void ToyRobot::act(const MotionCommand & command, double dt_s)
{
  const std::array<bool, 3> before = moving_;
  moving_ = {};
  steering_moving_ = false;
  const auto b = static_cast<std::size_t>(std::max(0, command.block - 1));
  switch (command.kind) {
    case MotionCommand::Kind::kTwist:
      if (command.vx_mps != 0.0 && std::abs(steering_rad) < 0.02) {
        roll(command.vx_mps, dt_s);
      } else if (std::abs(steering_rad - kQuarterTurn_rad) < 0.02) {
        traverse(command, dt_s);
      }
      break;
    case MotionCommand::Kind::kLift:
      if (z_m[b] < support_m(static_cast<int>(b)) + 1e-6 && !before[b]) {
        lift_top_m_[b] = support_m(static_cast<int>(b)) + geometry_.stroke_m;
      }
      move_block(static_cast<int>(b), kLift_mps * dt_s, lift_top_m_[b]);
      break;
    case MotionCommand::Kind::kLower:
      move_block(static_cast<int>(b), -kLift_mps * dt_s, support_m(static_cast<int>(b)));
      break;
    case MotionCommand::Kind::kSteer: {
      const double error = command.steering_rad - steering_rad;
      steering_moving_ = std::abs(error) > 1e-9;
      steering_rad += std::copysign(std::min(std::abs(error), kSteer_rps * dt_s), error);
      break;
    }
    default:
      break;
  }
  const bool block2_stands = z_m[1] <= support_m(1) + 1e-6;
  if (counts && block2_stands) {
    counted_step = static_cast<int>(std::lround(z_m[1] / geometry_.riser_m.front()));
  }
  now += std::chrono::nanoseconds(std::llround(dt_s * 1e9));
}

double ToyRobot::switch_gap_m(int side) const
{
  const double x = x_m + kHalfLength_m * std::cos(heading_rad) -
                   side * geometry_.switch_separation_m / 2.0 * std::sin(heading_rad);
  return face_ahead_m(x - 0.02, z_m[1] + 0.01) - x;
}

Range ToyRobot::range(double metres) const
{
  const bool in_reach = metres <= 1.2;
  const auto status = metres < 0.03 ? RangeStatus::kTooNear
                      : in_reach    ? RangeStatus::kValid
                                    : RangeStatus::kNoTarget;
  return {now, metres, status};
}

Contacts ToyRobot::contacts() const
{
  const auto contact = [](bool closed) {
    return Contact{closed ? ContactState::kClosed : ContactState::kOpen, false};
  };
  const bool at_left = y_m + sideways_m() >= geometry_.width_m - 0.002;
  const bool at_right = y_m - sideways_m() <= 0.002;
  Contacts c;
  c.time = now;
  c.left = {
    contact(at_left && heading_rad >= 0.0), contact(false), contact(at_left && heading_rad < 0.0)};
  c.right = {
    contact(at_right && heading_rad <= 0.0), contact(false),
    contact(at_right && heading_rad > 0.0)};
  c.riser_left = contact(switch_gap_m(+1) <= kTouch_m);
  c.riser_right = contact(switch_gap_m(-1) <= kTouch_m);
  c.emergency_stop = contact(false);
  return c;
}

Blocks ToyRobot::blocks() const
{
  Blocks blocks;
  blocks.time = now;
  blocks.steering_rad = steering_rad;
  blocks.steering_moving = steering_moving_;
  const double lowest = *std::min_element(z_m.begin(), z_m.end());
  for (std::size_t b = 0; b < 3; ++b) {
    Block & block = blocks.block[b];
    const bool stands = z_m[b] <= support_m(static_cast<int>(b)) + 1e-6;
    block.height_m = z_m[b] - lowest;
    block.moving = moving_[b];
    block.at_upper_lock = !stands && z_m[b] >= lift_top_m_[b] - 1e-9;
    block.load = stands ? 0.33 : 0.0;
  }
  return blocks;
}

Observation ToyRobot::look() const
{
  Observation o;
  const double c = std::cos(heading_rad);
  const auto front = [&](double y) {
    const double x = x_m + 0.19 * c - y * std::sin(heading_rad);
    return range((face_ahead_m(x, z_m[0] + 0.07) - x) / c);
  };
  const auto put = [&o](Place place, Range r) { o.ranges[static_cast<std::size_t>(place)] = r; };
  put(Place::kFrontLeft, front(+0.10));
  put(Place::kFrontRight, front(-0.10));
  put(Place::kStairFront, front(0.0));
  put(Place::kSideLeft, range((geometry_.width_m - y_m - 0.05) / c));
  put(Place::kSideRight, range((y_m - 0.05) / c));
  put(Place::kBlock1Down, range(z_m[0] + 0.035 - support_m(0)));
  put(Place::kBlock2Down, range(z_m[1] + 0.035 - support_m(1)));
  const bool sees_block2 = z_m[1] < z_m[2] + 0.07;
  put(
    Place::kBlock3Front,
    range(sees_block2 ? 0.035 : face_ahead_m(x_m - 0.11, z_m[2] + 0.07) - x_m + 0.11));
  o.contacts = contacts();
  o.blocks = blocks();
  o.odometry = odometry_;
  o.odometry->time = now;
  o.pose = StairPose{now,         geometry_.segment_id, true, counted_step, y_m,
                     heading_rad, Integrity::kOk,       0,    resets};
  o.driver_instance = driver_instance;
  if (meddle) {
    meddle(o);
  }
  return o;
}

bool run_until(
  Climb & climb, ToyRobot & robot, double limit_s, const std::function<bool()> & condition)
{
  constexpr double kTick_s = 0.05;
  for (double t = 0.0; t < limit_s; t += kTick_s) {
    const MotionCommand command = climb.tick(robot.now, robot.look());
    if (condition()) {
      return true;
    }
    for (int i = 0; i < 5; ++i) {
      robot.act(command, kTick_s / 5.0);
    }
  }
  return false;
}

bool run_to_state(Climb & climb, ToyRobot & robot, State state, double limit_s)
{
  return run_until(climb, robot, limit_s, [&] { return climb.state() == state; });
}

std::string where(const Climb & climb, const ToyRobot & robot)
{
  std::ostringstream text;
  text << "state " << to_string(climb.state()) << ", fault " << to_string(climb.fault()) << " ("
       << climb.note() << "), step " << climb.record().step << ", x " << robot.x_m << ", y "
       << robot.y_m << ", heading " << robot.heading_rad << ", z " << robot.z_m[0] << " "
       << robot.z_m[1] << " " << robot.z_m[2] << ", steering " << robot.steering_rad;
  return text.str();
}

}  // namespace stetro_supervisor
