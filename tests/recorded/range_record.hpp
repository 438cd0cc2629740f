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

#ifndef TESTS__RECORDED__RANGE_RECORD_HPP_
#define TESTS__RECORDED__RANGE_RECORD_HPP_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace recorded
{

/// Readings of a range sensor that looked at one place, and how far averaging calms them.
/**
 * For tests of several packages, hence no more than a header.
 *
 * Both measures are one standard deviation of means of n consecutive readings. deviation_of_means
 * is about the mean of the whole record: under a drift it grows with the length of the record.
 * allan_deviation compares each mean with the next (D. W. Allan, Statistics of atomic frequency
 * standards, Proceedings of the IEEE 54, 1966): the same for an hour as for a day, and also
 * defined for a random walk, which has no mean. For white noise both are sigma / sqrt(n).
 */
class RangeRecord
{
public:
  explicit RangeRecord(std::vector<double> readings_m) : readings_m_(std::move(readings_m))
  {
    mean_m_ = std::accumulate(readings_m_.begin(), readings_m_.end(), 0.0) /
              static_cast<double>(readings_m_.size());
    for (const double reading_m : readings_m_) {
      sums_.push_back(sums_.back() + (reading_m - mean_m_));
    }
  }

  /// Reads whole millimetres, one a line, after three lines of header.
  /**
   * \throws std::runtime_error when the file is missing or a line is not a number
   */
  static RangeRecord read(const std::string & path)
  {
    std::ifstream file(path);
    std::string line;
    for (int header = 0; header < 3; ++header) {
      std::getline(file, line);
    }
    std::vector<double> readings_m;
    double range_mm = 0.0;
    while (file >> range_mm) {
      readings_m.push_back(range_mm / 1000.0);
    }
    if (readings_m.empty() || !file.eof()) {
      throw std::runtime_error(
        path + ": no range after " + std::to_string(readings_m.size()) + " readings");
    }
    return RangeRecord(std::move(readings_m));
  }

  [[nodiscard]] std::size_t size() const { return readings_m_.size(); }
  [[nodiscard]] double mean_m() const { return mean_m_; }

  /// Of the means of all blocks of n readings, about the mean of the record [m].
  [[nodiscard]] double deviation_of_means_m(std::size_t n) const
  {
    const std::size_t blocks = size() / n;
    double sum_m = 0.0;
    double squares_m2 = 0.0;
    for (std::size_t block = 0; block < blocks; ++block) {
      const double mean_m = mean_of(block * n, n);
      sum_m += mean_m;
      squares_m2 += mean_m * mean_m;
    }
    const auto count = static_cast<double>(blocks);
    return std::sqrt((squares_m2 - sum_m * sum_m / count) / (count - 1.0));
  }

  /// Root of half the mean square between a mean of n readings and the next [m].
  /**
   * Blocks overlap, twenty starts to a block: that uses what little an hour holds of long means.
   */
  [[nodiscard]] double allan_deviation_m(std::size_t n) const
  {
    const std::size_t stride = std::max<std::size_t>(1, n / 20);
    double squares_m2 = 0.0;
    double count = 0.0;
    for (std::size_t first = 0; first + 2 * n <= size(); first += stride) {
      const double step_m = mean_of(first + n, n) - mean_of(first, n);
      squares_m2 += step_m * step_m;
      count += 1.0;
    }
    return std::sqrt(squares_m2 / count / 2.0);
  }

private:
  /// Less the mean of the record, which keeps the sums small.
  [[nodiscard]] double mean_of(std::size_t first, std::size_t n) const
  {
    return (sums_[first + n] - sums_[first]) / static_cast<double>(n);
  }

  std::vector<double> readings_m_;
  std::vector<double> sums_{0.0};  // of the first i readings
  double mean_m_ = 0.0;
};

/// An hour of one VL53L0X, recorded/vl53l0x_static/README.md.
inline const RangeRecord & vl53l0x()
{
  static const RangeRecord kRecord =
    RangeRecord::read(STETRO_RECORDED "/vl53l0x_static/static_tof_dist_data_1_h.csv");
  return kRecord;
}

constexpr double kVl53l0xInterval = 3600.0 / 200244;  ///< from reading to reading [s]

}  // namespace recorded

#endif  // TESTS__RECORDED__RANGE_RECORD_HPP_
