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

#ifndef SIM__SIM_RANGES_HPP_
#define SIM__SIM_RANGES_HPP_

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/fault_injector.hpp"
#include "sim/sim_tof.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::sim
{

/// The eight range sensors, their faults, and the way of their readings to the driver.
/** All measure on the same tick: at 30 Hz, to arrive two ticks later, or each tick, at once. */
class SimRanges
{
public:
  SimRanges(
    const BodyShape & shape, const SimErrors & errors, std::uint64_t seed, bool at_once = false);

  /// Measures when it is time to. \param tick counted from 1
  void observe(const SimBody & body, std::uint64_t tick, Time now, const FaultInjector & faults);

  /// What has arrived by now. \return true when a cycle has just arrived
  [[nodiscard]] bool deliver(
    std::uint64_t tick, Time now, const FaultInjector & faults,
    std::array<RangeReading, kRangePlaces> & readings) const;

  /// What block3_front says instead of measuring; nothing: it measures.
  void feign_block3_front(std::optional<double> range_m);

  [[nodiscard]] const SimTof & sensor(RangePlace place) const
  {
    return sensors_[static_cast<std::size_t>(place)];
  }

  template <class Archive>
  void archive(Archive & each)
  {
    random_.archive(each);
    for (SimTof & sensor : sensors_) {
      sensor.archive(each);
    }
    for (auto & history : history_) {
      for (RangeReading & reading : history) {
        each(reading.stamp, reading.range_m, reading.std_dev_m, reading.status);
      }
    }
    each(newest_, feigned_m_);
  }

private:
  static constexpr std::size_t kRemembered = 24;  // 0.8 s

  [[nodiscard]] bool cycle_ends(std::uint64_t tick) const;
  [[nodiscard]] RangeReading corrupted(
    std::size_t place, RangeReading reading, const FaultInjector & faults);

  [[nodiscard]] RangeReading bent(
    RangeReading reading, std::string_view name, const FaultInjector & faults) const;

  bool at_once_;
  double minimum_m_;
  RandomStream random_;
  std::vector<SimTof> sensors_;
  std::array<std::array<RangeReading, kRemembered>, kRangePlaces> history_{};
  std::size_t newest_ = 0;
  double feigned_m_ = 0.0;  // zero: nothing is feigned
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_RANGES_HPP_
