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

#include "profiles/logs_suite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>

#include "profiles/cpu_time.hpp"
#include "profiles/median.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/polygon.hpp"
#include "stetro_site/segment_caster.hpp"
#include "stetro_supervisor/profile/published_centre_of_mass.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_supervisor::ProfileFinding;
using stetro_supervisor::ScannerPose;
using stetro_supervisor::Verdict;

constexpr double kPi = 3.141592653589793;
constexpr double kReach = 12.0;
constexpr double kOff = 0.3;
constexpr double kOffYaw = 3.0 * kPi / 180.0;
constexpr double kSearchRadius = 1.0;
constexpr double kJump = 0.15;  // ends of neighbouring beams farther apart are two walls [m]

/// The median of each beam's echoes; +inf if most scans have none.
std::vector<double> median_profile(const std::vector<RecordedScan> & scans)
{
  std::vector<double> medians;
  for (std::size_t beam = 0; beam < scans.front().profile.ranges_m.size(); ++beam) {
    std::vector<double> ranges;
    for (const RecordedScan & scan : scans) {
      ranges.push_back(scan.profile.ranges_m[beam]);
    }
    medians.push_back(median(std::move(ranges)));
  }
  return medians;
}

/// A map drawn from scans of one place: walls between the ends of neighbouring beams.
RecordedFloor floor_of(const std::string & name, const std::vector<RecordedScan> & scans)
{
  const auto ranges_m = median_profile(scans);
  const auto & fan = scans.front().profile.fan;
  std::vector<Eigen::Vector2d> ends;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
    if (std::isfinite(ranges_m[i])) {
      ends.emplace_back(ranges_m[i] * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  std::vector<stetro_site::Segment> walls;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto & next = ends[i + 1 < ends.size() ? i + 1 : 0];
    if ((next - ends[i]).norm() < kJump) {
      walls.push_back({ends[i], next});
    }
  }
  RecordedFloor floor;
  floor.name = name;
  floor.drawn = true;
  floor.map = std::make_shared<const stetro_site::SegmentCaster>(walls);
  floor.is_free = [ends](const Eigen::Vector2d & p) { return stetro_site::encloses(ends, p); };
  return floor;
}

LogCase check(
  const RecordedLog & log, std::size_t number, stetro_supervisor::ScanCheck & check,
  std::mt19937_64 & random)
{
  const RecordedScan & scan = log.scans[number];
  const double direction = std::uniform_real_distribution<double>(-kPi, kPi)(random);
  const double side = std::bernoulli_distribution(0.5)(random) ? 1.0 : -1.0;
  stetro_supervisor::Belief belief;
  belief.area.around = scan.reference;
  belief.area.around.position_m += kOff * Eigen::Vector2d(std::cos(direction), std::sin(direction));
  belief.area.around.yaw_rad += side * kOffYaw;
  belief.area.radius_m = kSearchRadius;
  belief.yaw_sigma_rad = kOffYaw;

  LogCase one;
  one.number = number;
  one.turning_rad_s = scan.turning_rad_s;
  const double start = cpu_time_us();
  const ProfileFinding finding = check.check(scan.profile, belief);
  one.us = cpu_time_us() - start;
  one.verdict = finding.verdict;
  one.believed = belief.area.around;
  one.found = finding.best.pose;
  one.reason = finding.reason;
  one.by_ends = finding.by_ends;
  one.error_m = (finding.best.pose.position_m - scan.reference.position_m).norm();
  one.error_rad =
    std::abs(stetro_site::wrap_angle(finding.best.pose.yaw_rad - scan.reference.yaw_rad));
  one.sigma_m = stetro_supervisor::largest_sigma_m(finding.best.covariance);
  one.agreeing_share = finding.best.beams.agreeing_share();
  one.longer_share = finding.best.beams.longer_share();
  stetro_supervisor::PublishedLimits limits;
  limits.reach_m = kReach;
  const double restart = cpu_time_us();
  const auto published = stetro_supervisor::published_search(
    *log.floor.map, stetro_supervisor::Beams(scan.profile), belief.area.around, limits);
  one.published_us = cpu_time_us() - restart;
  one.published_m = published.positions_m.empty()
                      ? std::numeric_limits<double>::infinity()
                      : (published.positions_m.back() - scan.reference.position_m).norm();
  return one;
}

}  // namespace

