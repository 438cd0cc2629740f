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

#ifndef STETRO_LOCALIZER__SAMPLE_FAULT_HPP_
#define STETRO_LOCALIZER__SAMPLE_FAULT_HPP_

#include <cmath>

#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/samples.hpp"

namespace stetro_localizer
{

/// What makes a sample unfit by its numbers alone; its stamp is another question.
[[nodiscard]] inline Refusal fault_of(const GyroSample & sample)
{
  const bool finite =
    std::isfinite(sample.rate_radps) && std::isfinite(sample.pitch_rad.value_or(0.0));
  return finite ? Refusal::kNone : Refusal::kNotFinite;
}

[[nodiscard]] inline Refusal fault_of(const OdometrySample & sample)
{
  const bool finite =
    std::isfinite(sample.vx_mps) && std::isfinite(sample.vy_mps) && std::isfinite(sample.wz_radps);
  return finite ? Refusal::kNone : Refusal::kNotFinite;
}

/// A reading that calls itself valid must be a distance.
[[nodiscard]] inline Refusal fault_of(const RangeReading & reading)
{
  if (reading.status != RangeStatus::kValid) {
    return Refusal::kNone;
  }
  if (!std::isfinite(reading.range_m)) {
    return Refusal::kNotFinite;
  }
  return reading.range_m < 0.0 ? Refusal::kNegative : Refusal::kNone;
}

/// A block that reports its own fault says nothing by its height.
[[nodiscard]] inline Refusal fault_of(const BlockSample & sample)
{
  for (const BlockReading & block : sample.blocks) {
    if (!block.fault && !std::isfinite(block.height_m)) {
      return Refusal::kNotFinite;
    }
    if (!block.fault && block.height_m < 0.0) {
      return Refusal::kNegative;
    }
  }
  return Refusal::kNone;
}

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SAMPLE_FAULT_HPP_
