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

#ifndef SIM__SIM_LIFTS_HPP_
#define SIM__SIM_LIFTS_HPP_

#include <array>
#include <cstdint>

#include "sim/fault_injector.hpp"
#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "stetro_driver/joint_command.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// What the lifts say of their blocks: heights, locks, loads, and the evidence of a touch-down.
class SimLifts
{
public:
  SimLifts(const SimErrors & errors, std::uint64_t seed);

  /// Where the upper locks are, beside the stroke.
  [[nodiscard]] const std::array<double, kBlocks> & lock_error_m() const { return lock_error_m_; }

  /// Watches the blocks for touch-downs that a fault hides or doubles.
  void observe(const SimBody & body, std::uint64_t tick, FaultInjector & faults);

  /// \param moved what each lift did in this tick
  [[nodiscard]] std::array<BlockReading, kBlocks> measure(
    const SimBody & body, const JointCommand & command, std::uint64_t tick,
    const std::array<bool, kBlocks> & moved) const;

  template <class Archive>
  void archive(Archive & each)
  {
    each(stood_, hidden_, doubled_from_tick_);
  }

private:
  [[nodiscard]] bool shows_standing(const SimBody & body, int block, std::uint64_t tick) const;

  std::array<double, kBlocks> lock_error_m_{};
  std::array<double, kBlocks> height_error_m_{};
  std::array<bool, kBlocks> stood_{true, true, true};
  std::array<bool, kBlocks> hidden_{};
  std::uint64_t doubled_from_tick_ = 0;  // zero: no touch-down is doubled
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_LIFTS_HPP_
