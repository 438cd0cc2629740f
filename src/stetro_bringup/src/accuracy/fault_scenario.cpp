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

#include "accuracy/fault_scenario.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "stetro_driver/sim_faults.hpp"

namespace stetro_bringup
{
namespace
{

// A climb takes about 30 s to the stairs and 50 s a step; the first tread is swept by then.
constexpr double kFirstTreadSwept_s = 100.0;
constexpr double kStep_s = 50.0;
constexpr double kLatestShare = 0.75;
constexpr double kShareOfTreads = 0.5;  // on which `steps` strikes

/// Draws that are the same on every machine: the standard's distributions are not.
class Draw
{
public:
  Draw(std::uint64_t seed, const std::string & scenario) : random_(seed)
  {
    for (const char letter : scenario) {  // another scenario, other draws
      random_.seed(random_() ^ static_cast<std::uint64_t>(letter));
    }
  }

  double uniform(double low, double high)
  {
    constexpr double kUnit = 1.0 / 18446744073709551616.0;  // 2^-64
    return low + (high - low) * static_cast<double>(random_()) * kUnit;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  double either_way(double size) { return below(2) == 0 ? size : -size; }

private:
  std::mt19937_64 random_;
};

struct Device
{
  const char * name;
  TellingMotion dead;  ///< what tells that it is dead
  TellingMotion any;   ///< and any other fault
};
constexpr std::array<Device, 17> kDevices{{
  {"side_left", TellingMotion::kNearLeftWall, TellingMotion::kNearLeftWall},
  {"side_right", TellingMotion::kNearRightWall, TellingMotion::kNearRightWall},
  {"front_left", TellingMotion::kAlong, TellingMotion::kAlong},
  {"front_right", TellingMotion::kAlong, TellingMotion::kAlong},
  {"stair_front", TellingMotion::kAny, TellingMotion::kAlong},
  {"block1_down", TellingMotion::kAny, TellingMotion::kBlock1Rises},
  {"block2_down", TellingMotion::kAny, TellingMotion::kBlock2Rises},
  {"block3_front", TellingMotion::kAny, TellingMotion::kBlock2Clears},
  {"gyro", TellingMotion::kTurning, TellingMotion::kTurning},
  {"left_front", TellingMotion::kAny, TellingMotion::kAtLeftWall},
  {"left_middle", TellingMotion::kAny, TellingMotion::kAtLeftWall},
  {"left_rear", TellingMotion::kAny, TellingMotion::kAtLeftWall},
  {"right_front", TellingMotion::kAny, TellingMotion::kAtRightWall},
  {"right_middle", TellingMotion::kAny, TellingMotion::kAtRightWall},
  {"right_rear", TellingMotion::kAny, TellingMotion::kAtRightWall},
  {"riser_left", TellingMotion::kAny, TellingMotion::kAtRiser},
  {"riser_right", TellingMotion::kAny, TellingMotion::kAtRiser},
}};
constexpr std::size_t kCorrecting = 4;  // the first ones: ranges that the estimate stands on

std::string at(const std::string & head, double from_s)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "@%.2f", from_s);
  return head + text.data();
}

std::string at(const std::string & head, double from_s, double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "=%.4f", value);
  return at(head, from_s) + text.data();
}

TellingMotion telling_of(const Device & device, bool dead)
{
  return dead ? device.dead : device.any;
}

DrawnFaults at_a_range(
  Draw & draw, const std::string & kind, double from_s, std::optional<double> value)
{
  const Device & device = kDevices[draw.below(kCorrecting)];
  const std::string head = kind + ":" + device.name;
  return {value ? at(head, from_s, *value) : at(head, from_s), FaultOnset{from_s, device.any}};
}

DrawnFaults at_any_device(Draw & draw, const std::string & kind, double from_s)
{
  const Device & device = kDevices[draw.below(kDevices.size())];
  return {
    at(kind + ":" + device.name, from_s), FaultOnset{from_s, telling_of(device, kind == "dead")}};
}

