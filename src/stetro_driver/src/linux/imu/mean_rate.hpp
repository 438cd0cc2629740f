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

#ifndef LINUX__IMU__MEAN_RATE_HPP_
#define LINUX__IMU__MEAN_RATE_HPP_

#include <cstddef>
#include <optional>

#include "linux/imu/ned.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// What samples of the rate of turn come to from one look at them to the next.
/**
 * A sensor and a loop of 100 Hz each do not keep step: some cycles find two new samples, others
 * none. Who integrates the newest one over its stamp loses and doubles angles. With dt_n from the
 * sample before to sample n,
 *
 *   mean_n = mean_{n-1} + (rate_n - mean_{n-1}) dt_n / sum(dt)                            (1)
 *
 * over what is new, and its integral from stamp to stamp is that of all samples, whenever one
 * looks. In this form the mean of equal samples is that sample to the last bit, by which a stuck
 * sensor is known. Not thread safe.
 */
class MeanRate
{
public:
  struct Mean
  {
    Axes rate_rad_s{};
    std::size_t samples = 0;
  };

  /// \param lasted from the sample before to this one, above 0
  void add(const Axes & rate_rad_s, Time lasted)
  {
    lasted_ += lasted;
    const double share = time_to_seconds(lasted) / time_to_seconds(lasted_);
    for (std::size_t i = 0; i < rate_rad_s.size(); ++i) {
      mean_.rate_rad_s[i] += (rate_rad_s[i] - mean_.rate_rad_s[i]) * share;
    }
    ++mean_.samples;
  }

  /// (1) since it was last taken; nothing: no sample has come since.
  [[nodiscard]] std::optional<Mean> take()
  {
    const Mean mean = mean_;
    *this = {};
    return mean.samples > 0 ? std::optional{mean} : std::nullopt;
  }

private:
  Mean mean_{};
  Time lasted_{0};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__MEAN_RATE_HPP_
