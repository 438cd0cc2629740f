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

#include "stetro_supervisor/profile/circular_misfit.hpp"

#include <cmath>

namespace stetro_supervisor
{

double circular_misfit(
  const std::vector<double> & scan_m, const std::vector<double> & model_m, std::size_t shift,
  double cap_m)
{
  const std::size_t n = scan_m.size();
  double sum = 0.0;
  const auto add = [&](std::size_t i, std::size_t j) {
    const double difference = std::abs(scan_m[i] - model_m[j]);
    sum += difference < cap_m ? difference : cap_m;  // the cap for what is not a number, too
  };
  for (std::size_t i = 0; i < n - shift; ++i) {
    add(i, i + shift);
  }
  for (std::size_t i = n - shift; i < n; ++i) {
    add(i, i + shift - n);  // the turn is over: on from the model's first beam
  }
  return sum / static_cast<double>(n);
}

}  // namespace stetro_supervisor
