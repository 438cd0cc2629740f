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

#ifndef STETRO_TESTS__TRUTH_HPP_
#define STETRO_TESTS__TRUTH_HPP_

#include <chrono>
#include <string>
#include <vector>

#include "stetro_msgs/StairPose.hpp"
#include "stetro_tests/probe.hpp"

namespace stetro_tests
{

using Truth = stetro_msgs::msg::StairPose;
using Truths = std::vector<Probe<Truth>::Sample>;

/// How far two truths lie apart.
struct Displacement
{
  double position_m;  ///< of base_link
  double heading_rad;
  double blocks_m;  ///< of the block that moved most
};
Displacement between(const Truth & from, const Truth & to);

/// More than a body that stands on its wheels shakes: 0.1 mm or 0.1 mrad.
bool moved(const Displacement & displacement);

/// Stamp of the last truth that differs from the one before it; zero if nothing moved.
std::chrono::nanoseconds last_motion(const Truths & truths);

/// "x 0.235 y 1.025 step 3 blocks 0.14 0 0", for the message of a failure.
std::string to_string(const Truth & truth);

}  // namespace stetro_tests

#endif  // STETRO_TESTS__TRUTH_HPP_
