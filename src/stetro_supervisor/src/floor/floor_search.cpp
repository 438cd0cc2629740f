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

#include "stetro_supervisor/floor/floor_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stetro_site/frame_transform.hpp"
#include "stetro_supervisor/profile/trusted_centre_of_mass.hpp"

namespace stetro_supervisor
{
namespace
{

// What a tick may do and what things cost, in cells that a beam passes while a table is built.
constexpr std::size_t kWorkATick = 4000000;
constexpr std::size_t kCellsLookedUp = 2;  // in all tables of a heading at once
constexpr std::size_t kWorkACell = 50;     // of those that agree
constexpr std::size_t kWorkAGuess = 5000;
constexpr std::size_t kLooksATick = 2;
constexpr std::size_t kFewBeams = 90;
constexpr double kSpacing_m = 0.25;      // between guesses within one cluster
constexpr std::size_t kLooked = 30;      // the best guesses, which are looked at closely
constexpr double kWorthALook = 2.0;      // times the least misfit, and
constexpr double kAnywayWorth_m = 0.10;  // this much more
constexpr double kOnePlace_m = 0.20;     // verified places nearer to each other are one
constexpr double kOneHeading_rad = 0.15;

bool are_near(const FloorPlace & a, const FloorPlace & b)
{
  return a.floor_id == b.floor_id && (a.position_m - b.position_m).norm() < kOnePlace_m &&
         std::abs(stetro_site::wrap_angle(a.yaw_rad - b.yaw_rad)) < kOneHeading_rad;
}

std::string in_words(const FloorPlace & place)
{
  const auto number = [](double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.size() - 4);
  };
  return "'" + place.floor_id + "' (" + number(place.position_m.x()) + ", " +
         number(place.position_m.y()) + ") m, " + number(place.yaw_rad) + " rad";
}

}  // namespace

FloorSearch::FloorSearch(
  std::vector<ProfileWitness *> witnesses, std::shared_ptr<const Scan> scan,
  const stetro_site::Lidar & lidar, const FloorParams & params)
: witnesses_(std::move(witnesses)),
  scan_(std::move(scan)),
  lidar_(lidar),
  beams_(beams_of(*scan_, lidar, params)),
  few_(Beams{scan_->profile}.thinned(kFewBeams)),
  taken_(kSpacing_m)
{
}

std::optional<SearchAnswer> FloorSearch::step()
{
  if (floor_ < witnesses_.size()) {
    for (std::size_t work = 0; work < kWorkATick && floor_ < witnesses_.size();) {
      work += try_heading(kWorkATick - work);
    }
    return std::nullopt;
  }
  if (!ranked_) {
    rank();
    ranked_ = true;
    return std::nullopt;
  }
  for (std::size_t i = 0; i < kLooksATick && next_guess_ < guesses_.size(); ++i) {
    verify(guesses_[next_guess_++]);
  }
  return next_guess_ < guesses_.size() ? std::nullopt : std::optional<SearchAnswer>{answer()};
}

/// Does about so much for the present heading, or what is left to do. \return what it cost
std::size_t FloorSearch::try_heading(std::size_t work)
{
  ProfileWitness & witness = *witnesses_[floor_];
  HeadingTables & tables = witness.headings();
  if (!tables.is_built(heading_)) {
    return tables.build(heading_, work);
  }
  if (!agreeing_) {
    agreeing_ = tables.find(beams_, heading_);
    next_cell_ = 0;
    taken_ = SpacedPoints{kSpacing_m};
    return witness.floor().grid().cells().size() / kCellsLookedUp;
  }
  const std::size_t cost = guess(work);
  if (next_cell_ == agreeing_->cells.size()) {
    next_heading();
  }
  return cost;
}

void FloorSearch::next_heading()
{
  agreeing_.reset();
  if (++heading_ == witnesses_[floor_]->headings().headings()) {
    heading_ = 0;
    ++floor_;
  }
}

/// Places among the cells, a spacing apart: they may be many where beams say little.
std::size_t FloorSearch::guess(std::size_t work)
{
  ProfileWitness & witness = *witnesses_[floor_];
  const double scanner_yaw_rad = witness.headings().heading_rad(heading_);
  std::size_t cost = 0;
  for (; cost < work && next_cell_ < agreeing_->cells.size(); ++next_cell_) {
    const Eigen::Vector2d centre = witness.floor().grid().centre_m(agreeing_->cells[next_cell_]);
    cost += kWorkACell;
    if (!witness.floor().free_space().is_free(centre) || !taken_.take(centre)) {
      continue;
    }
    cost += kWorkAGuess;
    FloorPlace place = base_at({centre, scanner_yaw_rad}, lidar_);
    place.floor_id = witness.floor().id();
    const double misfit_m = witness.misfit_m(few_, place);
    if (is_worth_a_look(misfit_m)) {
      guesses_.push_back({&witness, place, misfit_m});
      least_misfit_m_ = std::min(least_misfit_m_, misfit_m);
    }
  }
  return cost;
}

bool FloorSearch::is_worth_a_look(double misfit_m) const
{
  return misfit_m <= kWorthALook * least_misfit_m_ + kAnywayWorth_m;
}

void FloorSearch::rank()
{
  std::sort(guesses_.begin(), guesses_.end(), [](const Guess & a, const Guess & b) {
    return a.misfit_m < b.misfit_m;
  });
  std::vector<Guess> kept;
  for (const Guess & guess : guesses_) {
    if (kept.size() >= kLooked || !is_worth_a_look(guess.misfit_m)) {
      break;
    }
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Guess & other) {
      return are_near(other.place, guess.place);
    });
    if (!known) {
      kept.push_back(guess);
    }
  }
  guesses_ = std::move(kept);
}

void FloorSearch::verify(const Guess & guess)
{
  Testimony testimony = guess.witness->at(*scan_, guess.place);
  if (!testimony.found) {
    return;
  }
  const FloorPlace place = *testimony.found;
  const auto known = std::find_if(verified_.begin(), verified_.end(), [&](const Verified & other) {
    return are_near(other.place, place);
  });
  if (known == verified_.end()) {
    verified_.push_back({place, std::move(testimony)});
  } else if (testimony.finding.best.beams.mismatch < known->testimony.finding.best.beams.mismatch) {
    *known = {place, std::move(testimony)};
  }
}

SearchAnswer FloorSearch::answer() const
{
  SearchAnswer answer;
  const auto best = std::min_element(
    verified_.begin(), verified_.end(), [](const Verified & a, const Verified & b) {
      return a.testimony.finding.best.beams.mismatch < b.testimony.finding.best.beams.mismatch;
    });
  if (best == verified_.end()) {
    answer.reason =
      guesses_.empty() ? "no place agrees with enough beams" : "no place explains the scan";
    return answer;
  }
  answer.testimony = best->testimony;
  answer.floor_id = best->place.floor_id;
  const double contradiction = best->testimony.finding.best.beams.contradiction;
  for (const Verified & other : verified_) {
    const bool rivals =
      other.testimony.finding.best.beams.contradiction < contradiction + TrustParams{}.tell_apart;
    if (&other != &*best && rivals) {
      answer.alternatives.push_back(other.place);
    }
  }
  if (!answer.alternatives.empty()) {
    answer.verdict = Verdict::kAmbiguous;
    answer.reason =
      "explained at " + in_words(best->place) + " and at " + in_words(answer.alternatives.front());
    return answer;
  }
  answer.verdict = Verdict::kCorrected;
  answer.found = best->place;
  return answer;
}

}  // namespace stetro_supervisor
