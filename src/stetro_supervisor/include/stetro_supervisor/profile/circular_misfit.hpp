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

#ifndef STETRO_SUPERVISOR__PROFILE__CIRCULAR_MISFIT_HPP_
#define STETRO_SUPERVISOR__PROFILE__CIRCULAR_MISFIT_HPP_

#include <cstddef>
#include <vector>

namespace stetro_supervisor
{

/// How unlike the map's profile a scan of a full turn is, were it turned by `shift` beams.
/**
 * The mean of min(|r_i - m_(i + shift)|, cap), the index modulo n: the circular correlation of two
 * profiles with a difference that a single beam cannot dominate, where a product would let the
 * longest beams decide. Beams without an echo on either side count as the cap.
 */
[[nodiscard]] double circular_misfit(
  const std::vector<double> & scan_m, const std::vector<double> & model_m, std::size_t shift,
  double cap_m);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__PROFILE__CIRCULAR_MISFIT_HPP_
