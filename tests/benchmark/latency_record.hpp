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

#ifndef TESTS__BENCHMARK__LATENCY_RECORD_HPP_
#define TESTS__BENCHMARK__LATENCY_RECORD_HPP_

#include <chrono>
#include <cstddef>
#include <vector>

namespace bench
{

/// The latencies of one path, and their percentiles.
class LatencyRecord
{
public:
  void add(std::chrono::nanoseconds latency) { latencies_.push_back(latency); }
  void clear() { latencies_.clear(); }
  [[nodiscard]] std::size_t size() const { return latencies_.size(); }

  /// The smallest latency that `share` of all (0 to 1) do not exceed [us]; NaN without any.
  [[nodiscard]] double percentile_us(double share) const;

private:
  std::vector<std::chrono::nanoseconds> latencies_;
};

}  // namespace bench

#endif  // TESTS__BENCHMARK__LATENCY_RECORD_HPP_
