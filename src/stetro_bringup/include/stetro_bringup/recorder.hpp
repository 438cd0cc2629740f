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
#ifndef STETRO_BRINGUP__RECORDER_HPP_
#define STETRO_BRINGUP__RECORDER_HPP_

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <string>

#include "stetro_bringup/trace.hpp"

namespace stetro_bringup
{

/// An estimate as it arrives, before its companions have been found.
struct Estimate
{
  StairSample sample;
  StairSigma sigma;
  std::string integrity;
  std::uint32_t reasons = 0;
  /// Undersides of blocks 1, 2, 3 in the flight frame [m]: they tell whether the robot stands.
  std::array<double, 3> block_heights_m{};
};

/// Joins what arrives on several topics into rows of one time.
/**
 * Topics overtake each other on their way, so an estimate waits until one that is 0.2 s younger has
 * arrived; by then its ranges, outcomes and truth, all of the same time, are there or lost. What is
 * missing stays empty in the row. Rows leave in order of time, so the trace of a repeatable run is
 * repeatable.
 *
 * Not thread-safe: it belongs to one executor.
 */
class Recorder
{
public:
  /// Is told each row, and whether the robot stood on all blocks, as it does while it sweeps.
  using Sink = std::function<void(const TraceRow & row, bool standing)>;

  explicit Recorder(Sink sink);

  void add_estimate(const Estimate & estimate);
  void add_truth(const StairSample & truth);
  void add_range(std::chrono::nanoseconds stamp, const std::string & sensor, double range_m);
  void add_outcome(
    std::chrono::nanoseconds stamp, const std::string & sensor, const std::string & outcome);

  /// Lets every waiting estimate go; nothing more will arrive.
  void flush();

private:
  using Time = std::chrono::nanoseconds;

  void release(Time until);
  [[nodiscard]] TraceRow joined(const Estimate & estimate) const;
  void forget(Time before);

  Sink sink_;
  std::map<Time, Estimate> waiting_;
  std::map<Time, StairSample> truths_;
  std::map<Time, std::map<std::string, SensorTrace>> sensors_;
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__RECORDER_HPP_
