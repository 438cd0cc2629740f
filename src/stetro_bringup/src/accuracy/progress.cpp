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

#include "accuracy/progress.hpp"

#include <array>
#include <cstdio>
#include <ostream>
#include <string>

namespace stetro_bringup
{
namespace
{

constexpr std::size_t kBarWidth = 32;
constexpr std::size_t kLines = 10;  // where lines cannot be rewritten

}  // namespace

CampaignProgress::CampaignProgress(std::ostream & out, bool terminal, std::size_t climbs)
: out_(out), terminal_(terminal), climbs_(climbs), started_(std::chrono::steady_clock::now())
{
}

void CampaignProgress::done(double simulated_s)
{
  ++done_;
  simulated_s_ += simulated_s;
  const bool tells = terminal_ || done_ * kLines / climbs_ != (done_ - 1) * kLines / climbs_;
  if (!tells) {
    return;
  }
  const std::size_t full = kBarWidth * done_ / climbs_;
  const double wall_s =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  std::array<char, 160> text{};
  std::snprintf(
    text.data(), text.size(), "[%s%s] climb %zu of %zu  %.0f s, %.0f times real time",
    std::string(full, '#').c_str(), std::string(kBarWidth - full, '.').c_str(), done_, climbs_,
    wall_s, simulated_s_ / wall_s);
  out_ << (terminal_ ? "\r" : "") << text.data() << (terminal_ ? " " : "\n") << std::flush;
}

void CampaignProgress::close()
{
  if (terminal_ && done_ > 0) {
    out_ << std::endl;
  }
}

}  // namespace stetro_bringup
