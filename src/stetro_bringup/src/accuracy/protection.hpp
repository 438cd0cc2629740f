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

#ifndef ACCURACY__PROTECTION_HPP_
#define ACCURACY__PROTECTION_HPP_

#include <type_traits>

#include "stetro_localizer/estimator.hpp"

namespace stetro_bringup
{

/// Bounds that the errors exceed no more often than the integrity risk allows; NaN: none is given.
struct Protection
{
  double along_m = stetro_localizer::kUnknown;
  double across_m = stetro_localizer::kUnknown;
  double heading_rad = stetro_localizer::kUnknown;
};

template <class Estimate, class = void>
struct ProtectionOf
{
  static Protection read(const Estimate &) { return {}; }
};

template <class Estimate>
struct ProtectionOf<Estimate, std::void_t<decltype(Estimate::protection_along_m)>>
{
  static Protection read(const Estimate & estimate)
  {
    return {
      estimate.protection_along_m, estimate.protection_across_m, estimate.protection_heading_rad};
  }
};

/// The protection levels of an estimate, if its type carries any.
[[nodiscard]] inline Protection protection_of(const stetro_localizer::StairEstimate & estimate)
{
  return ProtectionOf<stetro_localizer::StairEstimate>::read(estimate);
}

}  // namespace stetro_bringup

#endif  // ACCURACY__PROTECTION_HPP_