bool LogTable::is_verdict(const LogCase & one) const
{
  return one.verdict == Verdict::kAgrees || one.verdict == Verdict::kCorrected;
}

bool LogTable::is_right(const LogCase & one) const
{
  return is_verdict(one) && one.error_m <= right_m && one.error_rad <= right_rad;
}

LogSummary summary_of(const LogTable & table)
{
  LogSummary sum;
  std::vector<double> errors_m, errors_rad, us, published_m, published_us;
  for (const LogCase & one : table.cases) {
    ++sum.cases;
    us.push_back(one.us);
    published_m.push_back(one.published_m);
    published_us.push_back(one.published_us);
    sum.published_right += one.published_m <= table.right_m ? 1 : 0;
    sum.published_far_off += one.published_m > kFarOff ? 1 : 0;
    sum.ambiguous += one.verdict == Verdict::kAmbiguous ? 1 : 0;
    if (one.verdict == Verdict::kNoVerdict) {
      ++sum.no_verdict;
      ++sum.reasons[stetro_supervisor::name_of(one.reason)];
    }
    if (table.is_verdict(one)) {
      ++sum.verdicts;
      sum.right += table.is_right(one) ? 1 : 0;
      sum.by_ends += one.by_ends ? 1 : 0;
      sum.false_accepts += one.error_m > kFarOff ? 1 : 0;
      sum.worst_error_m = std::max(sum.worst_error_m, one.error_m);
      errors_m.push_back(one.error_m);
      errors_rad.push_back(one.error_rad);
    }
  }
  sum.median_error_m = median(std::move(errors_m));
  sum.median_error_rad = median(std::move(errors_rad));
  sum.median_us = median(std::move(us));
  sum.published_median_error_m = median(std::move(published_m));
  sum.published_median_us = median(std::move(published_us));
  return sum;
}

std::vector<RecordedLog> recorded_logs(const std::string & folder)
{
  std::vector<RecordedLog> logs;
  const auto hallway = grid_floor("uw_hallway", folder + "/maps/uw_hallway/map.yaml");
  for (const std::string run : {"spiral", "circle", "line"}) {
    logs.push_back({"uw_tb4_" + run, hallway, uw_scans(folder, run)});
  }
  logs.push_back(
    {"tau_lab446a", grid_floor("tau_fl4", folder + "/maps/tau_fl4/my_map.yaml"),
     tau_scans(folder)});
  std::vector<RecordedScan> even;
  std::vector<RecordedScan> odd;
  for (RecordedScan & scan : read_scans(folder + "/rplidar_a1/laser_content.csv")) {
    (even.size() == odd.size() ? even : odd).push_back(std::move(scan));
  }
  RecordedLog standing{"rplidar_a1", floor_of("rplidar_a1", even), odd};
  standing.right_m = 0.01;
  logs.push_back(std::move(standing));
  return logs;
}

LogCase check_scan(const RecordedLog & log, std::size_t number, std::uint64_t seed)
{
  stetro_supervisor::ScanCheck trusted(
    *log.floor.map, log.floor.is_free, log.floor.walls, scan_check_params_of(log.floor),
    log.floor.layer);
  trusted.prepare(log.scans[number].profile.fan);
  std::seed_seq mixed{seed, static_cast<std::uint64_t>(number)};
  std::mt19937_64 random(mixed);
  return check(log, number, trusted, random);
}

LogTable run_log(const RecordedLog & log, std::uint64_t seed, const std::function<void()> & done)
{
  LogTable table{log.name, log.right_m, log.right_rad, {}};
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    table.cases.push_back(check_scan(log, i, seed));
    done();
  }
  return table;
}

}  // namespace stetro_bringup
