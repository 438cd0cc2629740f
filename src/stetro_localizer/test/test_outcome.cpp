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

#include "stetro_localizer/outcome.hpp"

namespace stetro_localizer
{
namespace
{

constexpr Verdict kGated{Outcome::kGated, Refusal::kNone};

TEST(SourceReport, CountsWhatIsRejectedInARow)
{
  SourceReport report;
  report.note(kGated);
  report.note(kGated);
  EXPECT_EQ(report.reject_streak, 2u);
  report.note({Outcome::kStale, Refusal::kNone});
  report.note(Verdict::refused(Refusal::kOutOfOrder));
  EXPECT_EQ(report.reject_streak, 2u) << "the same measurement again, or none, says nothing";
  report.note({Outcome::kFused, Refusal::kNone});
  EXPECT_EQ(report.reject_streak, 0u);
}

// Rejected now and again, hours apart, is not rejected in a row: nothing starts anew for it.
TEST(SourceReport, AGapEndsTheRow)
{
  SourceReport report;
  report.note(kGated);
  report.note({Outcome::kNotVisible, Refusal::kNone});
  EXPECT_EQ(report.reject_streak, 0u);
  report.note(kGated);
  EXPECT_EQ(report.reject_streak, 1u);
  EXPECT_EQ(report.gated, 2u);
}

}  // namespace
}  // namespace stetro_localizer
