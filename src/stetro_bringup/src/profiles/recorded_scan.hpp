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

#ifndef PROFILES__RECORDED_SCAN_HPP_
#define PROFILES__RECORDED_SCAN_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "stetro_supervisor/profile/range_profile.hpp"

namespace stetro_bringup
{

/// A scan that somebody recorded, and where the scanner stood as far as anybody knows.
struct RecordedScan
{
  std::int64_t stamp_ns = 0;
  stetro_supervisor::RangeProfile profile;
  stetro_supervisor::ScannerPose reference;  ///< on the map
  double turning_rad_s = 0.0;                ///< while the scan was taken
};

/// Rows of angle_min, angle_max, angle_increment, range_min, range_max, stamp_ns, ranges.
/** The format of `uw_tb4` and `rplidar_a1` in tests/recorded, one line of header. Without pose.
 *  \throws std::runtime_error naming file and row */
[[nodiscard]] std::vector<RecordedScan> read_scans(const std::string & path);

/// The scans of uw_tb4 within the span of their odometry, at the odometry's poses on the map.
/** \param run spiral, circle or line */
[[nodiscard]] std::vector<RecordedScan> uw_scans(
  const std::string & folder, const std::string & run);

/// The scans of dev1 to dev4 in tau_lab446a, at their calibrated poses on tau_fl4.
[[nodiscard]] std::vector<RecordedScan> tau_scans(const std::string & folder);

}  // namespace stetro_bringup

#endif  // PROFILES__RECORDED_SCAN_HPP_
