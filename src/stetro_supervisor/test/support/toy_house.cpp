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

#include "support/toy_house.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "stetro_site/frame_transform.hpp"
#include "stetro_site/wall_segments.hpp"
#include "stetro_supervisor/floor/profile_witness.hpp"
#include "stetro_supervisor/pose_reason.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::FrameTransform;
using stetro_site::Pose;
using stetro_site::wrap_angle;

constexpr double kSteer_rps = 1.6;
constexpr double kBoards_m = 1.0;
constexpr double kBoards_rad = 0.4;
constexpr double kAlights_m = 0.30;  // beyond a flight's end
constexpr double kGate_m = 0.3;

}  // namespace

ToyHouse::ToyHouse(stetro_site::Site site) : site_(std::move(site))
{
  for (const auto & flight : site_.flights()) {
    robots_.emplace(flight.id(), make_geometry(flight, stetro_site::RobotGeometry{}));
  }
}

void ToyHouse::place(const std::string & floor, const Pose & in_map)
{
  floor_ = told_floor_ = floor;
  pose_ = in_map;
  pose_.z_m = site_.floor(floor).elevation_m();
}

void ToyHouse::kidnap(const Pose & in_map)
{
  told_error_ = {
    pose_.x_m + told_error_.x_m - in_map.x_m, pose_.y_m + told_error_.y_m - in_map.y_m, 0.0,
    wrap_angle(pose_.yaw_rad + told_error_.yaw_rad - in_map.yaw_rad)};
  pose_ = {in_map.x_m, in_map.y_m, pose_.z_m, in_map.yaw_rad};
  last_told_.reset();
}

void ToyHouse::kidnap(const std::string & floor, const Pose & in_map)
{
  kidnap(in_map);
  floor_ = floor;
  pose_.z_m = site_.floor(floor).elevation_m();
  scan_.reset();
}

Pose ToyHouse::in_map() const
{
  if (flight_ == nullptr) {
    return pose_;
  }
  const ToyRobot & robot = robots_.at(flight_->id());
  return flight_->T_map_flight().to_map(Pose{robot.x_m, robot.y_m, 0.0, robot.heading_rad});
}

std::string ToyHouse::segment() const { return flight_ != nullptr ? flight_->id() : floor_; }

void ToyHouse::act(const MotionCommand & command, double dt_s)
{
  if (flight_ != nullptr) {
    ToyRobot & robot = robots_.at(flight_->id());
    robot.act(command, dt_s);
    now = robot.now;
    hand_over();
    return;
  }
  steering_moving_ = false;
  if (command.kind == MotionCommand::Kind::kSteer) {
    const double error = command.steering_rad - steering_rad_;
    steering_moving_ = std::abs(error) > 1e-9;
    steering_rad_ += std::copysign(std::min(std::abs(error), kSteer_rps * dt_s), error);
  }
  if (command.kind == MotionCommand::Kind::kTwist) {
    const bool along = std::abs(steering_rad_) < 0.02;
    const bool across = std::abs(steering_rad_ - kQuarterTurn_rad) < 0.02;
    const double roll = along ? command.vx_mps * dt_s : 0.0;
    const double turn = across ? command.wz_rps * dt_s : 0.0;
    const double told = (1.0 + drift) * roll;
    odometry_.x_m += told * std::cos(odometry_.yaw_rad);
    odometry_.y_m += told * std::sin(odometry_.yaw_rad);
    told_error_.x_m += (told - roll) * std::cos(pose_.yaw_rad + told_error_.yaw_rad);
    told_error_.y_m += (told - roll) * std::sin(pose_.yaw_rad + told_error_.yaw_rad);
    pose_.x_m += roll * std::cos(pose_.yaw_rad);
    pose_.y_m += roll * std::sin(pose_.yaw_rad);
    pose_.yaw_rad = wrap_angle(pose_.yaw_rad + turn);
    odometry_.yaw_rad = wrap_angle(odometry_.yaw_rad + turn);
  }
  now += std::chrono::nanoseconds(std::llround(dt_s * 1e9));
  hand_over();
}

void ToyHouse::hand_over()
{
  if (flight_ != nullptr) {
    if (robots_.at(flight_->id()).x_m > flight_->total_run_m() + kAlights_m) {
      alight(*flight_);
    }
    return;
  }
  for (const auto & flight : site_.flights()) {
    const Pose at = flight.T_map_flight().to_frame(pose_);
    const bool near = at.x_m > -kBoards_m && at.x_m < 0.0 && at.y_m > 0.15 && at.y_m < 1.9;
    if (
      flight.spec().lower_floor == floor_ && near &&
      std::abs(wrap_angle(at.yaw_rad)) < kBoards_rad) {
      board(flight, at);
      return;
    }
  }
}

void ToyHouse::board(const stetro_site::Flight & flight, const Pose & at)
{
  flight_ = &flight;
  ToyRobot & robot = robots_.at(flight.id());
  robot.now = now;
  robot.x_m = at.x_m;
  robot.y_m = at.y_m;
  robot.heading_rad = wrap_angle(at.yaw_rad);
  robot.steering_rad = steering_rad_;
  told_error_ = Pose{};
}

void ToyHouse::alight(const stetro_site::Flight & flight)
{
  pose_ = in_map();
  floor_ = told_floor_ = flight.spec().upper_floor;
  pose_.z_m = site_.floor(floor_).elevation_m();
  steering_rad_ = robots_.at(flight.id()).steering_rad;
  flight_ = nullptr;
}

