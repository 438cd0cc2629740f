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

#ifndef ACCURACY__FAULT_WATCH_HPP_
#define ACCURACY__FAULT_WATCH_HPP_

#include <array>
#include <cstdint>
#include <optional>

#include "accuracy/fault_onset.hpp"
#include "accuracy/moment.hpp"

namespace stetro_bringup
{

/// What became of one injected fault.
struct Detection
{
  bool struck = false;            ///< the climb lasted until the onset
  bool never_ok = false;          ///< integrity was not OK when it struck, nor ever after
  bool detected = false;          ///< integrity left OK after the onset
  double time_s = 0.0;            ///< with integrity OK, from the onset until it left, or the end
  double motion_s = 0.0;          ///< the part of it in which the body moved
  double telling_motion_s = 0.0;  ///< the part in which it moved so that the sensor must tell
};

/// Times an injected fault from its onset to the estimator's noticing it.
/**
 * Only time under integrity OK counts: that is how long the estimator was believed. Where it was
 * not OK already when the fault struck, no alarm can be put down to the fault until it has been OK
 * again. If it never is, the fault has been neither noticed nor missed.
 */
class FaultWatch
{
public:
  explicit FaultWatch(const FaultOnset & onset) : onset_(onset) {}

  /// A tick of the loop, accepted or not.
  void watch(const Moment & now);

  [[nodiscard]] const Detection & detection() const { return detection_; }

private:
  void count(const Moment & now);
  void note_rise(const stetro_driver::GroundTruth & now);

  FaultOnset onset_;
  Detection detection_;
  bool was_ok_ = false;  ///< a tick ago
  std::uint64_t ticks_ = 0;
  std::uint64_t moving_ticks_ = 0;
  std::uint64_t telling_ticks_ = 0;
  std::optional<stetro_driver::GroundTruth> last_truth_;
  std::array<double, stetro_driver::kBlocks> rose_from_m_{};  ///< heights at rest, before a lift
};

}  // namespace stetro_bringup

#endif  // ACCURACY__FAULT_WATCH_HPP_
