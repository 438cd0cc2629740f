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

#ifndef LINUX__MOTION__CHASSIS_CONFIG_HPP_
#define LINUX__MOTION__CHASSIS_CONFIG_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "linux/servo/herkulex_bus.hpp"
#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"

namespace stetro_driver::linux_io
{

constexpr std::size_t kWheels = 4;
constexpr std::size_t kPair = 2;  ///< front and rear: of steering servos, and of lifts

/// A driven wheel and the servo that turns it.
struct WheelConfig
{
  std::int64_t id = -1;  ///< of its servo; -1: there is no such wheel
  double x_m = 0.0;      ///< of its contact in base_link, seen from above [m]
  double y_m = 0.0;
  bool reversed = false;  ///< the servo's positive sense rolls the robot back
};

/// Wheels that all roll in the direction the steering gives them.
struct WheelsConfig
{
  double diameter_m = 0.048;      ///< the papers' robot
  double full_speed_rad_s = 7.1;  ///< of a wheel at full PWM: measure it
  std::array<WheelConfig, kWheels> wheels{
    {{1, 0.15, 0.08, false},
     {2, 0.15, -0.08, true},
     {3, -0.15, 0.08, false},
     {4, -0.15, -0.08, true}}};
};

/// One servo that turns a part to and fro.
struct JointConfig
{
  std::int64_t id = 0;
  double zero_rad = 0.0;  ///< where the servo stands when the joint is at zero, from its middle
  bool reversed = false;  ///< the servo's positive sense is the joint's negative one
};

/// Front and rear steering. Zero rolls along x, pi/2 along y.
struct SteeringConfig
{
  double speed_rad_s = 1.6;
  std::array<JointConfig, kPair> joints{{{5, -0.785, false}, {6, -0.785, false}}};
};

/// The lifts in block 2: the front one moves block 1 against it, the rear one block 3.
/** Zero is level. Positive lifts the outer block, or lowers block 2 when that is in the air. */
struct LiftsConfig
{
  double m_per_rad = 0.045;  ///< of block for a turn of the servo
  double speed_m_s = 0.06;
  double stroke_m = 0.18;
  std::array<JointConfig, kPair> joints{{{7, -1.6, false}, {8, 1.6, false}}};
};

/// Wheels, steering and lifts on one line of servos.
struct ChassisConfig
{
  HerkulexBusConfig bus{};
  double period_s = 0.02;           ///< all servos are asked and told once in it
  double command_timeout_s = 0.25;  ///< then it holds
  std::string blocks_file;          ///< a parameter of the driver's, not of the robot file
  WheelsConfig wheels{};
  SteeringConfig steering{};
  LiftsConfig lifts{};
};

template <class Visitor>
void visit(WheelConfig & p, Visitor && each)
{
  using stetro_config::Within;
  each("id", p.id, Within{-1, 253}, "of its servo; -1: there is no such wheel");
  each("x_m", p.x_m, Within{-0.5, 0.5}, "of its contact in base_link [m]");
  each("y_m", p.y_m, Within{-0.5, 0.5}, "of its contact in base_link [m]");
  each("reversed", p.reversed, stetro_config::Any{}, "the servo's positive sense rolls back");
}

template <class Visitor>
void visit(WheelsConfig & p, Visitor && each)
{
  using stetro_config::Group;
  using stetro_config::Within;
  each("diameter_m", p.diameter_m, Within{0.01, 0.5}, "of a wheel [m]");
  each("full_speed_rad_s", p.full_speed_rad_s, Within{0.1, 50.0}, "of a wheel, full PWM [rad/s]");
  visit(p.wheels[0], Group{"front_left", each});
  visit(p.wheels[1], Group{"front_right", each});
  visit(p.wheels[2], Group{"rear_left", each});
  visit(p.wheels[3], Group{"rear_right", each});
}

template <class Visitor>
void visit(JointConfig & p, Visitor && each)
{
  using stetro_config::Within;
  each("id", p.id, Within{0, 253}, "of its servo");
  each("zero_rad", p.zero_rad, Within{-2.7, 2.7}, "servo angle at the joint's zero [rad]");
  each("reversed", p.reversed, stetro_config::Any{}, "servo and joint turn opposite ways");
}

template <class Visitor>
void visit(SteeringConfig & p, Visitor && each)
{
  using stetro_config::Group;
  each("speed_rad_s", p.speed_rad_s, stetro_config::Within{0.1, 5.0}, "of turning [rad/s]");
  visit(p.joints[0], Group{"front", each});
  visit(p.joints[1], Group{"rear", each});
}

template <class Visitor>
void visit(LiftsConfig & p, Visitor && each)
{
  using stetro_config::Group;
  using stetro_config::Within;
  each("m_per_rad", p.m_per_rad, Within{0.005, 0.2}, "of block for a turn of the servo [m/rad]");
  each("speed_m_s", p.speed_m_s, Within{0.005, 0.2}, "of a block [m/s]");
  each("stroke_m", p.stroke_m, Within{0.02, 0.5}, "of a lift, from where its block stood [m]");
  visit(p.joints[0], Group{"front", each});
  visit(p.joints[1], Group{"rear", each});
}

template <class Visitor>
void visit(ChassisConfig & p, Visitor && each)
{
  using stetro_config::Group;
  using stetro_config::Within;
  visit(p.bus, Group{"bus", each});
  each("period_s", p.period_s, Within{0.01, 0.2}, "all servos are asked once in it [s]");
  each("command_timeout_s", p.command_timeout_s, Within{0.05, 1.0}, "then it holds [s]");
  visit(p.wheels, Group{"wheels", each});
  visit(p.steering, Group{"steering", each});
  visit(p.lifts, Group{"lifts", each});
}

/// What contradicts each other: ids used twice, ways the servos cannot reach, a line too slow.
void check(const ChassisConfig & config, stetro_config::Faults & faults);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__CHASSIS_CONFIG_HPP_
