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

#ifndef ACCURACY__PROGRESS_HPP_
#define ACCURACY__PROGRESS_HPP_

#include <chrono>
#include <cstddef>
#include <iosfwd>

namespace stetro_bringup
{

/// Shows how many climbs are done: one line rewritten on a terminal, a line a tenth elsewhere.
class CampaignProgress
{
public:
  CampaignProgress(std::ostream & out, bool terminal, std::size_t climbs);

  /// One climb more is done. \param simulated_s how long it took the robot [s]
  void done(double simulated_s);

  /// Ends the line that done() has been rewriting.
  void close();

private:
  std::ostream & out_;
  const bool terminal_;
  const std::size_t climbs_;
  const std::chrono::steady_clock::time_point started_;
  std::size_t done_ = 0;
  double simulated_s_ = 0.0;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__PROGRESS_HPP_