std::shared_ptr<const Scan> ToyHouse::scan()
{
  if (scan_ && seconds_between(scan_->time, now) < 0.0999) {
    return scan_;
  }
  const auto & floor = site_.floor(floor_);
  const Pose at = FrameTransform{floor.pose_in_map}.to_frame(pose_);
  auto walls = stetro_site::wall_segments(std::get<stetro_site::PolygonWalls>(floor.drawing));
  walls.insert(walls.end(), unmapped.begin(), unmapped.end());
  Scan taken;
  taken.time = now;
  taken.profile.fan = {-3.14159265358979312, 2.0 * 3.14159265358979312 / 360.0, 360};
  auto fan = taken.profile.fan;
  fan.first_rad += at.yaw_rad;
  WallCaster{walls}.cast({at.x_m, at.y_m}, fan, 12.0, taken.profile.ranges_m);
  std::normal_distribution<double> noise{0.0, 0.01};
  for (double & range : taken.profile.ranges_m) {
    range += noise(random_);
  }
  scan_ = std::make_shared<const Scan>(std::move(taken));
  return scan_;
}

Observation ToyHouse::look_on_floor()
{
  Observation o;
  for (auto & range : o.ranges) {
    range = Range{now, 0.0, RangeStatus::kNoTarget, now};
  }
  Contacts contacts;
  contacts.time = now;
  const auto open = [](Contact & contact) { contact.state = ContactState::kOpen; };
  for (std::size_t i = 0; i < 3; ++i) {
    open(contacts.left[i]);
    open(contacts.right[i]);
  }
  open(contacts.riser_left);
  open(contacts.riser_right);
  open(contacts.emergency_stop);
  o.contacts = contacts;
  Blocks blocks;
  blocks.time = now;
  blocks.steering_rad = steering_rad_;
  blocks.steering_moving = steering_moving_;
  for (Block & block : blocks.block) {
    block.height_m = 0.0;
    block.load = 0.33;
  }
  o.blocks = blocks;
  o.odometry = odometry_;
  o.odometry->time = now;
  o.driver_instance = 7;
  o.scan = scan();
  return o;
}

void ToyHouse::tell(Observation & o)
{
  Pose told = pose_;
  told.x_m += told_error_.x_m;
  told.y_m += told_error_.y_m;
  told.yaw_rad = wrap_angle(told.yaw_rad + told_error_.yaw_rad);
  const Pose at = FrameTransform{site_.floor(told_floor_).pose_in_map}.to_frame(told);
  o.pose = StairPose{now, told_floor_, false, 0, at.y_m, wrap_angle(at.yaw_rad), Integrity::kOk, 0};
  o.pose->x_m = at.x_m;
  o.pose->covariance = Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal();
  if (lost) {
    o.pose->integrity = Integrity::kLost;
    o.pose->reasons = kProfileDisagrees;
  }
}

Observation ToyHouse::look()
{
  Observation o;
  if (flight_ != nullptr) {
    ToyRobot & robot = robots_.at(flight_->id());
    robot.resets = static_cast<std::uint32_t>(resets);
    o = robot.look();
    o.pose->x_m = robot.x_m;
    o.pose->covariance = Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
  } else {
    o = look_on_floor();
    tell(o);
    o.pose->resets = static_cast<std::uint32_t>(resets);
  }
  if (const auto place = place_on_floor(*o.pose, site_)) {
    const Pose here{place->position_m.x(), place->position_m.y(), 0.0, place->yaw_rad};
    const Pose told = FrameTransform{site_.floor(place->floor_id).pose_in_map}.to_map(here);
    if (last_told_) {
      worst_jump_m =
        std::max(worst_jump_m, std::hypot(told.x_m - last_told_->x_m, told.y_m - last_told_->y_m));
    }
    last_told_ = told;
  } else {
    last_told_.reset();
  }
  if (meddle) {
    meddle(o);
  }
  return o;
}

void ToyHouse::correct(const Correction & correction)
{
  if (flight_ != nullptr || correction.resets != static_cast<std::uint32_t>(resets)) {
    return;
  }
  const Pose at{
    correction.place.position_m.x(), correction.place.position_m.y(), 0.0,
    correction.place.yaw_rad};
  const Pose told = FrameTransform{site_.floor(correction.place.floor_id).pose_in_map}.to_map(at);
  const double off =
    std::hypot(told.x_m - pose_.x_m - told_error_.x_m, told.y_m - pose_.y_m - told_error_.y_m);
  const double turned = wrap_angle(told.yaw_rad - pose_.yaw_rad - told_error_.yaw_rad);
  const bool here = correction.place.floor_id == told_floor_;
  const bool near = !lost && here && off < kGate_m && std::abs(turned) < kGate_m;
  if (!near) {
    ++refused;
    lost = lost || refused >= 3;
    const bool agree = waiting_ && waiting_->place.floor_id == correction.place.floor_id &&
                       (waiting_->place.position_m - correction.place.position_m).norm() < 0.1 &&
                       waiting_->time != correction.time;
    waiting_ = correction;
    if (!lost || !agree) {
      return;
    }
    lost = false;
    told_floor_ = correction.place.floor_id;
    refused = 0;
    ++resets;
    waiting_.reset();
    last_told_.reset();
  }
  // standing, or rolling a tick or two: what was driven since the scan is left out
  const double share = near ? 0.5 : 1.0;
  told_error_.x_m += share * (told.x_m - pose_.x_m - told_error_.x_m);
  told_error_.y_m += share * (told.y_m - pose_.y_m - told_error_.y_m);
  told_error_.yaw_rad += share * turned;
}

}  // namespace stetro_supervisor
