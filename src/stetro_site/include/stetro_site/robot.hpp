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

#ifndef STETRO_SITE__ROBOT_HPP_
#define STETRO_SITE__ROBOT_HPP_

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_site
{

/// How fast the robot does what it does.
struct Speeds
{
  double sweep_m_s = 0.15;             ///< along a tread [m/s]
  double roll_m_s = 0.05;              ///< forward and back on a step [m/s]
  double creep_m_s = 0.02;             ///< where it expects to touch [m/s]
  double lift_m_s = 0.06;              ///< raising and lowering a block [m/s]
  double steer_rad_s = 1.6;            ///< turning the wheels [rad/s]
  double yaw_correction_rad_s = 0.10;  ///< turning the body back to the riser [rad/s]
};

template <class Visitor>
void visit(Speeds & p, Visitor && each)
{
  using stetro_config::Within;
  each("sweep_m_s", p.sweep_m_s, Within{0.01, 1.0}, "along a tread [m/s]");
  each("roll_m_s", p.roll_m_s, Within{0.005, 0.5}, "forward and back on a step [m/s]");
  each("creep_m_s", p.creep_m_s, Within{0.001, 0.2}, "where it expects to touch [m/s]");
  each("lift_m_s", p.lift_m_s, Within{0.005, 0.5}, "raising and lowering a block [m/s]");
  each("steer_rad_s", p.steer_rad_s, Within{0.1, 10.0}, "turning the wheels [rad/s]");
  each(
    "yaw_correction_rad_s", p.yaw_correction_rad_s, Within{0.01, 1.0},
    "turning the body back to the riser [rad/s]");
}

/// What the robot file says.
struct Robot
{
  std::string name = "stetro";
  RobotGeometry geometry;
  Speeds speeds;
  YAML::Node devices;  ///< of the Linux backend, as written and not yet judged; null without any
  std::string file;    ///< that the devices stand in, for faults
};

template <class Visitor>
void visit(Robot & p, Visitor && each)
{
  each("name", p.name, stetro_config::Identifier{}, "of this robot");
  visit(p.geometry, each);
  visit(p.speeds, stetro_config::Group{"speeds", each});
}

inline void check(const Robot & robot, stetro_config::Faults & faults)
{
  check(robot.geometry, faults);
}

/// Reads a robot file, in which every name is given. Nothing if a fault was added.
[[nodiscard]] std::optional<Robot> read_robot(
  const std::string & path, stetro_config::Faults & faults);

/// Reads a robot file. \throws stetro_config::ConfigError with every fault
[[nodiscard]] Robot load_robot(const std::string & path);

}  // namespace stetro_site

#endif  // STETRO_SITE__ROBOT_HPP_
