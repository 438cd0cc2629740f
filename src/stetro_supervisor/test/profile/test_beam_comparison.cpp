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

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stetro_supervisor/profile/beam_comparison.hpp"
#include "support/wall_caster.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr double kSigma = 0.01;
constexpr double kReach = 12.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A scan of `beams` in a room of 8 x 4 m from (3, 1), changed as a test needs it.
class Comparison
{
public:
  explicit Comparison(const WallCaster & map, std::size_t beams = 360) : map_(map)
  {
    scan.fan = {0.0, 6.283185307179586 / static_cast<double>(beams), beams};
    map.cast(at.position_m, scan.fan, kReach, scan.ranges_m);
  }

  BeamComparison compare(const BeamNoise & noise = {kSigma, 0.0, 0.5}) const
  {
    const Beams beams(scan);
    WallView view(kReach, 0.0);
    view.look(map_, beams, at);
    view.find_walls(beams);
    BeamComparison comparison;
    compare_beams(beams, view, noise, 3.5, comparison);
    return comparison;
  }

  RangeProfile scan;
  ScannerPose at{{3.0, 1.0}, 0.0};

private:
  const WallCaster & map_;
};

const WallCaster & room()
{
  static const WallCaster walls(rectangle({0.0, 0.0}, {8.0, 4.0}));
  return walls;
}

TEST(BeamComparison, TheMapAgreesWithItself)
{
  const BeamComparison same = Comparison(room()).compare();
  EXPECT_EQ(same.agreeing, 360u);
  EXPECT_DOUBLE_EQ(same.mismatch, 0.0);
  EXPECT_NEAR(same.least_direction_share, 1.0, 1e-9);
}

TEST(BeamComparison, TellsWhatABeamSays)
{
  Comparison one(room());
  one.scan.ranges_m[0] = 3.0;          // the wall is at 5
  one.scan.ranges_m[90] = 3.5;         // at 3
  one.scan.ranges_m[180] = kInfinity;  // no echo
  one.scan.ranges_m[270] = std::nan("");
  const BeamComparison found = one.compare();
  EXPECT_EQ(found.outcomes[0], BeamOutcome::kShorter);
  EXPECT_EQ(found.outcomes[90], BeamOutcome::kLonger);
  EXPECT_EQ(found.outcomes[180], BeamOutcome::kSilent);
  EXPECT_EQ(found.outcomes[270], BeamOutcome::kSilent);
  EXPECT_EQ(found.outcomes[45], BeamOutcome::kAgrees);
  EXPECT_EQ(found.speaking(), 358u);
}

TEST(BeamComparison, InformationOfOneBeamIsWorkedByHand)
{
  Comparison one(room());
  for (double & range : one.scan.ranges_m) {
    range = kInfinity;
  }
  one.scan.ranges_m[0] = 5.005;  // along +x, its wall's normal is -x
  const BeamComparison found = one.compare();
  EXPECT_NEAR(found.information(0, 0), 1.0 / (kSigma * kSigma), 1e-6);
  EXPECT_NEAR(found.information(1, 1), 0.0, 1e-6);
  EXPECT_NEAR(found.pull(0), -0.005 / (kSigma * kSigma), 1e-6) << "back, the wall is farther";
  EXPECT_NEAR(found.chi_square, 0.25, 1e-9);
}

TEST(BeamComparison, InformationShrinksWithNoise)
{
  const Comparison one(room());
  const BeamComparison fine = one.compare({0.01, 0.0, 0.5});
  const BeamComparison coarse = one.compare({0.02, 0.0, 0.5});
  EXPECT_NEAR(fine.information(0, 0) / coarse.information(0, 0), 4.0, 1e-6);
}

TEST(BeamComparison, BeamsOnOneErrorOfAWallCountOnce)
{
  // Twice the beams know the place no better when it is the wall that is not known.
  const BeamNoise walls{0.001, 0.03, 0.5};
  const double some = Comparison(room(), 720).compare(walls).information(0, 0);
  const double more = Comparison(room(), 1440).compare(walls).information(0, 0);
  EXPECT_NEAR(more / some, 1.0, 0.05);
}

TEST(BeamComparison, CorridorLeavesItsLengthOpen)
{
  const WallCaster corridor(rectangle({-100.0, 0.0}, {100.0, 2.0}));
  const BeamComparison found = Comparison(corridor).compare();
  EXPECT_GT(found.information(1, 1), 1e5);
  EXPECT_LT(found.information(0, 0), 1e-3 * found.information(1, 1));
}

}  // namespace
}  // namespace stetro_supervisor
