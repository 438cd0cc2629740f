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

#ifndef STETRO_SUPERVISOR__FLOOR__FLOOR_SEARCH_HPP_
#define STETRO_SUPERVISOR__FLOOR__FLOOR_SEARCH_HPP_

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stetro_supervisor/floor/profile_witness.hpp"
#include "stetro_supervisor/floor/scan_beams.hpp"
#include "stetro_supervisor/floor/spaced_points.hpp"

namespace stetro_supervisor
{

/// What a search over whole floors has found.
struct SearchAnswer
{
  Verdict verdict = Verdict::kNoVerdict;  ///< kCorrected, kAmbiguous or kNoVerdict
  std::string reason;                     ///< in words, where it is not one place
  std::optional<FloorPlace> found;        ///< the one place, with its covariance
  Testimony testimony;                    ///< of the place that fits best, if any was verified
  std::string floor_id;                   ///< that place's floor
  std::vector<FloorPlace> alternatives;   ///< the other places that explain the scan
};

/// Finds a robot that is lost: anywhere on some floors, whichever way it faces, from one scan.
/**
 *  1. Four beams (S-G): for every heading, `floor.search_heading_rad` apart, the places where
 *     enough of eight beams agree (`ScanBeams`). They hold the truth unless more are wrong.
 *  2. Of those places the ones whose profile is most like the scan.
 *  3. The trusted centre of mass looks at each: one that explains the scan is the answer; several
 *     that do, none of them ruled out by beams through its walls, are ambiguous.
 *
 * The robot stands meanwhile, so the work is cut into steps that fit a tick, by what is counted and
 * not by a clock: the same scan takes the same steps. For one thread.
 */
class FloorSearch
{
public:
  /// \param witnesses of the floors; outlive the search
  FloorSearch(
    std::vector<ProfileWitness *> witnesses, std::shared_ptr<const Scan> scan,
    const stetro_site::Lidar & lidar, const FloorParams & params);

  /// Works for a tick. \return the answer, once, when all is done
  [[nodiscard]] std::optional<SearchAnswer> step();

  [[nodiscard]] Time scan_time() const { return scan_->time; }

private:
  struct Guess
  {
    ProfileWitness * witness;
    FloorPlace place;
    double misfit_m;
  };

  struct Verified
  {
    FloorPlace place;
    Testimony testimony;
  };

  std::size_t try_heading(std::size_t work);
  std::size_t guess(std::size_t work);
  void next_heading();
  [[nodiscard]] bool is_worth_a_look(double misfit_m) const;
  void rank();
  void verify(const Guess & guess);
  [[nodiscard]] SearchAnswer answer() const;

  std::vector<ProfileWitness *> witnesses_;
  std::shared_ptr<const Scan> scan_;
  stetro_site::Lidar lidar_;
  ScanBeams beams_;
  Beams few_;
  std::size_t floor_ = 0;                  // whose headings are tried
  std::size_t heading_ = 0;                // the present one of them
  std::optional<AgreeingCells> agreeing_;  // with that heading, once they have been looked up
  std::size_t next_cell_ = 0;              // of those
  SpacedPoints taken_;                     // of those
  bool ranked_ = false;
  std::vector<Guess> guesses_;
  double least_misfit_m_ = std::numeric_limits<double>::infinity();  // of them
  std::size_t next_guess_ = 0;
  std::vector<Verified> verified_;
};

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__FLOOR__FLOOR_SEARCH_HPP_
