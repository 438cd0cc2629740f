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

#ifndef STETRO_LOCALIZER__RANGE_OFFSET_HPP_
#define STETRO_LOCALIZER__RANGE_OFFSET_HPP_

#include "stetro_localizer/scalar_estimate.hpp"

namespace stetro_localizer
{

/// Constant error of a range, or of a difference of ranges, and where it was found.
struct RangeOffset
{
  ScalarEstimate offset;         ///< b: reading less truth [m]
  double calibrated_at_m = 0.0;  ///< range at which it was found; 0 before any calibration [m]
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__RANGE_OFFSET_HPP_
