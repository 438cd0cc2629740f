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

#include "linux/motion/chassis_config.hpp"

#include <map>
#include <string>

#include "linux/servo/herkulex_registers.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr double kHalfPi = 1.57079632679489661923;
constexpr double kLowest = kRadPerCount * (kLowestCount - kCentreCount);
constexpr double kHighest = kRadPerCount * (kHighestCount - kCentreCount);
constexpr double kBeyondLevel = 0.05;  // a lift's way the other way: stroke less lowest riser [m]

const std::array<const char *, kWheels> kWheelNames{
  "front_left", "front_right", "rear_left", "rear_right"};
const std::array<const char *, kPair> kPairNames{"front", "rear"};

using Ids = std::map<std::int64_t, std::string>;

void take_id(Ids & ids, const std::string & name, std::int64_t id, stetro_config::Faults & faults)
{
  const auto [taken, is_new] = ids.emplace(id, name);
  if (!is_new) {
    faults.refuse(name, std::to_string(id), "an id of its own, not that of " + taken->second);
  }
}

// A joint's whole way has to be inside what its servo can reach.
void check_way(
  const std::string & name, const JointConfig & joint, double from_rad, double to_rad,
  stetro_config::Faults & faults)
{
  const double sense = joint.reversed ? -1.0 : 1.0;
  for (const double end : {joint.zero_rad + sense * from_rad, joint.zero_rad + sense * to_rad}) {
    if (end < kLowest || end > kHighest) {
      faults.refuse(
        name + ".zero_rad", std::to_string(joint.zero_rad),
        "one from which the servo's whole way, to " + std::to_string(end) + " rad, lies within " +
          std::to_string(kLowest) + " to " + std::to_string(kHighest));
    }
  }
}

void check_ids(const ChassisConfig & config, stetro_config::Faults & faults)
{
  Ids ids;
  for (std::size_t i = 0; i < kWheels; ++i) {
    if (config.wheels.wheels[i].id >= 0) {
      take_id(
        ids, "wheels." + std::string(kWheelNames[i]) + ".id", config.wheels.wheels[i].id, faults);
    }
  }
  if (ids.empty()) {
    faults.refuse("wheels", "none", "at least one wheel with an id");
  }
  for (std::size_t i = 0; i < kPair; ++i) {
    const std::string place = kPairNames[i];
    take_id(ids, "steering." + place + ".id", config.steering.joints[i].id, faults);
    take_id(ids, "lifts." + place + ".id", config.lifts.joints[i].id, faults);
  }
}

// A state of every servo and one jog have to fit into a period, with time for each to turn round.
void check_line(const ChassisConfig & config, stetro_config::Faults & faults)
{
  constexpr double kServos = kWheels + 2 * kPair;
  constexpr double kBits = 10.0 * (kServos * (9 + 26) + 8 + 4 * kServos);
  constexpr double kTurnRound = 0.0005;  // ours and the servo's, for each [s]
  const double needed_s = kBits / static_cast<double>(config.bus.port.baud) + kServos * kTurnRound;
  if (needed_s > config.period_s) {
    faults.refuse(
      "period_s", std::to_string(config.period_s),
      "at least " + std::to_string(needed_s) + " at this baud, or a faster line");
  }
  // A servo may miss twice before that is a fault: within three periods, if patience is short.
  if (config.bus.reply_timeout_s > config.period_s / 2.0) {
    faults.refuse(
      "bus.reply_timeout_s", std::to_string(config.bus.reply_timeout_s),
      "at most half of period_s, " + std::to_string(config.period_s / 2.0));
  }
}

}  // namespace

void check(const ChassisConfig & config, stetro_config::Faults & faults)
{
  if (config.bus.port.path.empty()) {
    faults.refuse("bus.path", stetro_config::kMissing, "the path of a serial device");
  }
  check_ids(config, faults);
  check_line(config, faults);
  const LiftsConfig & lifts = config.lifts;
  const double stroke_rad = lifts.stroke_m / lifts.m_per_rad;
  const double beyond_rad = kBeyondLevel / lifts.m_per_rad;
  check_way("lifts.front", lifts.joints[0], -beyond_rad, stroke_rad, faults);
  check_way("lifts.rear", lifts.joints[1], -stroke_rad, beyond_rad, faults);
  for (std::size_t i = 0; i < kPair; ++i) {
    check_way(
      "steering." + std::string(kPairNames[i]), config.steering.joints[i], 0.0, kHalfPi, faults);
  }
}

}  // namespace stetro_driver::linux_io
