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

#ifndef STETRO_LOCALIZER__SCALAR_ESTIMATE_HPP_
#define STETRO_LOCALIZER__SCALAR_ESTIMATE_HPP_

namespace stetro_localizer
{

/// A slowly changing constant and how well it is known: a Kalman filter of one state.
struct ScalarEstimate
{
  double value = 0.0;
  double variance = 0.0;

  /// Takes one measurement of it, of the given variance.
  void update(double measured, double measured_variance)
  {
    const double gain = variance / (variance + measured_variance);
    value += gain * (measured - value);
    variance *= 1.0 - gain;
  }

  /// Lets it wander.
  void grow(double added_variance) { variance += added_variance; }
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__SCALAR_ESTIMATE_HPP_
