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

#include "stetro_localizer/outcome.hpp"

#include <numeric>

namespace stetro_localizer
{

const char * to_string(Outcome outcome)
{
  switch (outcome) {
    case Outcome::kNone:
      return "none";
    case Outcome::kFused:
      return "fused";
    case Outcome::kGated:
      return "gated";
    case Outcome::kStale:
      return "stale";
    case Outcome::kNotVisible:
      return "not visible";
    case Outcome::kRefused:
      return "refused";
  }
  return "unknown";
}

const char * to_string(Refusal refusal)
{
  switch (refusal) {
    case Refusal::kNone:
      return "none";
    case Refusal::kZeroStamp:
      return "stamp is zero";
    case Refusal::kFuture:
      return "stamp is in the future";
    case Refusal::kOutOfOrder:
      return "out of order";
    case Refusal::kTooOld:
      return "too old";
    case Refusal::kNotFinite:
      return "not finite";
    case Refusal::kNegative:
      return "negative";
  }
  return "unknown";
}

const char * to_string(Source source)
{
  switch (source) {
    case Source::kRanges:
      return "ranges";
    case Source::kContacts:
      return "contacts";
    case Source::kBlocks:
      return "blocks";
    case Source::kGyro:
      return "gyro";
    case Source::kOdometry:
      return "odometry";
    case Source::kSideLeft:
      return "side_left";
    case Source::kSideRight:
      return "side_right";
    case Source::kFrontPair:
      return "front_pair";
    case Source::kFrontLeft:
      return "front_left";
    case Source::kFrontRight:
      return "front_right";
    case Source::kBlock3Front:
      return "block3_front";
    case Source::kBumperLeft:
      return "bumper_left";
    case Source::kBumperRight:
      return "bumper_right";
    case Source::kRiserSwitches:
      return "riser_switches";
    case Source::kStandingGyro:
      return "gyro_at_rest";
    case Source::kWheelsAlong:
      return "wheels_along";
    case Source::kWheelsAcross:
      return "wheels_across";
    case Source::kCorrectionX:
      return "correction_x";
    case Source::kCorrectionY:
      return "correction_y";
    case Source::kCorrectionHeading:
      return "correction_heading";
  }
  return "unknown";
}

void SourceReport::note(Verdict verdict)
{
  outcome = verdict.outcome;
  switch (verdict.outcome) {
    case Outcome::kNone:
      break;
    case Outcome::kFused:
      ++fused;
      reject_streak = 0;
      break;
    case Outcome::kGated:
      ++gated;
      ++reject_streak;
      break;
    case Outcome::kStale:
      ++stale;
      break;
    case Outcome::kNotVisible:
      ++not_visible;
      reject_streak = 0;  // what is rejected after a gap is no sequel of what was before it
      break;
    case Outcome::kRefused:
      ++refused[static_cast<std::size_t>(verdict.refusal)];
      break;
  }
}

std::uint64_t SourceReport::refused_total() const
{
  return std::accumulate(refused.begin(), refused.end(), std::uint64_t{0});
}

}  // namespace stetro_localizer
