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

#include "stetro_localizer/reset_cause.hpp"

namespace stetro_localizer
{

const char * to_string(ResetCause cause)
{
  switch (cause) {
    case ResetCause::kNone:
      return "none";
    case ResetCause::kRestarted:
      return "restarted from the stored state";
    case ResetCause::kTold:
      return "told by initialpose";
    case ResetCause::kLocatedAgain:
      return "located again, the step had been unknown or another";
    case ResetCause::kStepUndone:
      return "a counted step was taken back";
    case ResetCause::kAcrossAnew:
      return "y measured anew, it had contradicted its ranges";
    case ResetCause::kHeadingAnew:
      return "heading measured anew, it had contradicted its ranges";
    case ResetCause::kCorrected:
      return "located by two corrections that agree";
  }
  return "unknown";
}

}  // namespace stetro_localizer