DrawnFaults on_the_steps(Draw & draw, int steps)
{
  DrawnFaults drawn;
  for (int tread = 0; tread < steps; ++tread) {
    const double from_s = kFirstTreadSwept_s + kStep_s * (tread + draw.uniform(0.0, 1.0));
    const bool strikes = draw.uniform(0.0, 1.0) < kShareOfTreads;
    const double slip_m = draw.either_way(draw.uniform(0.01, 0.04));
    const std::array<std::string, 4> kinds{
      at("slip", from_s, slip_m), at("missed_touchdown", from_s), at("double_touchdown", from_s),
      at("old_tread", from_s)};
    const std::string & chosen = kinds[draw.below(kinds.size())];
    if (strikes) {
      drawn.text += (drawn.text.empty() ? "" : ",") + chosen;
    }
  }
  return drawn;
}

DrawnFaults as_written(const std::string & text)
{
  const auto faults = stetro_driver::parse_sim_faults(text);
  const auto device = std::find_if(kDevices.begin(), kDevices.end(), [&](const Device & d) {
    return d.name == faults.front().device;
  });
  const bool dead = faults.front().kind == stetro_driver::SimFaultKind::kDead;
  return {
    text, FaultOnset{
            faults.front().from_s,
            device != kDevices.end() ? telling_of(*device, dead) : TellingMotion::kAny}};
}

[[noreturn]] void refuse(const std::string & name)
{
  std::string accepted = "all";
  for (const std::string & one : fault_scenarios()) {
    accepted += ", " + one;
  }
  throw std::invalid_argument("faults: '" + name + "' refused, accepted: " + accepted);
}

}  // namespace

DrawnFaults draw_faults(const std::string & scenario, std::uint64_t seed, int steps)
{
  if (scenario.find('@') != std::string::npos) {
    return as_written(scenario);
  }
  Draw draw(seed, scenario);
  const double latest_s = std::max(kLatestShare * kStep_s * steps, kFirstTreadSwept_s + kStep_s);
  const double from_s = draw.uniform(kFirstTreadSwept_s, latest_s);
  if (scenario == "dead" || scenario == "stuck") {
    return at_any_device(draw, scenario, from_s);
  }
  if (scenario == "spike") {
    return at_a_range(draw, scenario, from_s, 0.2);
  }
  if (scenario == "offset_jump") {
    return at_a_range(draw, scenario, from_s, draw.either_way(0.05));
  }
  if (scenario == "gain_change") {
    return at_a_range(draw, scenario, from_s, draw.either_way(0.1));
  }
  if (scenario == "drifting") {
    return at_a_range(draw, "drift", from_s, draw.either_way(0.002));
  }
  if (scenario == "late") {
    return at_a_range(draw, scenario, from_s, 0.5);
  }
  if (scenario == "gyro_bias_jump") {
    return {
      at("bias_jump:gyro", from_s, draw.either_way(0.02)), FaultOnset{from_s, TellingMotion::kAny}};
  }
  if (scenario == "no_side_ranges") {
    return {
      at("dead:side_left", from_s) + "," + at("dead:side_right", from_s),
      FaultOnset{from_s, TellingMotion::kAny}};
  }
  if (scenario == "steps") {
    return on_the_steps(draw, steps);
  }
  refuse(scenario);
}

const std::vector<std::string> & fault_scenarios()
{
  static const std::vector<std::string> all{"dead",           "stuck",    "spike", "offset_jump",
                                            "gain_change",    "drifting", "late",  "gyro_bias_jump",
                                            "no_side_ranges", "steps"};
  return all;
}

std::vector<std::string> chosen_scenarios(const std::vector<std::string> & asked)
{
  const auto & known = fault_scenarios();
  std::vector<std::string> chosen;
  for (const std::string & name : asked) {
    if (name == "all") {
      chosen.insert(chosen.end(), known.begin(), known.end());
    } else if (
      name.find('@') != std::string::npos ||
      std::find(known.begin(), known.end(), name) != known.end()) {
      chosen.push_back(name);
    } else {
      refuse(name);
    }
  }
  return chosen;
}

}  // namespace stetro_bringup
