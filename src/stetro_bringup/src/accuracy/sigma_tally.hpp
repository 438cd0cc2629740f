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

#ifndef ACCURACY__SIGMA_TALLY_HPP_
#define ACCURACY__SIGMA_TALLY_HPP_

#include <cstdint>

namespace stetro_bringup
{

/// How errors compare with the standard deviation that was said of each.
class SigmaTally
{
public:
  /// What is not known, or has no doubt at all, does not count.
  void add(double error, double sigma);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double inside_95() const;    ///< share within 1.96 sigma; NaN without any
  [[nodiscard]] double mean_square() const;  ///< of error / sigma: 1 for an honest sigma

private:
  std::uint64_t count_ = 0;
  std::uint64_t inside_ = 0;
  double squares_ = 0.0;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__SIGMA_TALLY_HPP_
