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

#ifndef LINUX__LINES__CONTACT_LINES_CONFIG_HPP_
#define LINUX__LINES__CONTACT_LINES_CONFIG_HPP_

#include <array>
#include <cstdint>
#include <string>

#include "linux/lines/line_port.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::linux_io
{

/// Where one switch is wired.
struct ContactLineConfig
{
  std::string chip = "gpiochip0";
  std::int64_t line = 0;
  std::string active = "low";
  std::string bias = "pull_up";

  [[nodiscard]] bool fitted() const { return chip != "none"; }
  [[nodiscard]] LineRequest request() const
  {
    const LineBias pull = bias == "pull_up"     ? LineBias::kPullUp
                          : bias == "pull_down" ? LineBias::kPullDown
                                                : LineBias::kNone;
    return {chip, static_cast<unsigned int>(line), active == "low", pull};
  }
};

/// The robot's switches, and when they are believed.
/** As docs/hardware/lines.md wires them: bumpers and riser switches close to ground; the emergency
 * stop opens from ground, so that a broken wire stops the robot. */
struct ContactLinesConfig
{
  double poll_s = 0.02;
  double release_s = 0.015;
  std::int64_t most_edges_per_s = 200;
  /// In the order of ContactPlace.
  std::array<ContactLineConfig, kContactPlaces> lines{{
    {"gpiochip0", 5, "low", "pull_up"},
    {"gpiochip0", 6, "low", "pull_up"},
    {"gpiochip0", 12, "low", "pull_up"},
    {"gpiochip0", 13, "low", "pull_up"},
    {"gpiochip0", 16, "low", "pull_up"},
    {"gpiochip0", 19, "low", "pull_up"},
    {"gpiochip0", 20, "low", "pull_up"},
    {"gpiochip0", 21, "low", "pull_up"},
    {"gpiochip0", 26, "high", "pull_up"},
  }};
};

template <class Visitor>
void visit(ContactLineConfig & c, Visitor && each)
{
  using stetro_config::OneOf;
  each("chip", c.chip, stetro_config::NonEmpty{}, "name, label or path of the chip, or none");
  each("line", c.line, stetro_config::Within{0, 511}, "offset of the line in its chip");
  each("active", c.active, OneOf{"low", "high"}, "level while the switch is pressed");
  each(
    "bias", c.bias, OneOf{"pull_up", "pull_down", "none"}, "what holds the level of an open line");
}

template <class Visitor>
void visit(ContactLinesConfig & c, Visitor && each)
{
  using stetro_config::Within;
  each(
    "poll_s", c.poll_s, Within{0.001, 0.1},
    "levels are read at least so often; silent after three of them [s]");
  each("release_s", c.release_s, Within{0.001, 0.1}, "open for so long, then it is released [s]");
  each(
    "most_edges_per_s", c.most_edges_per_s, Within{20, 10000},
    "more of them are a loose wire and no switch [1/s]");
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    visit(c.lines[i], stetro_config::Group{std::string(kContactNames[i]), each});
  }
}

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINES__CONTACT_LINES_CONFIG_HPP_
