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

#ifndef ACCURACY__ESTIMATOR_TOTALS_HPP_
#define ACCURACY__ESTIMATOR_TOTALS_HPP_

#include <cstdint>
#include <limits>
#include <vector>

#include "accuracy/climb_score.hpp"
#include "accuracy/error_distribution.hpp"
#include "accuracy/histogram.hpp"
#include "accuracy/sigma_tally.hpp"

namespace stetro_bringup
{

/// The tread-relative errors of one group of estimates.
struct ErrorGroup
{
  ErrorDistribution x_m;
  ErrorDistribution x_behind_m;
  ErrorDistribution y_m;
  ErrorDistribution z_m;
  ErrorDistribution heading_rad;
  ErrorDistribution heading_to_riser_rad;

  void add(const TreadErrors & errors);
};

/// How often the NEES lay inside its bounds.
struct NeesTally
{
  std::uint64_t inside = 0;
  std::uint64_t above = 0;    ///< too sure of itself
  std::uint64_t below = 0;    ///< not sure enough
  std::uint64_t unknown = 0;  ///< no covariance to speak of
  double sum = 0.0;

  void add(double nees);
  [[nodiscard]] std::uint64_t known() const { return inside + above + below; }
  [[nodiscard]] double inside_share() const;  ///< NaN without any
  [[nodiscard]] double mean() const;          ///< 3 for consistent errors; NaN without any
};

/// One tread over all climbs.
struct TreadTotals
{
  ErrorDistribution x_m;
  ErrorDistribution y_m;
  ErrorDistribution heading_rad;
  ErrorStatistics sigma_x_m;  ///< what the estimates said of themselves
  ErrorStatistics sigma_y_m;
  ErrorStatistics sigma_heading_rad;
  NeesTally nees;
};

/// One kind of measure of the staircase over all climbs.
struct MeasureTotals
{
  ErrorDistribution found_m;
  ErrorDistribution site_m;  ///< of the site file: what would be known without measuring
  SigmaTally sigmas;

  void add(const std::vector<MeasureScore> & scores);
};

/// One estimator over all climbs of a scenario.
class EstimatorTotals
{
public:
  explicit EstimatorTotals(int steps);

  /// Takes one climb. The order of climbs is the order of sums: give it as the seeds rise.
  void add(const ClimbScore & score);

  // From the end of the first tread on.
  ErrorGroup errors;
  ErrorDistribution flight_x_m;
  ErrorDistribution flight_z_m;
  SigmaTally flight_x;
  SigmaTally flight_z;
  NeesTally nees;                    ///< everywhere
  NeesTally nees_with_reference;     ///< where the front sensors have a riser in sight
  NeesTally nees_without_reference;  ///< on the last two treads
  ErrorDistribution hand_over_m;     ///< the larger of the two
  ErrorDistribution hand_over_x_m;
  ErrorDistribution hand_over_y_m;
  ErrorDistribution closure_m;
  MeasureTotals tread_depths;  ///< the staircase as built, by the end of each climb
  MeasureTotals widths;
  std::uint64_t deviations_reported = 0;
  ErrorDistribution protection_along_m;  ///< where a reference is in sight; none if not given
  ErrorDistribution protection_across_m;
  ErrorDistribution protection_heading_rad;
  Histogram x_histogram{0.03, 120};          ///< [m]
  Histogram y_histogram{0.03, 120};          ///< [m]
  Histogram heading_histogram{0.0524, 120};  ///< 3 degrees [rad]
  std::vector<TreadTotals> treads;           ///< by step; 0 stays empty

  ErrorGroup first_tread;
  ErrorDistribution first_closure_m;
  ErrorGroup after_onset;

  std::uint64_t climbs = 0;
  std::uint64_t confirming = 0;  ///< estimates while a touch-down was being confirmed
  double longest_confirmation_s = 0.0;
  double longest_exceedance_s = 0.0;
  std::uint64_t exceeded_climbs = 0;  ///< with an exceedance of more than a second
  /// Integrity risk that the estimates state, per step; NaN: none.
  double stated_risk = std::numeric_limits<double>::quiet_NaN();
  ClimbScore counts;  ///< the sums of the counters of all climbs; nothing else of it is used
  std::vector<Detection> detections;  ///< of the faults that struck and could be noticed
  std::uint64_t never_ok = 0;         ///< faults that struck an estimate not OK to the end

private:
  void add(const ScoredEstimate & sample);
  void add_counts(const ClimbScore & score);
  [[nodiscard]] bool has_reference(int step) const
  {
    return step + 2 < static_cast<int>(treads.size());
  }
};

}  // namespace stetro_bringup

#endif  // ACCURACY__ESTIMATOR_TOTALS_HPP_
