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

#ifndef STETRO_LOCALIZER__STANDSTILL_HPP_
#define STETRO_LOCALIZER__STANDSTILL_HPP_

#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// What counts as standing still.
struct StandstillParams
{
  double speed_mps = 0.002;   ///< wheel speed below which the robot may stand [m/s]
  double rate_radps = 0.005;  ///< turn rate by the wheels below which it may stand [rad/s]
  double settle_s = 0.3;      ///< how long both must hold [s]
};

/// Tells from the wheels whether the robot stands still.
class Standstill
{
public:
  explicit Standstill(const StandstillParams & params) : params_(params) {}

  void note(const OdometrySample & sample);

  /// True once the wheels have stood for `settle_s`, by their last sample.
  [[nodiscard]] bool standing() const;

private:
  StandstillParams params_;
  Nanoseconds first_still_{0};  // zero while moving
  Nanoseconds last_{0};
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STANDSTILL_HPP_
