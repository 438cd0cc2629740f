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

#include "sim/sim_world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/archive.hpp"

namespace stetro_driver
{
namespace
{

constexpr double kTickSeconds = 0.01;
constexpr double kOldTreadRoll = 0.15;  // what block 2's roll onto the next tread takes [m]

}  // namespace

SimRobot::World::World(
  const BuildingShape & building_shape, const BodyShape & body_shape,
  const SimOptions & sim_options)
: options(sim_options),
  shape(body_shape),
  identity(identity_of(building_shape, body_shape, sim_options)),
  building(building_shape, options.as_built ? &options.errors : nullptr, options.seed),
  present(building_shape.start),
  lifts(options.errors, options.seed),
  body(shape, building.flight(present).world, options.errors.squaring, lifts.lock_error_m()),
  wheels(options.errors, options.seed),
  gyro(options.errors, options.seed),
  contacts(options.errors, options.seed),
  ranges(shape, options.errors, options.seed, options.ranges_at_once),
  faults(options.faults),
  kidnap_random(options.seed, "kidnap"),
  time(options.origin)
{
  put_at_start(building_shape.flights[present].shape);
  if (options.lidar) {
    lidar.emplace(shape.lidar, options.errors, options.seed);
    frame.scan = &lidar->scan();
  }
  contacts.observe(body, time, faults);
  compose_frame();
}

void SimRobot::World::open_snapshot()
{
  if (options.snapshot_path.empty()) {
    return;
  }
  const std::vector<std::uint8_t> fresh = state();
  snapshot = std::make_unique<sim::SnapshotFile>(options.snapshot_path, identity, fresh.size());
  resume_outcome = snapshot->found().outcome;
  resume_detail = snapshot->found().detail;
  if (resume_outcome == ResumeOutcome::kResumed && !resume(snapshot->found().bytes)) {
    static_cast<void>(resume(fresh));
    snapshot->refuse_found("its state has another layout");
    resume_outcome = snapshot->found().outcome;
    resume_detail = snapshot->found().detail;
  }
  if (resume_outcome != ResumeOutcome::kResumed) {
    stored_ = fresh;
    snapshot->store(stored_);
  }
}

/// Takes a state over. \return whether it was one, to its last byte
bool SimRobot::World::resume(const std::vector<std::uint8_t> & bytes)
{
  sim::StateReader reader{bytes};
  archive(reader);
  if (present >= building.flights().size()) {
    present = 0;
    return false;
  }
  surround();
  faults.advance(time_to_seconds(time - options.origin));
  compose_frame();
  return reader.exhausted();
}

void SimRobot::World::hold() { command = JointCommand{}; }

void SimRobot::World::tick()
{
  begin_tick();
  const bool may_move =
    active && !safe.load() && body.fall() == sim::Fall::kNone && !contacts.emergency_stop_latched();
  if (!may_move) {
    hold();
  }
  end_tick(actuate());
}

void SimRobot::World::tick(const SimActuation & moved)
{
  begin_tick();
  end_tick(actuate(moved));
}

void SimRobot::World::begin_tick()
{
  ++ticks;
  time += SimRobot::kTick;
  faults.advance(time_to_seconds(time - options.origin));
  strike_faults();
}

void SimRobot::World::end_tick(const sim::WheelSpeeds & told)
{
  const double yaw_before_rad = body.pose().yaw_rad;
  move(told);
  const double turned_rad = body.pose().yaw_rad - yaw_before_rad;
  settle();
  note_driving();
  measure(turned_rad / kTickSeconds);
  compose_frame();
  if (snapshot) {
    stored_.clear();
    sim::StateWriter writer{stored_};
    archive(writer);
    snapshot->store(stored_);
  }
}

/// What is due on a floor waits for the robot to drive there, all blocks down.
void SimRobot::World::note_driving()
{
  const bool drives = command.kind == MotionKind::kTwist && body.level() &&
                      (command.vx_m_s != 0.0 || command.vy_m_s != 0.0 || command.wz_rad_s != 0.0);
  const std::size_t floor = drives ? drawn_floor() : kNoFloor;
  if (floor != kNoFloor) {
    faults.drive(building.floor(floor).id, kTickSeconds);
  }
}

void SimRobot::World::strike_faults()
{
  if (const SimFault * slip = faults.strike(SimFaultKind::kSlip)) {
    wheels.slip(slip->value);
  }
  if (const SimFault * carried = faults.strike(SimFaultKind::kKidnap)) {
    kidnap(carried->value);
  }
  contacts.press_emergency_stop(faults.acting(SimFaultKind::kEmergencyStop) != nullptr, time);
}

sim::WheelSpeeds SimRobot::World::actuate()
{
  lift_moved.fill(false);
  steering.moving = false;
  switch (command.kind) {
    case MotionKind::kTwist:
      return {command.vx_m_s, command.vy_m_s, command.wz_rad_s};
    case MotionKind::kLift:
      lift(command.block, shape.lift_speed_m_s * kTickSeconds);
      return {};
    case MotionKind::kLower:
      lift(command.block, -shape.lift_speed_m_s * kTickSeconds);
      return {};
    case MotionKind::kSteer: {
      const double most_rad = shape.steer_speed_rad_s * kTickSeconds;
      const double left_rad = command.steering_rad - steering.angle_rad;
      steering.target_rad = command.steering_rad;
      steering.moving = std::abs(left_rad) > most_rad;
      steering.angle_rad += std::clamp(left_rad, -most_rad, most_rad);
      return {};
    }
    default:
      return {};
  }
}

sim::WheelSpeeds SimRobot::World::actuate(const SimActuation & moved)
{
  lift_moved.fill(false);
  for (int block = 1; block <= 3; ++block) {
    lift(block, moved.lifted_m[static_cast<std::size_t>(block - 1)]);
  }
  steering.moving = steering.angle_rad != moved.steering_rad;
  steering.angle_rad = moved.steering_rad;
  return {moved.vx_m_s, moved.vy_m_s, moved.wz_rad_s};
}

void SimRobot::World::lift(int block, double up_m)
{
  const double before_m = body.underside_m(block);
  if (up_m > 0.0) {
    body.lift(block, up_m);
  } else if (up_m < 0.0) {
    body.lower(block, -up_m);
  }
  lift_moved[static_cast<std::size_t>(block - 1)] = body.underside_m(block) != before_m;
}

void SimRobot::World::move(const sim::WheelSpeeds & told)
{
  const sim::Displacement displacement = wheels.roll(told, kTickSeconds);
  slip_onto_old_tread(told);
  if (!old_tread) {
    body.move(displacement);
  }
  lifts.observe(body, ticks, faults);
}

void SimRobot::World::slip_onto_old_tread(const sim::WheelSpeeds & told)
{
  if (!old_tread && body.at_upper_lock(2) && faults.strike(SimFaultKind::kOldTread)) {
    old_tread = true;
    old_tread_rolled_m = 0.0;
  }
  if (!old_tread) {
    return;
  }
  old_tread_rolled_m += told.vx_m_s * kTickSeconds;
  const bool arrived = old_tread_rolled_m >= kOldTreadRoll;
  const double recess_m =
    shape.block_x_m(3) + shape.block_length_m / 2.0 -
    shape.tof[static_cast<std::size_t>(RangePlace::kBlock3Front)].position_m.x;
  old_tread = !body.standing(2);
  ranges.feign_block3_front(
    old_tread ? std::optional{recess_m + (arrived ? 0.0 : kOldTreadRoll - old_tread_rolled_m)}
              : std::nullopt);
}

void SimRobot::World::measure(double yaw_rate_rad_s)
{
  contacts.observe(body, time, faults);
  ranges.observe(body, ticks, time, faults);
  gyro.measure(yaw_rate_rad_s, time, faults);
  frame.scan_complete =
    lidar && lidar->observe(body, building, present, drawn_floor(), *clutter, ticks, time);
}

void SimRobot::World::compose_frame()
{
  if (command.kind != MotionKind::kSteer) {
    steering.target_rad = steering.angle_rad;
  }
  frame.time = time;
  frame.contacts = contacts.readings();
  frame.emergency_stop_latched = contacts.emergency_stop_latched();
  frame.ranges_complete = ranges.deliver(ticks, time, faults, frame.ranges);
  frame.blocks_stamp = frame.time;
  frame.blocks = lifts.measure(body, command, ticks, lift_moved);
  frame.steering = steering;
  frame.gyro = gyro.reading();
  frame.odometry = wheels.odometry(time);
}

std::vector<std::uint8_t> SimRobot::World::state()
{
  std::vector<std::uint8_t> bytes;
  sim::StateWriter writer{bytes};
  archive(writer);
  return bytes;
}

}  // namespace stetro_driver
