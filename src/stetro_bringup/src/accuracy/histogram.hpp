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

#ifndef ACCURACY__HISTOGRAM_HPP_
#define ACCURACY__HISTOGRAM_HPP_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stetro_bringup
{

/// Counts signed errors in classes of equal width about zero.
/** What lies outside is in the outermost ones. */
class Histogram
{
public:
  /// \param half_range of the classes, to either side of zero \param bins of the whole range
  Histogram(double half_range, std::size_t bins)
  : half_range_(half_range), width_(2.0 * half_range / static_cast<double>(bins)), counts_(bins, 0)
  {
  }

  void add(double error)
  {
    const double place = std::clamp((error + half_range_) / width_, 0.0, last());
    ++counts_[static_cast<std::size_t>(place)];
    ++total_;
  }

  [[nodiscard]] std::size_t bins() const { return counts_.size(); }
  [[nodiscard]] double centre(std::size_t bin) const
  {
    return (static_cast<double>(bin) + 0.5) * width_ - half_range_;
  }
  /// Share of all errors in a class; 0 before the first.
  [[nodiscard]] double share(std::size_t bin) const
  {
    return total_ == 0 ? 0.0 : static_cast<double>(counts_[bin]) / static_cast<double>(total_);
  }

private:
  [[nodiscard]] double last() const { return static_cast<double>(counts_.size()) - 0.5; }

  double half_range_;
  double width_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t total_ = 0;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__HISTOGRAM_HPP_
