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

#ifndef ACCURACY__STAIRCASE_WATCH_HPP_
#define ACCURACY__STAIRCASE_WATCH_HPP_

#include <cstdint>
#include <map>
#include <vector>

#include "stetro_driver/sim_robot.hpp"
#include "stetro_localizer/staircase_as_built.hpp"
#include "stetro_site/flight.hpp"

namespace stetro_bringup
{

/// One measure of one step: how wrong the estimate is, and how wrong the site file was.
struct MeasureScore
{
  int step = 0;
  double found_error_m = 0.0;  ///< estimate less what is there
  double sigma_m = 0.0;        ///< that the estimate said of itself
  double site_error_m = 0.0;   ///< site file less what is there
};

/// The staircase as one estimator found it, beside the world's.
struct StaircaseScore
{
  std::vector<MeasureScore> treads;
  std::vector<MeasureScore> widths;
  std::uint64_t reported = 0;  ///< deviations from the site file beyond the bound
};

/// Learns in one climb what the world's steps measure.
/**
 * The truth tells a tread at the robot's y, where the directions of two risers are in it: what
 * counts is the moment nearest to mid width. The last tread ends at no riser and has none.
 */
class StaircaseWatch
{
public:
  void watch(const stetro_driver::GroundTruth & truth);

  /// \param bound_m beyond which a deviation is reported [m]
  [[nodiscard]] StaircaseScore score(
    const std::vector<stetro_localizer::StepAsBuilt> & found, const stetro_site::Flight & site,
    double bound_m) const;

private:
  struct Seen
  {
    double off_middle_m;
    double tread_m;
    double width_m;
  };

  std::map<int, Seen> steps_;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__STAIRCASE_WATCH_HPP_
