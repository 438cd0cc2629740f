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

#ifndef SERVO_LINE_HPP_
#define SERVO_LINE_HPP_

#include <string>

#include "device_bench.hpp"
#include "emulator/herkulex_emulator.hpp"
#include "linux/motion/chassis_config.hpp"
#include "pty_name.hpp"

namespace stetro_driver::test
{

/// Patience with emulated servos: of a computer that tests share, not of a robot.
constexpr double kPatienceS = 0.1;

/// The line of a test: a fast one, so that tests are about something else than time.
inline emulator::HerkulexLine fast_line(const std::string & name)
{
  emulator::HerkulexLine line;
  line.link = pty_name(name);
  line.baud = 1'000'000;
  return line;
}

inline linux_io::HerkulexBusConfig bus_config(const emulator::HerkulexLine & line)
{
  return {{line.link, line.baud}, kPatienceS};
}

}  // namespace stetro_driver::test

#endif  // SERVO_LINE_HPP_
