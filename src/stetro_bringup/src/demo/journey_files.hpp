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

#ifndef DEMO__JOURNEY_FILES_HPP_
#define DEMO__JOURNEY_FILES_HPP_

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "stetro_bringup/journey_report.hpp"
#include "stetro_bringup/trace.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_site/site.hpp"

namespace stetro_bringup
{

/// What the supervisor said of the pose on a floor.
struct CheckSample
{
  std::chrono::nanoseconds stamp{0};  ///< of the scan
  std::string segment;                ///< floor whose plan was used; empty: none explains the scan
  std::string verdict;                ///< agrees, corrected, ambiguous, no verdict
  stetro_site::Pose in_map{};         ///< that explains the scan best; NaN without one
};

/// The way through a building as files that `journey.gp` draws, all in `map`.
/**
 * `walls.csv`, lines of floors' walls and flights' treads, an empty line between two; `path.csv`, a
 * row an estimate; `checks.csv`, a row an answer of the profile check; `kidnaps.csv`.
 */
class JourneyFiles
{
public:
  /// \throws std::runtime_error if a file in the folder cannot be written
  JourneyFiles(const std::string & folder, const stetro_site::Site & site);

  void add(const TraceRow & row);
  void add(const CheckSample & check);

  /// Completes the files.
  void close(const std::vector<Kidnap> & kidnaps);

private:
  SegmentFrames frames_;
  std::ofstream path_;
  std::ofstream checks_;
  std::ofstream kidnaps_;
};

/// A file to write. \throws std::runtime_error if it cannot be
[[nodiscard]] std::ofstream opened(const std::string & path);

}  // namespace stetro_bringup

#endif  // DEMO__JOURNEY_FILES_HPP_
