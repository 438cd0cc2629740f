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

#ifndef PROFILES__LOGS_SUITE_HPP_
#define PROFILES__LOGS_SUITE_HPP_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "profiles/recorded_floor.hpp"
#include "profiles/recorded_scan.hpp"
#include "stetro_supervisor/profile/profile_finding.hpp"

namespace stetro_bringup
{

/// Recorded scans and the map they are checked on.
struct RecordedLog
{
  std::string name;
  RecordedFloor floor;
  std::vector<RecordedScan> scans;
  double right_m = 0.10;      ///< of the reference: a verdict within is right
  double right_rad = 0.0524;  ///< 3 degrees
};

/// What one check of a recorded scan ended with.
struct LogCase
{
  std::size_t number = 0;  ///< of the scan in its log
  stetro_supervisor::Verdict verdict = stetro_supervisor::Verdict::kNoVerdict;
  stetro_supervisor::NoVerdictReason reason = stetro_supervisor::NoVerdictReason::kNone;
  double error_m = 0.0;    ///< from the reference, of a verdict
  double error_rad = 0.0;  ///< from the reference, of a verdict
  stetro_supervisor::ScannerPose believed;
  stetro_supervisor::ScannerPose found;  ///< the best, whether it may be used or not
  bool by_ends = false;                  ///< and not by profiles
  double sigma_m = 0.0;                  ///< that was claimed, in the worst direction
  double agreeing_share = 0.0;
  double longer_share = 0.0;
  double turning_rad_s = 0.0;  ///< while the scan was taken
  double published_m = 0.0;    ///< the published search's error
  double us = 0.0;
  double published_us = 0.0;
};

/// A log checked, scan by scan.
struct LogTable
{
  std::string name;
  double right_m = 0.0;
  double right_rad = 0.0;
  std::vector<LogCase> cases;

  [[nodiscard]] bool is_verdict(const LogCase & one) const;
  [[nodiscard]] bool is_right(const LogCase & one) const;
};

/// A verdict farther off than this is a false accept [m].
constexpr double kFarOff = 0.25;

/// A table in figures.
struct LogSummary
{
  std::size_t cases = 0;
  std::size_t verdicts = 0;
  std::size_t right = 0;
  std::size_t no_verdict = 0;
  std::size_t ambiguous = 0;
  std::size_t by_ends = 0;  ///< of the verdicts
  std::size_t false_accepts = 0;
  std::map<std::string, std::size_t> reasons;  ///< of no verdict
  double median_error_m = 0.0;                 ///< of the verdicts
  double worst_error_m = 0.0;
  double median_error_rad = 0.0;
  double median_us = 0.0;
  std::size_t published_right = 0;
  std::size_t published_far_off = 0;
  double published_median_error_m = 0.0;
  double published_median_us = 0.0;
};

[[nodiscard]] LogSummary summary_of(const LogTable & table);

/// uw_tb4_spiral, _circle, _line on uw_hallway; tau_lab446a on tau_fl4; rplidar_a1 on a map made of
/// its own even scans, the odd ones checked.
[[nodiscard]] std::vector<RecordedLog> recorded_logs(const std::string & folder);

/// Checks one scan from a belief 0.3 m and 3 degrees off its reference, in a drawn direction.
[[nodiscard]] LogCase check_scan(const RecordedLog & log, std::size_t number, std::uint64_t seed);

/// Checks every scan like that.
[[nodiscard]] LogTable run_log(
  const RecordedLog & log, std::uint64_t seed, const std::function<void()> & done);

}  // namespace stetro_bringup

#endif  // PROFILES__LOGS_SUITE_HPP_
