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

#include "stetro_tests/truth.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace stetro_tests
{

namespace
{

double heading_of(const Truth & truth)
{
  const auto & q = truth.pose().pose().orientation();
  return 2.0 * std::atan2(q.z(), q.w());
}

}  // namespace

Displacement between(const Truth & from, const Truth & to)
{
  const auto & a = from.pose().pose().position();
  const auto & b = to.pose().pose().position();
  double blocks_m = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    blocks_m = std::max(blocks_m, std::abs(to.block_heights()[i] - from.block_heights()[i]));
  }
  return {
    std::hypot(b.x() - a.x(), b.y() - a.y(), b.z() - a.z()),
    std::abs(std::remainder(heading_of(to) - heading_of(from), 2.0 * M_PI)), blocks_m};
}

bool moved(const Displacement & displacement)
{
  constexpr double kStill = 1e-4;
  return displacement.position_m > kStill || displacement.heading_rad > kStill ||
         displacement.blocks_m > kStill;
}

std::chrono::nanoseconds last_motion(const Truths & truths)
{
  std::chrono::nanoseconds result{0};
  for (std::size_t i = 1; i < truths.size(); ++i) {
    if (moved(between(truths[i - 1].message, truths[i].message))) {
      result = time_of(truths[i].message);
    }
  }
  return result;
}

std::string to_string(const Truth & truth)
{
  const auto & position = truth.pose().pose().position();
  std::ostringstream text;
  text << "x " << position.x() << " y " << position.y() << " step " << truth.step_index()
       << " blocks";
  for (const double height : truth.block_heights()) {
    text << " " << height;
  }
  return text.str();
}

}  // namespace stetro_tests
