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

// Four real sensors in a real room: tests/recorded/fourbeam_room363. Alternate blocks of thirty
// samples, three readings of each sensor, make the map; the others are located in it, their heading
// being known; then the halves change places, so that each sample is located once.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "stetro_supervisor/four_beams/heading_search.hpp"
#include "support/recorded_flight.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::OccupancyGrid;

constexpr std::size_t kBlock = 30;

// The record's README states its sensors' errors: 5 cm too long in the median, a median absolute
// deviation of 3 cm, one in ten off by more than 20 cm. Bounds: three standard deviations, for
// which 1.4826 times that deviation stands, around the bias. What is farther off is a wrong beam.
constexpr double kBias = 0.05;
constexpr double kBound = 3 * 1.4826 * 0.03;
// The farthest that any sensor reported; none was ever without return.
constexpr double kDependable = 3.2;

const std::vector<FlightSample> & flight()
{
  static const std::vector<FlightSample> kFlight =
    read_flight(STETRO_RECORDED "/fourbeam_room363/exp_mr_lh_363.json");
  return kFlight;
}

double quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// How the search did on samples that the map does not know.
struct Outcome
{
  std::vector<double> errors_m;  ///< of the centre of the best cluster
  std::vector<double> areas_m2;
  std::size_t holds_truth = 0;
  std::size_t all_four_agree = 0;
};

void locate(const OccupancyGrid & map, const std::vector<FlightSample> & samples, Outcome & outcome)
{
  std::vector<RangeBeam> beams;
  for (const double yaw_rad : kFlightBeams) {
    const RangeError error{kBound - kBias, kBound + kBias, 0.0, 0.0, kDependable, 0.05};
    beams.push_back({{0.0, 0.0}, yaw_rad, error});
  }
  for (const FlightSample & sample : samples) {
    const HeadingSearch search(map, beams, sample.heading_rad);
    const PlaceAnswer answer = search.find_best({sample.ranges_m.begin(), sample.ranges_m.end()});
    const auto & cells = answer.cells.cells;
    const bool inside =
      std::find(cells.begin(), cells.end(), map.cell_at(sample.position_m)) != cells.end();
    outcome.holds_truth += inside ? 1 : 0;
    outcome.all_four_agree += answer.cells.least_agreeing == 4 ? 1 : 0;
    outcome.areas_m2.push_back(answer.area_m2);
    outcome.errors_m.push_back((answer.best.front().centroid_m - sample.position_m).norm());
  }
}

TEST(RecordedFlight, IsReadAsItsReadmeSays)
{
  ASSERT_EQ(flight().size(), 1770U);
  EXPECT_DOUBLE_EQ(flight()[0].ranges_m[0], 2.999);
  EXPECT_DOUBLE_EQ(flight()[0].ranges_m[1], 1.938);
  EXPECT_THROW(read_flight("/nowhere/at/all.json"), std::runtime_error);
}

// The bounds are the record's own, not fitted: they hold most, and not all, of what the map's half
// shows when one half of it is measured in a map of the other.
TEST(RecordedFlight, BoundsFitTheHalfThatMakesTheMap)
{
  for (const bool first : {true, false}) {
    const auto known = every_other_block(flight(), kBlock, first);
    std::vector<double> errors_m;
    for (const bool quarter : {true, false}) {
      const auto map = map_of(every_other_block(known, kBlock, quarter));
      const auto more = range_errors_m(map, every_other_block(known, kBlock, !quarter));
      errors_m.insert(errors_m.end(), more.begin(), more.end());
    }
    const auto within = std::count_if(errors_m.begin(), errors_m.end(), [](double error_m) {
      return std::abs(error_m - kBias) <= kBound;
    });
    const double share = static_cast<double>(within) / static_cast<double>(errors_m.size());
    RecordProperty(first ? "within_first" : "within_second", std::to_string(share));
    EXPECT_GT(share, 0.90);
    EXPECT_LT(share, 0.99);
  }
}

TEST(RecordedFlight, FourBeamsFindEachPlace)
{
  Outcome outcome;
  for (const bool first : {true, false}) {
    locate(
      map_of(every_other_block(flight(), kBlock, first)),
      every_other_block(flight(), kBlock, !first), outcome);
  }
  const auto count = static_cast<double>(outcome.errors_m.size());
  EXPECT_EQ(outcome.errors_m.size(), flight().size());
  const double holds_truth = static_cast<double>(outcome.holds_truth) / count;
  const double all_four = static_cast<double>(outcome.all_four_agree) / count;
  std::printf(
    "error median %.3f m, p90 %.3f m; truth inside %.3f; area median %.3f m2; four agree %.3f\n",
    quantile(outcome.errors_m, 0.5), quantile(outcome.errors_m, 0.9), holds_truth,
    quantile(outcome.areas_m2, 0.5), all_four);
  EXPECT_LE(quantile(outcome.errors_m, 0.5), 0.10);
  EXPECT_LE(quantile(outcome.errors_m, 0.9), 0.20);
  EXPECT_GE(holds_truth, 0.95);
  EXPECT_LE(quantile(outcome.areas_m2, 0.5), 0.25);
}

}  // namespace
}  // namespace stetro_supervisor
