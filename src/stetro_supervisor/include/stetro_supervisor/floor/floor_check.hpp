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

#ifndef STETRO_SUPERVISOR__FLOOR__FLOOR_CHECK_HPP_
#define STETRO_SUPERVISOR__FLOOR__FLOOR_CHECK_HPP_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_supervisor/floor/floor_search.hpp"
#include "stetro_supervisor/floor/pose_history.hpp"
#include "stetro_supervisor/floor/profile_witness.hpp"
#include "stetro_supervisor/floor/range_search.hpp"
#include "stetro_supervisor/floor/three_answers.hpp"
#include "stetro_supervisor/observation.hpp"

namespace stetro_supervisor
{

/// A pose for the localizer, found by another road than its own.
struct Correction
{
  Time time{0};              ///< of the scan
  FloorPlace place;          ///< base_link, with covariance
  std::uint32_t resets = 0;  ///< of the pose it was compared with
};

/// What one look at a scan has told.
struct CheckReport
{
  Time time{0};                    ///< of the scan
  std::string floor_id;            ///< whose plan was used; empty: none explains the scan
  std::optional<FloorPlace> told;  ///< the pose that was checked; nothing where it was lost
  Testimony testimony;
  Verdict verdict = Verdict::kNoVerdict;
  std::string reason;
  std::optional<Correction> correction;
  bool searched = false;  ///< whole floors were searched
};

/// What is known about the robot when a scan is looked at.
struct CheckContext
{
  std::optional<FloorPlace> told;  ///< a usable pose on a drawn floor
  bool corrigible = false;         ///< told in the floor's frame: the localizer takes corrections
  bool lost = false;               ///< the localizer does not know, and the robot may be on a floor
  std::string lost_on;             ///< the floor it was on; empty: any
  bool moving = false;
};

/// The second opinion on the pose, on floors: at intervals, at turning points and on request.
/**
 * While the pose is usable, every `floor.check_every_s` of motion and whenever asked a scan is
 * compared with the map about the pose (`ThreeAnswers`), and the answer told to the localizer as a
 * correction, be it small. `floor.doubts` answers in a row against the pose make it doubted: the
 * robot must stand, and the floor is searched for where it is (`FloorSearch`). The same when the
 * localizer has lost it or never had it. A place is told when it is the only one and explains the
 * newest scan, for a search takes seconds; the localizer, which refuses what is far from its pose,
 * follows when several agree.
 *
 * Searched is the floor that the pose is on, or was; when no place on it explains the scan, all
 * others together, then that floor again, and so on. Never told: all floors together. Where a
 * place was found the next search looks first. A robot that stands lost without any scan is
 * searched for by its side and front ranges (`RangeSearch`), which mostly say how little they say.
 *
 * A scan is used once, not while the robot turns faster than `floor.check_turn_rad_s`, and only if
 * the pose at its time is known. Reads no clock. For one thread.
 */
class FloorCheck
{
public:
  /// \param floors that are drawn; outlive the check
  FloorCheck(
    const std::vector<const DrawnFloor *> & floors, const stetro_site::RobotGeometry & robot,
    const FloorParams & params);

  /// Looks as soon as there is a scan for it.
  void request() { requested_ = true; }

  /// A check is asked for, or overdue by one interval; a scan of it must not be smeared.
  [[nodiscard]] bool awaits_scan(Time now) const
  {
    return requested_ || seconds_between(last_check_, now) > 2.0 * params_.check_every_s;
  }

  void tick(Time now, const Observation & seen, const CheckContext & context);

  /// Of the last tick, if there was one.
  [[nodiscard]] const std::optional<CheckReport> & report() const { return report_; }

  /// Enough answers in a row were against the pose.
  [[nodiscard]] bool doubts_pose() const { return doubts_ >= params_.doubts; }

  /// Why, in words.
  [[nodiscard]] const std::string & doubt() const { return doubt_; }

private:
  void follow(const Observation & seen, const CheckContext & context);
  [[nodiscard]] bool is_usable(const Scan * scan, Time now) const;
  void compare(const Scan & scan, const PoseHistory::Told & told);
  [[nodiscard]] std::vector<ProfileWitness *> floors_to_search(const CheckContext & context);
  void begin_search(std::shared_ptr<const Scan> scan, const CheckContext & context);
  void note_end(const SearchAnswer & answer);
  void search_by_ranges(Time now, const Observation & seen, const CheckContext & context);
  void tell(const RangeAnswer & answer, Time now);
  void confirm(SearchAnswer & answer, const Scan & scan);
  void conclude(SearchAnswer answer, const Scan * newest, const CheckContext & context);
  [[nodiscard]] ProfileWitness * witness_of(const std::string & floor_id);

  stetro_site::RobotGeometry robot_;
  FloorParams params_;
  std::vector<ProfileWitness> witnesses_;
  PoseHistory history_;
  TurnWatch turning_;
  std::optional<FloorSearch> search_;
  std::optional<SearchAnswer> answer_;  // of the search, until a newer scan bears it out
  std::optional<CheckReport> report_;
  std::string doubt_;
  std::int64_t doubts_ = 0;
  std::uint32_t resets_ = 0;         // of the last pose
  std::uint32_t search_resets_ = 0;  // when the search began
  std::optional<RangeSearch> by_ranges_;
  RangeBeams ranges_;                  // of that search
  std::optional<Time> no_scan_since_;  // there has been none
  Time last_by_ranges_{0};             // its end
  std::string searched_;               // the only floor of that search; empty: several
  std::string absent_from_;            // the floor where the last search has found no place
  std::string found_on_;               // the floor where it has found the only one
  bool requested_ = false;
  Time last_scan_{0};  // that was looked at
  Time last_check_{0};
  Time last_search_{0};  // its end
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__FLOOR_CHECK_HPP_
