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
#include "progress.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ostream>

namespace stetro_bringup
{
namespace
{

constexpr int kBarWidth = 32;

std::string bar(int step, int count)
{
  const int full = count > 0 ? std::clamp(kBarWidth * step / count, 0, kBarWidth) : 0;
  const auto done = static_cast<std::size_t>(full);
  return '[' + std::string(done, '#') + std::string(kBarWidth - done, '.') + ']';
}

std::string place_of(const MissionView & mission)
{
  if (mission.step_count == 0) {
    return mission.segment;
  }
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "step %2d of %d", mission.step, mission.step_count);
  return text.data();
}

}  // namespace

Progress::Progress(std::ostream & out, bool terminal) : out_(out), terminal_(terminal) {}

void Progress::show(const MissionView & mission, double y_m, double simulated_s)
{
  std::array<char, 200> text{};
  if (terminal_) {
    std::snprintf(
      text.data(), text.size(), "\r%s %s  %-18s y %5.2f m  %4d:%02d simulated ",
      bar(mission.step, mission.step_count).c_str(), place_of(mission).c_str(),
      mission.state.c_str(), y_m, static_cast<int>(simulated_s) / 60,
      static_cast<int>(simulated_s) % 60);
    out_ << text.data() << std::flush;
    last_ = "shown";
    return;
  }
  if (last_ == place_of(mission)) {
    return;
  }
  last_ = place_of(mission);
  out_ << last_ << "  " << bar(mission.step, mission.step_count) << "  "
       << static_cast<int>(simulated_s) << " s simulated" << std::endl;
}

void Progress::close()
{
  if (terminal_ && !last_.empty()) {
    out_ << std::endl;
  }
}

}  // namespace stetro_bringup
