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

#include <set>

#include "accuracy/moment.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_localizer::Outcome;
using stetro_localizer::Source;
using stetro_localizer::SourceReports;

std::uint32_t in_sight_with(Source source, Outcome outcome)
{
  SourceReports reports;
  reports[source].outcome = outcome;
  return in_sight_of(reports);
}

TEST(Moment, ASensorIsInSightBelievedOrNot)
{
  EXPECT_EQ(in_sight_of(SourceReports{}), 0u);
  const std::uint32_t fused = in_sight_with(Source::kSideLeft, Outcome::kFused);
  EXPECT_NE(fused, 0u);
  EXPECT_EQ(in_sight_with(Source::kSideLeft, Outcome::kGated), fused);
  for (const Outcome outcome :
       {Outcome::kNone, Outcome::kNotVisible, Outcome::kStale, Outcome::kRefused}) {
    EXPECT_EQ(in_sight_with(Source::kSideLeft, outcome), 0u);
  }
}

TEST(Moment, EachSideAndFrontSensorHasABitOfItsOwn)
{
  std::set<std::uint32_t> bits;
  for (const Source source :
       {Source::kSideLeft, Source::kSideRight, Source::kFrontPair, Source::kFrontLeft,
        Source::kFrontRight}) {
    bits.insert(in_sight_with(source, Outcome::kFused));
  }
  EXPECT_EQ(bits.size(), 5u);
  EXPECT_EQ(bits.count(0u), 0u);
  for (const Source source :
       {Source::kRanges, Source::kGyro, Source::kBlock3Front, Source::kBumperLeft,
        Source::kRiserSwitches}) {
    EXPECT_EQ(in_sight_with(source, Outcome::kFused), 0u) << "hands nothing over";
  }
}

}  // namespace
}  // namespace stetro_bringup
