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

#include "stetro_supervisor/floor/floor_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stetro_supervisor/floor/scan_beams.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kOldScan_s = 1.0;
constexpr double kNoLidar_s = 3.0;          // without a scan: there is no lidar, or it is broken
constexpr double kBetweenByRanges_s = 5.0;  // a robot that stands reads the same again

/// The robot has not been carried on meanwhile, as far as they tell.
bool are_alike(const RangeBeams & a, const RangeBeams & b)
{
  bool alike = a.ranges_m.size() == b.ranges_m.size();
  for (std::size_t i = 0; alike && i < a.ranges_m.size(); ++i) {
    const double error_m = a.beams[i].error.short_m;
    alike = a.beams[i].yaw_rad == b.beams[i].yaw_rad &&
            (a.ranges_m[i] == b.ranges_m[i] || std::abs(a.ranges_m[i] - b.ranges_m[i]) <= error_m);
  }
  return alike;
}

}  // namespace

FloorCheck::FloorCheck(
  const std::vector<const DrawnFloor *> & floors, const stetro_site::RobotGeometry & robot,
  const FloorParams & params)
: robot_(robot), params_(params)
{
  for (const DrawnFloor * floor : floors) {
    witnesses_.emplace_back(*floor, robot.lidar, params);
  }
}

ProfileWitness * FloorCheck::witness_of(const std::string & floor_id)
{
  const auto found = std::find_if(
    witnesses_.begin(), witnesses_.end(),
    [&](const ProfileWitness & witness) { return witness.floor().id() == floor_id; });
  return found != witnesses_.end() ? &*found : nullptr;
}

void FloorCheck::follow(const Observation & seen, const CheckContext & context)
{
  if (seen.odometry) {
    turning_.take(seen.odometry->time, seen.odometry->yaw_rad);
  }
  if (seen.pose && seen.pose->resets != resets_) {
    resets_ = seen.pose->resets;  // the localizer took another pose: that one is not doubted yet
    doubts_ = 0;
    requested_ = true;
  }
  if (context.lost) {
    doubts_ = 0;
  }
  if (seen.pose && context.told) {
    history_.take({seen.pose->time, *context.told, seen.pose->resets});
  } else {
    history_.forget();
  }
}

/// Not looked at yet, of just now, and not smeared by a turn.
bool FloorCheck::is_usable(const Scan * scan, Time now) const
{
  if (
    scan == nullptr || scan->time <= last_scan_ || scan->time > now ||
    seconds_between(scan->time, now) > kOldScan_s) {
    return false;
  }
  const auto rate = turning_.greatest_rate(scan->time, scan->duration_s);
  return rate && *rate <= params_.check_turn_rad_s;
}

void FloorCheck::tick(Time now, const Observation & seen, const CheckContext & context)
{
  report_.reset();
  follow(seen, context);
  if (!context.lost && !doubts_pose()) {
    absent_from_.clear();
    found_on_.clear();
  }
  const auto & scan = seen.scan;
  const bool usable = is_usable(scan.get(), now);
  if (search_) {
    if (!answer_) {
      answer_ = search_->step();
    }
    if (answer_ && (!answer_->found || usable)) {
      conclude(*std::exchange(answer_, std::nullopt), scan.get(), context);
      search_.reset();
      last_search_ = now;
    }
    return;
  }
  if (!usable) {
    search_by_ranges(now, seen, context);
    return;
  }
  const bool due =
    context.moving && seconds_between(last_check_, scan->time) >= params_.check_every_s;
  const auto told = history_.at(scan->time);
  if (context.told && context.corrigible && told && (requested_ || due)) {
    compare(*scan, *told);
    return;
  }
  const bool rested =
    last_search_ == Time{0} || seconds_between(last_search_, scan->time) >= params_.search_pause_s;
  if ((context.lost || doubts_pose()) && rested) {
    begin_search(scan, context);
  }
}

void FloorCheck::compare(const Scan & scan, const PoseHistory::Told & told)
{
  ProfileWitness * witness = witness_of(told.place.floor_id);
  if (witness == nullptr) {
    return;
  }
  requested_ = false;
  last_scan_ = last_check_ = scan.time;
  CheckReport report;
  report.time = scan.time;
  report.floor_id = told.place.floor_id;
  report.told = told.place;
  report.testimony = witness->about(scan, told.place);
  const ScanBeams few = beams_of(scan, robot_.lidar, params_);
  ThreeAnswers answers;
  answers.told = told.place;
  const ProfileFinding & finding = report.testimony.finding;
  answers.profile_verdict = finding.verdict;
  answers.by_ends = finding.by_ends;
  answers.profile_reason = finding.by_ends ? finding.of_profiles : finding.reason;
  answers.profile = report.testimony.found;
  answers.beams_allow_told = beams_allow(witness->floor(), few, told.place);
  answers.beams_allow_profile =
    !answers.profile || beams_allow(witness->floor(), few, *answers.profile);
  const Conclusion conclusion = weigh(answers, params_.agree_sigmas);
  report.verdict = conclusion.verdict;
  report.reason = conclusion.reason;
  if (conclusion.corrects && report.testimony.spectral_radius >= 1.0) {
    report.reason += "; by the beams alone, the centroid does not contract here";
  }
  if (conclusion.corrects) {
    report.correction = Correction{scan.time, *answers.profile, told.resets};
  }
  doubts_ = conclusion.against_told ? doubts_ + 1 : 0;
  if (conclusion.against_told) {
    doubt_ = conclusion.reason;
    requested_ = !doubts_pose();  // the next scan shall tell, and not the next interval
  }
  report_ = std::move(report);
}

