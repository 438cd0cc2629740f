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

#ifndef PROFILES__PROFILE_PICTURES_HPP_
#define PROFILES__PROFILE_PICTURES_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "profiles/logs_suite.hpp"
#include "profiles/maps_suite.hpp"
#include "profiles/recorded_floor.hpp"

namespace stetro_bringup
{

/// Tables that plots/profiles.gp draws, written into a folder.
/** \throws std::runtime_error naming a file that cannot be written */
struct ProfilePictures
{
  std::string folder;
  std::vector<std::string> maps;  ///< names of the usability pictures
  std::vector<std::string> logs;  ///< names of the pictures of one scan each
  bool convergence = false;

  /// usability_<name>.csv (x, y, spectral radius of the guarded and of the published steps, worst
  /// sigma) and walls_<name>.csv of each floor.
  void add_maps(const std::vector<RecordedFloor> & floors);

  /// convergence.csv: the published search's median error after each step, by spectral radius.
  void add_convergence(const std::vector<MapsTable> & tables);

  /// scan_<name>.csv (an end each, and what became of the beam), places_<name>.csv (reference,
  /// belief, pose found, centroids, steps of the published search), of each log's middle scan.
  void add_logs(const std::vector<RecordedLog> & logs, std::uint64_t seed);
};

}  // namespace stetro_bringup

#endif  // PROFILES__PROFILE_PICTURES_HPP_
