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

#include "stetro_localizer/integrity.hpp"

#include <array>
#include <utility>

namespace stetro_localizer
{

const char * to_string(Integrity integrity)
{
  switch (integrity) {
    case Integrity::kOk:
      return "OK";
    case Integrity::kDegraded:
      return "DEGRADED";
    case Integrity::kLost:
      return "LOST";
  }
  return "unknown";
}

std::string reason_names(std::uint32_t reasons)
{
  constexpr std::array<std::pair<Reason, const char *>, 17> kNames{{
    {kNoSideRange, "no side range"},
    {kNoFrontReference, "no front reference"},
    {kStepUncertain, "step uncertain"},
    {kNotInitialised, "not initialised"},
    {kInputSilent, "input silent"},
    {kCalibrationDamaged, "state file damaged"},
    {kClosureViolated, "closure violated"},
    {kSensorStuck, "sensor stuck"},
    {kSensorDead, "sensor dead"},
    {kProfileDisagrees, "profile disagrees"},
    {kProtectionExceeded, "protection level exceeded"},
    {kContactConflict, "contact conflict"},
    {kSlip, "slip"},
    {kSensorCalibration, "sensor calibration beyond trust"},
    {kHeadingConflict, "heading conflict"},
    {kOffTread, "off the tread"},
    {kContactClosure, "contact closure too large"},
  }};
  std::string text;
  for (const auto & [reason, name] : kNames) {
    if (reasons & reason) {
      text += text.empty() ? name : std::string(", ") + name;
    }
  }
  return text;
}

}  // namespace stetro_localizer