std::vector<ProfileWitness *> FloorCheck::floors_to_search(const CheckContext & context)
{
  const std::string & known = context.told ? context.told->floor_id : context.lost_on;
  const std::string & likely = found_on_.empty() ? known : found_on_;
  ProfileWitness * first = witness_of(likely);
  if (first != nullptr && (absent_from_ != likely || witnesses_.size() == 1)) {
    return {first};
  }
  std::vector<ProfileWitness *> others;
  for (ProfileWitness & witness : witnesses_) {
    if (&witness != first) {
      others.push_back(&witness);
    }
  }
  return others;
}

void FloorCheck::begin_search(std::shared_ptr<const Scan> scan, const CheckContext & context)
{
  auto asked = floors_to_search(context);
  if (asked.empty()) {
    return;
  }
  searched_ = asked.size() == 1 ? asked.front()->floor().id() : "";
  last_scan_ = scan->time;
  search_resets_ = resets_;
  search_.emplace(std::move(asked), std::move(scan), robot_.lidar, params_);
}

void FloorCheck::search_by_ranges(Time now, const Observation & seen, const CheckContext & context)
{
  const bool scans = seen.scan && seconds_between(seen.scan->time, now) <= kNoLidar_s;
  no_scan_since_ = scans ? std::nullopt : std::optional<Time>{no_scan_since_.value_or(now)};
  const bool blind = !scans && seconds_between(*no_scan_since_, now) > kNoLidar_s;
  if (!blind || !context.lost || context.moving) {
    by_ranges_.reset();
    return;
  }
  const RangeBeams beams = range_beams_of(seen, now, robot_, params_);
  if (by_ranges_) {
    const auto answer = by_ranges_->step();
    if (answer && are_alike(ranges_, beams) && resets_ == search_resets_) {
      tell(*answer, now);
    }
    if (answer) {
      by_ranges_.reset();
      last_by_ranges_ = now;
    }
    return;
  }
  const bool rested =
    last_by_ranges_ == Time{0} || seconds_between(last_by_ranges_, now) >= kBetweenByRanges_s;
  if (rested && !beams.beams.empty() && !witnesses_.empty()) {
    ranges_ = beams;
    search_resets_ = resets_;
    by_ranges_.emplace(floors_to_search(context), beams);
  }
}

void FloorCheck::tell(const RangeAnswer & answer, Time now)
{
  CheckReport report;
  report.time = now;
  report.searched = true;
  report.verdict = answer.verdict;
  report.reason = answer.reason;
  if (answer.found) {
    report.floor_id = answer.found->floor_id;
    report.correction = Correction{now, *answer.found, resets_};
  }
  report_ = std::move(report);
}

/// The robot may have been carried on meanwhile; and the localizer takes nothing that is old.
void FloorCheck::confirm(SearchAnswer & answer, const Scan & scan)
{
  last_scan_ = scan.time;
  answer.testimony = witness_of(answer.floor_id)->at(scan, *answer.found);
  answer.found = answer.testimony.found;
  if (!answer.found) {
    answer.verdict = Verdict::kNoVerdict;
    answer.reason = "the place that was found does not explain the newest scan";
  }
}

/// Where the next search shall look, should one be needed.
void FloorCheck::note_end(const SearchAnswer & answer)
{
  found_on_ = answer.found ? answer.floor_id : "";
  const bool nowhere = !answer.found && answer.verdict == Verdict::kNoVerdict;
  absent_from_ = nowhere ? searched_ : "";
}

/// \param newest scan, which is usable if there is a place to confirm
void FloorCheck::conclude(SearchAnswer answer, const Scan * newest, const CheckContext & context)
{
  if (resets_ != search_resets_) {
    return;  // it is about a pose that is gone
  }
  CheckReport report;
  report.time = search_->scan_time();
  if (answer.found) {
    confirm(answer, *newest);
    report.time = newest->time;
  }
  note_end(answer);
  report.floor_id = answer.floor_id;
  report.searched = true;
  report.testimony = answer.testimony;
  report.verdict = answer.verdict;
  report.reason = answer.reason;
  const auto told = history_.at(report.time);
  if (told) {
    report.told = told->place;
  }
  if (answer.found) {
    report.correction = Correction{report.time, *answer.found, resets_};
    report.reason = "the only place that explains the scan, on '" + answer.floor_id + "'";
    if (told && told->place.floor_id == answer.found->floor_id && !context.lost) {
      ThreeAnswers answers;
      answers.told = told->place;
      answers.profile = answer.found;
      const Conclusion conclusion = weigh(answers, params_.agree_sigmas);
      report.verdict = conclusion.verdict;
      doubts_ = conclusion.against_told ? doubts_ : 0;
    }
  }
  requested_ = !context.lost && !answer.found;  // perhaps what disturbed the check has walked on
  report_ = std::move(report);
}

}  // namespace stetro_supervisor
