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
#include "stetro_supervisor/pose_reason.hpp"

#include <array>
#include <utility>

namespace stetro_supervisor
{
namespace
{

constexpr std::array<std::pair<PoseReason, const char *>, 18> kNames{
  {{kNoSideRange, "no side range"},
   {kNoFrontReference, "no front reference"},
   {kStepUncertain, "step uncertain"},
   {kNotInitialised, "not initialised"},
   {kInputSilent, "input silent"},
   {kCalibrationDamaged, "state file damaged"},
   {kClosureViolated, "closure violated"},
   {kSensorStuck, "sensor stuck"},
   {kSensorDead, "sensor dead"},
   {kProfileDisagrees, "profile disagrees"},
   {kProtectionExceeded, "protection exceeded"},
   {kClockJump, "clock jump"},
   {kContactConflict, "contact conflict"},
   {kSlip, "slip"},
   {kSensorCalibration, "sensor calibration beyond trust"},
   {kHeadingConflict, "heading conflict"},
   {kOffTread, "off the tread"},
   {kContactClosure, "contact closure too large"}}};

}  // namespace

std::string reasons_in_words(std::uint32_t reasons)
{
  std::string words;
  const auto add = [&words](const std::string & word) {
    words += words.empty() ? word : ", " + word;
  };
  for (const auto & [reason, name] : kNames) {
    if ((reasons & reason) != 0u) {
      add(name);
      reasons &= ~static_cast<std::uint32_t>(reason);
    }
  }
  if (reasons != 0u) {
    add("reason " + std::to_string(reasons) + " without a name");
  }
  return words.empty() ? "no reason given" : words;
}

}  // namespace stetro_supervisor
